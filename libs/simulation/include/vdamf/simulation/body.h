// SPDX-License-Identifier: BSD-3-Clause
// The bodies of simulated objects: vehicles with a profile, bushes, trees, poles, walls.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vdamf/simulation/random_stream.h"
#include "vdamf/simulation/shapes.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class ObjectClass
{
    Car,
    Van,
    Truck,
    Bush,
    Tree,
    Pole,
    Wall,
    Box
};

template <>
struct EnumNames<ObjectClass>
{
    static std::vector<std::pair<ObjectClass, const char*>> names()
    {
        return {{ObjectClass::Car, "car"},     {ObjectClass::Van, "van"},
                {ObjectClass::Truck, "truck"}, {ObjectClass::Bush, "bush"},
                {ObjectClass::Tree, "tree"},   {ObjectClass::Pole, "pole"},
                {ObjectClass::Wall, "wall"},   {ObjectClass::Box, "box"}};
    }
};

bool isVehicle(ObjectClass objectClass);

struct BodySize
{
    double length = 0.0;  ///< along the heading, m
    double width = 0.0;   ///< m
    double height = 0.0;  ///< m
};

/// A usual size of the class.
BodySize typicalSize(ObjectClass objectClass);

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
    std::vector<Foliage> foliage;
    double radius = 0.0;  ///< of the upright cylinder around the origin that holds it, m
    double height = 0.0;  ///< of its top, m
};

/// Throws std::runtime_error where a vehicle is too small for its profile (length 2 m, width
/// 1 m, height 1 m) or a size is not positive.
Body makeBody(ObjectClass objectClass, const BodySize& size);

/// What a ray in the body's frame meets first. `random` is drawn from for foliage only.
std::optional<SurfaceHit> firstHit(const Body& body, const Ray& ray, RandomStream& random);

}  // namespace vdamf
