// SPDX-License-Identifier: BSD-3-Clause
// A measured box as the filter takes it, and how it sits with what was foretold.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/types/track.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// A measured box (x, y of the centre, heading, length, width) with its covariance: world, m and
/// rad. What it does not tell has a large variance.
struct BoxMeasurement
{
    Vector5d box = Vector5d::Zero();
    Matrix5d covariance = Matrix5d::Zero();
    /// The point of the box that it holds best: +-1 at the faces, 0 in the middle, along the length
    /// and the width.
    Eigen::Vector2d fixedPoint = Eigen::Vector2d::Zero();
    /// It holds this much later than the state that it is held against, s: a turning scanner sees
    /// each target at a time of its own.
    double lag = 0.0;
};

/// The measurement after another source's word on one of its sizes (row 3: length, 4: width). What
/// that tells of the heading turns the box about its fixed point.
BoxMeasurement withKnown(const BoxMeasurement& measurement, Eigen::Index row, double value,
                         double variance);

/// Where the fixed point of a measurement is, and the heading: world, m and rad.
struct PlacedPoint
{
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};
PlacedPoint foretoldPoint(const VehicleState& state, const Eigen::Vector2d& fixedPoint);
PlacedPoint measuredPoint(const BoxMeasurement& measurement);

/// How a measurement sits with a predicted state, judged by what it tells best: place of its fixed
/// point and heading, 3 degrees of freedom. The state is that at the measurement's own time.
struct Innovation
{
    Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< heading wrapped
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

    double nis() const;  ///< normalised innovation squared
};
Innovation innovationOf(const VehicleState& state, const BoxMeasurement& measurement);
Innovation innovationOf(const PlacedPoint& foretold, const PlacedPoint& measured);

}  // namespace vdamf
