// SPDX-License-Identifier: BSD-3-Clause
// Kinematic state of a tracked vehicle with its covariance.
#pragma once

#include <Eigen/Core>

namespace vdamf
{
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Rows of the state vector.
enum StateRow
{
    kX = 0,          ///< box centre, world, m
    kY = 1,          ///< box centre, world, m
    kHeading = 2,    ///< rad
    kSpeed = 3,      ///< of the axis point along the heading, negative in reverse, m/s
    kCurvature = 4,  ///< of the axis point's path, positive to the left, 1/m
    kAxis = 5        ///< offset d: the axis point lies d behind the centre, m
};

/// A Gaussian over the state.
struct VehicleState
{
    Vector6d mean = Vector6d::Zero();
    Matrix6d covariance = Matrix6d::Zero();

    double yawRate() const { return mean(kSpeed) * mean(kCurvature); }
};

}  // namespace vdamf
