// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vdamf/tracking/association/auction.h"

namespace vdamf
{
/// At rest, heading along x.
inline PredictedTarget predictedCar(double x, double y, double sigma = 0.2)
{
    return {{x, y, 0.0, 4.5, 1.8}, {sigma, sigma}, 0.1, 0.1, Eigen::Vector2d::Zero()};
}

}  // namespace vdamf
