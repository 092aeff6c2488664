// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/type_filters.h"

#include <algorithm>

#include "vdamf/tracking/matched_filter/type_choice.h"

namespace vdamf
{
namespace
{
constexpr double kTypeMemory = 0.9;  // of a frame, a frame later
constexpr double kFrames = 3.0;      // that all count for
}  // namespace

TypeFilters::TypeFilters(const MeasureOptions& options) : common_(options)
{
    if (!options.bank || options.bank->filters.size() < 2) return;
    for (const TypedFilter& filter : options.bank->filters)
        ofType_.push_back(withFilter(options, filter.parameters));
}

const MeasureOptions& TypeFilters::optionsFor(const Track& track) const
{
    if (ofType_.empty() || !track.type) return common_;
    for (std::size_t k = 0; k < ofType_.size(); ++k)
        if (common_.bank->filters[k].type == track.type->type) return ofType_[k];
    return common_;
}

Track TypeFilters::judged(Track track, const Sighting& sighting) const
{
    if (ofType_.empty()) return track;
    const FilterBank& bank = *common_.bank;
    const std::vector<double> now = typeLogLikelihoods(sighting.measurement, sighting.height, bank);
    const double gain = track.typeEvidence.empty() ? 1.0 : kFrames * (1.0 - kTypeMemory);
    const double memory = track.typeEvidence.empty() ? 0.0 : kTypeMemory;
    track.typeEvidence.resize(now.size(), 0.0);
    for (std::size_t k = 0; k < now.size(); ++k)
        track.typeEvidence[k] = memory * track.typeEvidence[k] + gain * now[k];
    const std::vector<double> probabilities = typeProbabilities(track.typeEvidence, bank);
    const auto best = std::max_element(probabilities.begin(), probabilities.end());
    if (*best > 0.0)
        track.type = TypeProbability{
            bank.filters[static_cast<std::size_t>(best - probabilities.begin())].type, *best};
    return track;
}

}  // namespace vdamf
