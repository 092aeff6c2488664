// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/nis_report.h"

#include <algorithm>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr int kFreedom = 3;  // x, y, heading

// Errors larger than claimed mislead whoever uses the track; smaller ones only waste information.
bool isWorse(const TrackNis& a, const TrackNis& b)
{
    const bool aClaimsTooMuch = a.nis.mean > 1.0;
    const bool bClaimsTooMuch = b.nis.mean > 1.0;
    if (aClaimsTooMuch != bClaimsTooMuch) return aClaimsTooMuch;
    return aClaimsTooMuch ? a.nis.mean > b.nis.mean : a.nis.mean < b.nis.mean;
}

TrackNis rowFor(std::uint64_t id, const std::vector<double>& values)
{
    const Consistency nis = consistencyOf(values, kFreedom);
    return {id, nis, verdictOf(nis)};
}

std::string rowOf(const TrackNis& track)
{
    std::string row = std::to_string(track.trackId) + ',' + std::to_string(track.nis.count);
    for (const double value :
         {track.nis.mean, track.nis.lowerBound, track.nis.upperBound, track.nis.within95})
        row += ',' + toFixedText(value, 4);
    return row + ',' + verdictName(track.verdict) + '\n';
}
}  // namespace

void NisCollector::add(const FrameResult& frame)
{
    for (const TrackReport& track : frame.tracks)
    {
        if (track.nis && track.status == TrackStatus::Confirmed)
        {
            living_[track.id].push_back(*track.nis);
            addToAll(*track.nis);
        }
        const auto found = living_.find(track.id);
        if (track.status != TrackStatus::Ended || found == living_.end()) continue;
        addTo(ended_, rowFor(track.id, found->second));
        living_.erase(found);
    }
}

void NisCollector::addToAll(double nis)
{
    constexpr std::size_t kMost = 1 << 20;
    if (updates_++ % stride_ != 0) return;
    all_.push_back(nis);
    if (all_.size() < kMost) return;
    for (std::size_t i = 0; 2 * i < all_.size(); ++i) all_[i] = all_[2 * i];
    all_.resize(all_.size() / 2);
    stride_ *= 2;
}

void NisCollector::addTo(NisReport& report, const TrackNis& track) const
{
    ++report.verdicts[static_cast<std::size_t>(track.verdict)];
    if (keepsRows_) report.tracks.push_back(track);
    if (track.verdict == Verdict::TooFew || track.verdict == Verdict::Consistent) return;
    const auto place = std::upper_bound(report.worst.begin(), report.worst.end(), track, isWorse);
    report.worst.insert(place, track);
    if (report.worst.size() > NisReport::kMostWorst) report.worst.pop_back();
}

NisReport NisCollector::report() const
{
    NisReport report = ended_;
    report.all = consistencyOf(all_, kFreedom);
    for (const auto& [id, values] : living_) addTo(report, rowFor(id, values));
    std::sort(report.tracks.begin(), report.tracks.end(),
              [](const TrackNis& a, const TrackNis& b) { return a.trackId < b.trackId; });
    return report;
}

const char* verdictName(Verdict verdict)
{
    switch (verdict)
    {
        case Verdict::TooFew:
            return "too_few";
        case Verdict::Consistent:
            return "consistent";
        case Verdict::Overconfident:
            return "overconfident";
        case Verdict::Underconfident:
            return "underconfident";
        case Verdict::HeavyTailed:
            return "heavy_tailed";
    }
    return "";
}

std::string toCsv(const NisReport& report)
{
    std::string table =
        "track_id,updates,mean_nis_per_dof,lower_bound,upper_bound,within_95,verdict\n";
    for (const TrackNis& track : report.tracks) table += rowOf(track);
    return table;
}

}  // namespace vdamf
