// SPDX-License-Identifier: BSD-3-Clause
// The simulated world.
#include "vdamf/simulation/scene.h"

#include <cmath>

namespace vdamf
{
bool existsAt(const SceneObject& object, double time)
{
    // Label times and frame times are computed differently: a frame at the very end counts.
    constexpr double kRounding = 1e-6;
    return time >= object.appears - kRounding && time <= object.vanishes + kRounding;
}

OrientedBox boxAt(const SceneObject& object, double time)
{
    const MotionState state = object.trajectory.at(time);
    return {state.x + object.rearAxleOffset * std::cos(state.heading),
            state.y + object.rearAxleOffset * std::sin(state.heading), wrapAngle(state.heading),
            object.size.length, object.size.width};
}

GroundPose platformPoseAt(const Scene& scene, double time)
{
    constexpr Contacts kWheels{2.7, 0.0, 0.8};
    const MotionState state = scene.platform.at(time);
    return standOn(scene.terrain, {state.x, state.y}, state.heading, kWheels);
}

GroundPose objectPoseAt(const Scene& scene, const SceneObject& object, double time)
{
    const OrientedBox box = boxAt(object, time);
    Contacts contacts;
    if (object.size.height <= object.size.length)
    {
        constexpr double kAxleShare = 0.28;
        const double share = isVehicle(object.objectClass) ? kAxleShare : 0.5;
        contacts = {share * box.length, share * box.length, 0.5 * box.width};
    }
    return standOn(scene.terrain, box.centre(), box.heading, contacts);
}

MotionState startOf(const OrientedBox& box, double rearAxleOffset, double speed)
{
    MotionState state;
    state.x = box.x - rearAxleOffset * std::cos(box.heading);
    state.y = box.y - rearAxleOffset * std::sin(box.heading);
    state.heading = box.heading;
    state.speed = speed;
    return state;
}

}  // namespace vdamf
