// SPDX-License-Identifier: BSD-3-Clause
// How well hypotheses of a vehicle foretold a measurement of it.
#pragma once

#include <vector>

#include "vdamf/tracking/estimation/box_measurement.h"

namespace vdamf
{
struct Surprise
{
    double nis = 0.0;
    double logVolume = 0.0;  ///< of the innovation's covariance
};

Surprise surpriseOf(const PlacedPoint& foretold, const PlacedPoint& measured);

/// Likelihoods of a measurement by hypotheses, relative to the best one. What surprises all of them
/// says little: it counts for as much less as it lies outside the gate of the nearest one.
std::vector<double> likelihoods(const std::vector<Surprise>& foretold, double gate);

}  // namespace vdamf
