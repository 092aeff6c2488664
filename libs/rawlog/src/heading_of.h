// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace vdamf
{
/// Of a direction in the world, from x to y, rad.
inline double headingOf(const Eigen::Vector3d& direction)
{
    return std::atan2(direction.y(), direction.x());
}

}  // namespace vdamf
