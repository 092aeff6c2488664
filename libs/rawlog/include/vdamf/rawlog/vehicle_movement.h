// SPDX-License-Identifier: BSD-3-Clause
// A step of the vehicle, as an action of a rawlog tells it.
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace vdamf
{
/// From one pose to the next.
struct VehicleMovement
{
    std::optional<double> time;  ///< at its end, s (UNIX); nothing: of the next observation
    Eigen::Isometry3d change = Eigen::Isometry3d::Identity();  ///< in the vehicle frame before it
};

}  // namespace vdamf
