// SPDX-License-Identifier: BSD-3-Clause
// What stands does not turn: the heading that it showed where it was seen well holds where it is
// seen in part.
//
// Fits to the same part of a body err alike, so that a filter follows them from view to view, and
// forgets what an earlier one told better. Here each view counts once.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/estimation/view.h"
#include "vdamf/tracking/types/measurement.h"

namespace vdamf
{
struct ShownHeading
{
    double heading = 0.0;   ///< but for quarter turns, rad
    double variance = 1e9;  ///< rad^2; at first nothing is known
    View view;              ///< of the last measurement

    /// After a measurement from a view: it tells as much anew as that is another view.
    ShownHeading after(const Measurement& measurement, const View& now) const;
};

/// Of the same body when its axes are turned by quarters.
ShownHeading turned(ShownHeading shown, int quarters);

/// The measurement turned about its hits towards the heading that was shown before, as far as the
/// variances of both weigh; not where they contradict each other. Its covariance stays, as errors
/// last. `hits`: their middle, m.
Measurement turnedTowards(const ShownHeading& shown, const Measurement& measurement,
                          const Eigen::Vector2d& hits);

}  // namespace vdamf
