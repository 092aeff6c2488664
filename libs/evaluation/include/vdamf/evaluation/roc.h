// SPDX-License-Identifier: BSD-3-Clause
// How well vehicle_probability tells vehicles from clutter: ROC and DET (section 5 of the paper,
// Fig. 11).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// One track in one frame.
struct ClassifierSample
{
    std::uint64_t trackId = 0;
    double score = 0.0;    ///< vehicle_probability, 0..1
    bool vehicle = false;  ///< what it is
};

/// The scored tracks that have a probability. A track is a vehicle where it lies on one: an overlap
/// of at least `minOverlap`, or its centre inside; also where another track lies there too. On an
/// object of another class, or on nothing, it is clutter. Tracks on vehicles that do not count (too
/// few hits) are left out. The sequence must not be made with ScoringOptions::onlyVehicles, which
/// cuts the curve.
std::vector<ClassifierSample> classifierSamples(const Sequence& sequence, double minOverlap);

/// Everything at or above the threshold is called a vehicle.
struct RocPoint
{
    double threshold = 0.0;
    double falsePositiveRate = 0.0;  ///< clutter that is called a vehicle
    double truePositiveRate = 0.0;   ///< vehicles that are; 1 - it: the miss rate of the DET
};

struct RocScores
{
    double areaUnderCurve = 0.0;
    double equalErrorRate = 0.0;  ///< false positive rate = miss rate, linear between points
    /// Least miss rate with a false positive rate of at most 1e-3 and 1e-2; nothing where there
    /// are too few samples of clutter for such a rate (less than 1000 and 100).
    std::optional<double> missRateAtOnePerMille;
    std::optional<double> missRateAtOnePercent;
};

/// Where the curve lies at a false positive rate: 95 % interval by bootstrap over tracks.
struct RocBandPoint
{
    double falsePositiveRate = 0.0;
    double low = 0.0;  ///< of the true positive rate
    double high = 0.0;
};

struct Roc
{
    std::size_t vehicleSamples = 0;
    std::size_t clutterSamples = 0;
    std::size_t tracks = 0;
    RocScores scores;
    RocScores low;  ///< 95 % interval by bootstrap over tracks: samples of one track are alike
    RocScores high;
    std::vector<RocPoint> curve;  ///< by falling threshold, from (0, 0) to (1, 1)
    /// By rising rate, from 1e-4 to 1 in even steps of its logarithm; empty without replicates.
    std::vector<RocBandPoint> band;
};

struct RocOptions
{
    int replicates = 500;  ///< of the bootstrap
    std::uint64_t seed = 1;
};

/// Nothing where there are not both vehicles and clutter. Deterministic.
std::optional<Roc> rocOf(const std::vector<ClassifierSample>& samples,
                         const RocOptions& options = {});

}  // namespace vdamf
