// SPDX-License-Identifier: BSD-3-Clause
// How well hypotheses of a vehicle foretold a measurement of it.
#pragma once

#include <array>
#include <cstddef>

#include "vdamf/tracking/estimation/box_measurement.h"

namespace vdamf
{
struct Surprise
{
    double nis = 0.0;
    double logVolume = 0.0;  ///< of the innovation's covariance
};

Surprise surpriseOf(const PlacedPoint& foretold, const PlacedPoint& measured);

/// Of all hypotheses; few enough to need no memory of their own.
struct Surprises
{
    static constexpr std::size_t kMost = 5;
    std::array<Surprise, kMost> each;
    std::size_t size = 0;

    void add(const Surprise& surprise) { each[size++] = surprise; }
    Surprises first(std::size_t count) const { return {each, count}; }
};

/// Likelihoods of a measurement by hypotheses, relative to the best one. What surprises all of them
/// says little: it counts for as much less as it lies outside the gate of the nearest one.
std::array<double, Surprises::kMost> likelihoods(const Surprises& foretold, double gate);

}  // namespace vdamf
