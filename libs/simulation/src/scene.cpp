// SPDX-License-Identifier: BSD-3-Clause
// The simulated world.
#include "vdamf/simulation/scene.h"

#include <cmath>

namespace vdamf
{
OrientedBox boxAt(const SceneObject& object, double time)
{
    const MotionState state = object.trajectory.at(time);
    return {state.x + object.rearAxleOffset * std::cos(state.heading),
            state.y + object.rearAxleOffset * std::sin(state.heading), wrapAngle(state.heading),
            object.size.length, object.size.width};
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
