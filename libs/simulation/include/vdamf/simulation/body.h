// SPDX-License-Identifier: BSD-3-Clause
// The bodies of simulated objects: vehicles with a profile, and what else stands by a road.
#pragma once

#include <optional>
#include <vector>

#include "vdamf/simulation/object_class.h"
#include "vdamf/simulation/random_stream.h"
#include "vdamf/simulation/shapes.h"

namespace vdamf
{
/// Leaves: a ray that enters travels an exponentially distributed way before it hits one.
struct Foliage
{
    Ellipsoid volume;
    double meanFreePath = 0.3;  ///< m
};

/// An object in its own frame: x to the front, y left, z up, origin under the centre of its box.
/// No part reaches beyond the box, and the widest layer of a vehicle touches all four sides.
struct Body
{
    std::vector<ConvexSolid> solids;
    std::vector<UprightCylinder> cylinders;
    std::vector<Wheel> wheels;
    std::vector<Foliage> foliage;
    double radius = 0.0;  ///< of the upright cylinder around the origin that holds it, m
    double height = 0.0;  ///< of its top, m
};

/// Throws std::runtime_error where the size is below leastSizeOf() or not positive.
Body makeBody(ObjectClass objectClass, const BodySize& size);

/// What a ray in the body's frame meets first. `random` is drawn from for foliage only.
std::optional<SurfaceHit> firstHit(const Body& body, const Ray& ray, RandomStream& random);

}  // namespace vdamf
