// SPDX-License-Identifier: BSD-3-Clause
// The simulated world: flat ground at z = 0, a platform with a LADAR, and moving objects.
#pragma once

#include <string>
#include <vector>

#include "vdamf/simulation/body.h"
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
    double rearAxleOffset = 0.0;  ///< from the box centre back to the rear axle, m
    Trajectory trajectory;        ///< of the rear axle
};

/// Scene frame: x east, y north, z up, origin where the scenario puts it; times from 0, s.
struct Scene
{
    /// Vehicle frame of the platform: origin on the ground under the middle of the rear axle, x
    /// forward, y left, z up. The platform has no body.
    Trajectory platform;
    std::vector<SceneObject> objects;
};

/// An object's box at a time, scene frame.
OrientedBox boxAt(const SceneObject& object, double time);

/// The start of a rear axle, from the centre and heading of the box at time 0.
MotionState startOf(const OrientedBox& box, double rearAxleOffset, double speed);

}  // namespace vdamf
