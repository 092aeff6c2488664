// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/filter_objective.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "vdamf/learning/clusters/case_summary.h"

namespace vdamf
{
namespace
{
using Error = std::optional<double>;
constexpr std::size_t kKinds = 6;
// Scales are no smaller, deg and m: what is better than this is good enough.
constexpr std::array<double, kKinds> kLeastScale = {0.05, 0.005, 0.005, 0.005, 0.01, 0.01};
constexpr double kMostNees = 9.0;     // of one cluster, over its dimension
constexpr double kCalibration = 0.3;  // weight

std::array<Error, kKinds> kindsOf(const CaseErrors& e)
{
    return {Error(e.heading90), Error(e.corner), e.end, e.side, e.length, e.width};
}

std::vector<double> scalesOf(const std::vector<CaseErrors>& errors)
{
    std::vector<double> scales;
    for (std::size_t k = 0; k < kKinds; ++k)
    {
        std::vector<double> sizes;
        for (const CaseErrors& one : errors)
            if (const Error error = kindsOf(one)[k]) sizes.push_back(std::abs(*error));
        scales.push_back(sizes.empty() ? 1.0 : std::max(kLeastScale[k], quantile(sizes, 0.5)));
    }
    return scales;
}
}  // namespace

Estimate estimateFrom(const Hits& hits, const LabelledCluster& cluster,
                      const MeasureOptions& options)
{
    const Measurement m =
        measureTarget(hits, cluster.sensor, cluster.start, toldOptions(options, cluster));
    return {m.box, m};
}

FilterObjective::FilterObjective(std::vector<LabelledClusters> conditions,
                                 const MeasureOptions& reference)
    : reference_(reference)
{
    for (LabelledClusters& condition : conditions)
    {
        if (condition.samples.empty()) continue;
        Prepared prepared;
        prepared.clusters = std::move(condition);
        for (const LabelledCluster& cluster : prepared.clusters.samples)
            prepared.hits.push_back(projectHits(cluster.cluster, reference.mergeCell));
        prepared.scales = scalesOf(errorsOn(prepared, reference));
        conditions_.push_back(std::move(prepared));
    }
    if (conditions_.empty()) throw std::runtime_error("no labelled clusters to learn from");
}

double FilterObjective::operator()(const FilterParameters& parameters) const
{
    const MeasureOptions options = withFilter(reference_, parameters);
    double sum = 0.0;
    for (const Prepared& condition : conditions_)
        sum += lossOf(errorsOn(condition, options), condition.scales);
    return sum / static_cast<double>(conditions_.size());
}

std::size_t FilterObjective::clusters() const
{
    std::size_t count = 0;
    for (const Prepared& condition : conditions_) count += condition.hits.size();
    return count;
}

std::vector<CaseErrors> FilterObjective::errorsOn(const Prepared& condition,
                                                  const MeasureOptions& options) const
{
    std::vector<CaseErrors> errors;
    errors.reserve(condition.hits.size());
    for (std::size_t i = 0; i < condition.hits.size(); ++i)
    {
        const LabelledCluster& cluster = condition.clusters.samples[i];
        errors.push_back(errorsOf(estimateFrom(condition.hits[i], cluster, options), cluster));
    }
    return errors;
}

double FilterObjective::lossOf(const std::vector<CaseErrors>& errors,
                               const std::vector<double>& scales)
{
    std::array<double, kKinds> sum{};
    std::array<double, kKinds> count{};
    double nees = 0.0;
    double withNees = 0.0;
    for (const CaseErrors& one : errors)
    {
        const auto kinds = kindsOf(one);
        for (std::size_t k = 0; k < kKinds; ++k)
        {
            if (!kinds[k]) continue;
            const double ratio = *kinds[k] / scales[k];
            sum[k] += 0.5 * std::log1p(ratio * ratio);
            count[k] += 1.0;
        }
        if (!one.nees) continue;
        nees += std::min(kMostNees, *one.nees / one.neesDimension);
        withNees += 1.0;
    }
    double loss = 0.0;
    double there = 0.0;
    for (std::size_t k = 0; k < kKinds; ++k)
    {
        if (count[k] == 0.0) continue;
        loss += sum[k] / count[k];
        there += 1.0;
    }
    loss /= there;
    if (withNees == 0.0) return loss;
    const double off = std::log(std::max(1e-3, nees / withNees));
    return loss + kCalibration * off * off;
}

}  // namespace vdamf
