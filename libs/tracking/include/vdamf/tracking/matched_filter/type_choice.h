// SPDX-License-Identifier: BSD-3-Clause
// Which filter of a bank serves a target.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
/// Log-likelihood of each of the bank's types (that for any vehicle: minus infinity) for a measured
/// box and the height of its highest hit above the ground (m; 0: unknown): sizes by their
/// covariance and by what is usual of the type, each as if it was seen in full but for that.
std::vector<double> typeLogLikelihoods(const Measurement& measurement, double height,
                                       const FilterBank& bank);

/// Probabilities from log-likelihoods and the types' shares of all vehicles.
std::vector<double> typeProbabilities(const std::vector<double>& logLikelihoods,
                                      const FilterBank& bank);

struct BankMeasurement
{
    Measurement measurement;            ///< by the filter of the most likely type
    std::vector<double> probabilities;  ///< of each filter's type
    std::size_t chosen = 0;             ///< which filter
};

/// Measures with the bank's common filter, then with that of the type that this speaks for.
/// options.bank is there.
BankMeasurement measureWithBank(const Hits& hits, double height, const Eigen::Vector2d& sensor,
                                const OrientedBox& start, const MeasureOptions& options,
                                const std::optional<Eigen::Vector2d>& knownLengthWidth);

}  // namespace vdamf
