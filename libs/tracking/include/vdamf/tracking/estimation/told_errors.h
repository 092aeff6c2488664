// SPDX-License-Identifier: BSD-3-Clause
// How sure a track says that it is of its pose.
//
// The filter works with the errors that any body may have from any view. Of one body from one view
// frames show more: where they scatter less than that, its shape fits the box better too.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/estimation/box_measurement.h"
#include "vdamf/tracking/estimation/jitter.h"
#include "vdamf/tracking/estimation/visibility.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// Of the fixed point along and across the vehicle and of the heading, by the last measurement.
struct ToldErrors
{
    Eigen::Vector2d fixedPoint = Eigen::Vector2d::Zero();
    /// What the frames show of the variances that the filter takes for jitter, up to 1.
    Eigen::Vector3d ofFilters = Eigen::Vector3d::Ones();
    /// What no frames average out: covariance of (x, y, heading) at the box's centre, m and rad.
    Eigen::Matrix3d lasting = Eigen::Matrix3d::Zero();
    /// Variance of the length in a frame, as far as all frames have the same error, m^2.
    double repeatedLength = 0.0;
};

/// `repeats`: probability that the frames so far show the same hits again, so that all of the
/// heading's error (up to 1.5 degrees) and of a far end's lasts and none of it is seen. `before`:
/// of the frame before, for a far end that this one does not show.
ToldErrors toldErrors(const BoxMeasurement& measurement, const JitterShares& shares, double repeats,
                      const ToldErrors& before = {});

/// Variance of the length with those errors, m^2. Ends of buses and trams are tapered and out of
/// view, the more the longer they are.
double toldLengthVariance(const VehicleState& state, const ToldErrors& errors,
                          const VisibilityOptions& options);

/// Covariance of (x, y, heading, speed) with those errors.
Eigen::Matrix4d toldCovariance(const VehicleState& state, const ToldErrors& errors,
                               const VisibilityOptions& options);

}  // namespace vdamf
