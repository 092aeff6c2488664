// SPDX-License-Identifier: BSD-3-Clause
// The simulated world: the ground, a platform with LADARs, and moving objects.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "vdamf/simulation/body.h"
#include "vdamf/simulation/ground_pose.h"
#include "vdamf/simulation/terrain.h"
#include "vdamf/simulation/trajectory.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
struct SceneObject
{
    std::string name;
    ObjectClass objectClass = ObjectClass::Car;
    BodySize size;
    Body body;
    double rearAxleOffset = 0.0;                   ///< from the box centre back to the rear axle, m
    Trajectory trajectory;                         ///< of the rear axle
    double paint = reflectivity(Material::Paint);  ///< reflectivity of its paint, 0..1
    double appears = -std::numeric_limits<double>::infinity();  ///< scene time, s
    double vanishes = std::numeric_limits<double>::infinity();  ///< scene time, s
};

/// True from `appears` to `vanishes`, both included. Outside it is neither seen nor in the truth.
bool existsAt(const SceneObject& object, double time);

/// Scene frame: x east, y north, z up, origin where the scenario puts it; times from 0, s.
struct Scene
{
    /// Vehicle frame of the platform: origin on the ground under the middle of the rear axle, x
    /// forward, y left, z up. The platform has no body.
    Trajectory platform;
    std::vector<SceneObject> objects;
    Terrain terrain;
};

// Trajectories are those of the plane: speeds and ways are horizontal, on slopes too.

/// The vehicle frame of the platform at a time, standing on four wheels 2.7 m and 1.6 m apart.
GroundPose platformPoseAt(const Scene& scene, double time);

/// An object's own frame (body.h) at a time. What is higher than long stands upright on the point
/// below its middle; vehicles stand on their axles, all else on the corners of its box.
GroundPose objectPoseAt(const Scene& scene, const SceneObject& object, double time);

/// An object's box at a time, scene frame.
OrientedBox boxAt(const SceneObject& object, double time);

/// The start of a rear axle, from the centre and heading of the box at time 0.
MotionState startOf(const OrientedBox& box, double rearAxleOffset, double speed);

}  // namespace vdamf
