// SPDX-License-Identifier: BSD-3-Clause
// What an action says of the vehicle's movement, without MRPT's parser of actions.
#pragma once

#include <optional>
#include <string_view>

#include "vdamf/rawlog/vehicle_movement.h"

namespace vdamf
{
/// The first movement of an action or a collection of them (`bytes`: a whole object):
/// CActionRobotMovement2D from version 2 on, CActionRobotMovement3D. Of a 2D movement by odometry
/// it takes the increment, of others the mean of a Gaussian. The fields are walked through one by
/// one: MRPT's own parser would run its motion models on them, which may end the program where they
/// are corrupt. Nothing where there is no such movement, or one that cannot be.
std::optional<VehicleMovement> movementOf(std::string_view bytes);

}  // namespace vdamf
