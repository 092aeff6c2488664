// SPDX-License-Identifier: BSD-3-Clause
// State of a tracked vehicle with its covariance: motion and size.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
using StateVector = Eigen::Matrix<double, 7, 1>;
using StateMatrix = Eigen::Matrix<double, 7, 7>;

/// What the rows 3 to 5 of a state stand for.
enum class Steering
{
    VariableAxis,  ///< speed, curvature, axis offset: the vehicle follows its steered wheels
    Turning,       ///< the same rows: it hardly changes its speed
    Steady,        ///< the same rows: it hardly changes speed and curvature
    Independent    ///< velocity by x and by y, yaw rate: moves and turns as it likes
};

/// Rows of the state vector.
enum StateRow
{
    kX = 0,          ///< box centre, world, m
    kY = 1,          ///< box centre, world, m
    kHeading = 2,    ///< rad
    kSpeed = 3,      ///< of the axis point along the heading, negative in reverse, m/s
    kCurvature = 4,  ///< of the axis point's path, positive to the left, 1/m
    kAxis = 5,       ///< offset d: the axis point lies d behind the centre, m
    kLength = 6,     ///< m
    // Of Steering::Independent instead:
    kVelocityX = 3,  ///< of the centre, world, m/s
    kVelocityY = 4,  ///< of the centre, world, m/s
    kYawRate = 5     ///< rad/s
};

/// A Gaussian over the state. The length is part of it because centre and length err together:
/// where only the rear is seen, the centre is as uncertain as half the length. The width, which is
/// known better, stands beside it.
struct VehicleState
{
    StateVector mean = StateVector::Zero();
    StateMatrix covariance = StateMatrix::Zero();

    double width = 0.0;          ///< m
    double widthVariance = 0.0;  ///< m^2

    Steering steering = Steering::VariableAxis;

    /// Of what follows its wheels, rad/s.
    double yawRate() const { return mean(kSpeed) * mean(kCurvature); }
    /// The same, m/s.
    double speedSigma() const { return std::sqrt(covariance(kSpeed, kSpeed)); }
    /// Of the place of the face at an end of an axis (kFaceAt), along the axis, m. The length errs
    /// with the centre, the width apart from it.
    double faceSigma(int axis, int end) const
    {
        const Eigen::Vector2d along = rotation(mean(kHeading)).col(axis);
        const double centre = along.dot(covariance.topLeftCorner<2, 2>() * along);
        const double withLength = along.dot(covariance.block<2, 1>(kX, kLength));
        const double both = axis == 0 ? signOfEnd(end) * withLength : 0.0;
        return std::sqrt(std::max(0.0, centre + both + 0.25 * sizeVariance()(axis)));
    }

    Eigen::Vector2d size() const { return {mean(kLength), width}; }
    Eigen::Vector2d sizeVariance() const { return {covariance(kLength, kLength), widthVariance}; }
    OrientedBox box() const { return {mean(kX), mean(kY), mean(kHeading), mean(kLength), width}; }
};

}  // namespace vdamf
