// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/type_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vdamf
{
namespace
{
// The highest hit lies below the roof, by the gap between a sensor's beams.
constexpr double kHeightGap = 0.3;  // m
// What an end or a side behind something else may hide.
constexpr double kHiddenLength = 4.0;  // m
constexpr double kHiddenWidth = 1.0;   // m
// Outliers of one size count no more than this.
constexpr double kLeastLogLikelihood = -12.0;

double logNormal(double difference, double variance)
{
    return std::max(kLeastLogLikelihood, -0.5 * difference * difference / variance) -
           0.5 * std::log(variance);
}

double logLikelihood(const Measurement& m, double height, const TypeSizes& sizes)
{
    const auto squared = [](double v) { return v * v; };
    const double lengthHidden = m.hiddenEnds.seesEnd() ? kHiddenLength : 0.0;
    const double widthHidden = m.hiddenEnds.seesSide() ? kHiddenWidth : 0.0;
    double sum =
        logNormal(m.box.length - sizes.length, squared(sizes.lengthSigma) + squared(lengthHidden) +
                                                   std::max(0.0, m.covariance(3, 3))) +
        logNormal(m.box.width - sizes.width, squared(sizes.widthSigma) + squared(widthHidden) +
                                                 std::max(0.0, m.covariance(4, 4)));
    if (height > 0.0)
        sum += logNormal(height + 0.5 * kHeightGap - sizes.height,
                         squared(sizes.heightSigma) + squared(kHeightGap));
    return sum;
}
}  // namespace

std::vector<double> typeLogLikelihoods(const Measurement& measurement, double height,
                                       const FilterBank& bank)
{
    std::vector<double> all;
    for (const TypedFilter& filter : bank.filters)
        all.push_back(filter.type == VehicleType::Any
                          ? -std::numeric_limits<double>::infinity()
                          : logLikelihood(measurement, height, filter.sizes));
    return all;
}

std::vector<double> typeProbabilities(const std::vector<double>& logLikelihoods,
                                      const FilterBank& bank)
{
    std::vector<double> odds;
    for (std::size_t k = 0; k < logLikelihoods.size(); ++k)
        odds.push_back(logLikelihoods[k] + std::log(bank.filters[k].sizes.share));
    const double most = odds.empty() ? 0.0 : *std::max_element(odds.begin(), odds.end());
    // Of a bank without types nothing is likely.
    if (!std::isfinite(most)) return std::vector<double>(odds.size(), 0.0);
    double sum = 0.0;
    for (double& one : odds) sum += one = std::exp(one - most);
    for (double& one : odds) one /= sum;
    return odds;
}

BankMeasurement measureWithBank(const Hits& hits, double height, const Eigen::Vector2d& sensor,
                                const OrientedBox& start, const MeasureOptions& options,
                                const std::optional<Eigen::Vector2d>& knownLengthWidth)
{
    const FilterBank& bank = *options.bank;
    BankMeasurement result;
    result.measurement = measureTarget(hits, sensor, start, options, knownLengthWidth);
    result.probabilities =
        typeProbabilities(typeLogLikelihoods(result.measurement, height, bank), bank);
    const auto best = std::max_element(result.probabilities.begin(), result.probabilities.end());
    result.chosen = static_cast<std::size_t>(best - result.probabilities.begin());
    if (*best > 0.0)
        result.measurement = measureTarget(
            hits, sensor, start, withFilter(options, bank.filters[result.chosen].parameters),
            knownLengthWidth);
    return result;
}

}  // namespace vdamf
