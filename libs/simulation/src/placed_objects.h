// SPDX-License-Identifier: BSD-3-Clause
// Objects where they are at one instant, and which of them a ray can meet at all.
#pragma once

#include <vector>

#include "vdamf/simulation/scene.h"

namespace vdamf
{
struct PlacedObject
{
    const Body* body;        ///< null while the object does not exist
    Eigen::Vector3d origin;  ///< of the body's frame, scene frame, m
    Eigen::Matrix3d toBody;  ///< turns directions of the scene into the body's frame
    // The upright cylinder around the origin that holds the body.
    double radius;  ///< m
    double bottom;  ///< z in the scene, m
    double top;     ///< z in the scene, m
};

std::vector<PlacedObject> placedAt(const Scene& scene, double time);

/// The objects that the rays of one firing may meet: all within a thin wedge.
struct Fan
{
    std::vector<int> objects;
};

/// The wedge starts at `sensor` and reaches from `heading` over `width` rad to either side.
Fan fanOf(const std::vector<PlacedObject>& objects, const Eigen::Vector2d& sensor, double heading,
          double width);

/// False where the ray passes above or below the object's bounding cylinder.
bool mayHit(const PlacedObject& object, const Ray& ray);

Ray inBodyFrame(const PlacedObject& object, const Ray& ray);

}  // namespace vdamf
