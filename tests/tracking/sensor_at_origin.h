// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace vdamf
{
inline const Eigen::Vector2d kSensor = Eigen::Vector2d::Zero();

}  // namespace vdamf
