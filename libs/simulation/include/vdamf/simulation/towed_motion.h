// SPDX-License-Identifier: BSD-3-Clause
// A trailer behind a vehicle: its axle follows the hitch as a tractrix.
#pragma once

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
struct TowBar
{
    double hitchBehindAxle = 0.0;  ///< from the towing vehicle's rear axle back to the hitch, m
    double hitchToAxle = 5.0;      ///< from the hitch back to the trailer's axle, above 0, m
};

/// The trailer's axle moves along the trailer's heading. It starts in line with the towing vehicle
/// at time 0 (and before) and is good for times to `end` in s; after that it stays in the angle
/// that it has. Between steps of 5 ms of a Runge-Kutta integration its heading is a cubic with the
/// right derivatives: error below 1e-8 rad.
Trajectory towed(const Trajectory& vehicle, const TowBar& bar, double end);

}  // namespace vdamf
