// SPDX-License-Identifier: BSD-3-Clause
#include "filters/compare_filters.h"

#include <algorithm>
#include <memory>

#include "vdamf/learning/filter_objective.h"
#include "vdamf/tracking/matched_filter/type_choice.h"

namespace vdamf
{
namespace
{
constexpr std::array<const char*, 3> kMethods = {"hand_set", "learned", "bank"};

Estimate chosenEstimate(const Hits& hits, const LabelledCluster& cluster,
                        const MeasureOptions& options)
{
    const std::vector<float>& heights = cluster.cluster.height;
    const double height = heights.empty() ? 0.0 : *std::max_element(heights.begin(), heights.end());
    const BankMeasurement m = measureWithBank(hits, height, cluster.sensor, cluster.start,
                                              toldOptions(options, cluster), std::nullopt);
    return {m.measurement.box, m.measurement};
}
}  // namespace

void FilterComparison::add(const std::vector<LabelledClusters>& conditions,
                           const MeasureOptions& handSet, const FilterBank& bank)
{
    MeasureOptions learned = withFilter(handSet, commonFilter(bank).parameters);
    learned.bank = std::make_shared<const FilterBank>(bank);
    for (const LabelledClusters& condition : conditions)
    {
        if (condition.samples.empty()) continue;
        Errors& errors = errorsOn(condition.name);
        for (const LabelledCluster& cluster : condition.samples)
        {
            const Hits hits = projectHits(cluster.cluster, handSet.mergeCell);
            errors.methods[0].push_back(errorsOf(estimateFrom(hits, cluster, handSet), cluster));
            errors.methods[1].push_back(errorsOf(estimateFrom(hits, cluster, learned), cluster));
            if (bank.filters.size() > 1)
                errors.methods[2].push_back(
                    errorsOf(chosenEstimate(hits, cluster, learned), cluster));
        }
    }
}

std::vector<HeldOutCondition> FilterComparison::summaries() const
{
    std::vector<HeldOutCondition> all;
    for (const Errors& condition : conditions_)
    {
        HeldOutCondition one{condition.name, {}};
        for (std::size_t k = 0; k < kMethods.size(); ++k)
        {
            if (condition.methods[k].empty()) continue;
            CaseSummary summary = summaryOf(condition.methods[k]);
            summary.condition = condition.name;
            summary.method = kMethods[k];
            one.methods.push_back(summary);
        }
        all.push_back(std::move(one));
    }
    return all;
}

FilterComparison::Errors& FilterComparison::errorsOn(const std::string& condition)
{
    const auto found = std::find_if(conditions_.begin(), conditions_.end(),
                                    [&](const Errors& one) { return one.name == condition; });
    if (found != conditions_.end()) return *found;
    conditions_.push_back({condition, {}});
    return conditions_.back();
}

std::vector<HeldOutCondition> comparedOn(const std::vector<LabelledClusters>& conditions,
                                         const MeasureOptions& handSet, const FilterBank& bank)
{
    FilterComparison comparison;
    comparison.add(conditions, handSet, bank);
    return comparison.summaries();
}

}  // namespace vdamf
