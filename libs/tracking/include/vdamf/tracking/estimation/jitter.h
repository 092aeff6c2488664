// SPDX-License-Identifier: BSD-3-Clause
// How much of the error of a measured box is new in every frame.
//
// Fits to the same body from about the same side err alike: their error lasts, and frames do not
// average it out. A filter that takes all of it for white noise follows late and foretells with too
// much caution; one that leaves the lasting part out is sure of what it cannot know. So the error
// is split: its jitter goes into the filter, the rest beside it.
#pragma once

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

namespace vdamf
{
/// Shares of jitter in the variances of a track's measurements: of its fixed point along and across
/// the vehicle, and of its heading. By how well the track foretold them; 1 until that shows less.
class JitterShares
{
public:
    const Eigen::Vector3d& values() const { return shares_; }

    /// After a measurement that was foretold as `predicted` (at the measurement's own time), `dt`
    /// seconds after the one before.
    JitterShares after(const VehicleState& predicted, const BoxMeasurement& measurement,
                       double dt) const;

private:
    Eigen::Vector3d shares_ = Eigen::Vector3d::Ones();
};

/// Variance (m^2 or rad^2) of an error that lasts, of the fixed point along (0) and across (1) and
/// of the heading (2), at most: 5 cm, 0.35 degrees. Where a fit itself says that it does not know,
/// as where a row of hits may go on, its error comes and goes with the view.
double mostLasting(Eigen::Index row);

/// The measurement with these shares of its variances, and with all of what is larger than errors
/// that last. Sizes keep theirs: whether they err with the frame or for long is not to be seen.
BoxMeasurement withJitterAlone(const BoxMeasurement& measurement, const JitterShares& shares);

/// What that leaves out: covariance of (x, y, heading) at the box's centre, m and rad.
Eigen::Matrix3d lastingError(const BoxMeasurement& measurement, const JitterShares& shares);

}  // namespace vdamf
