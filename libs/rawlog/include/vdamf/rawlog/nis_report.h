// SPDX-License-Identifier: BSD-3-Clause
// Does the tracker know how good it is? Told from the normalised innovations squared (NIS) of its
// updates, without truth.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "vdamf/evaluation/consistency.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
struct TrackNis
{
    std::uint64_t trackId = 0;
    Consistency nis;  ///< of its updates, 3 degrees of freedom
    Verdict verdict = Verdict::TooFew;
};

struct NisReport
{
    static constexpr std::size_t kMostWorst = 10;

    Consistency all;  ///< of the updates of all confirmed tracks
    /// How many tracks there are of each Verdict.
    std::array<std::uint64_t, 5> verdicts{};
    /// Tracks with as many updates as a verdict needs that are not consistent, at most kMostWorst:
    /// first those with a mean above 1, by falling mean, then the others, by rising mean.
    std::vector<TrackNis> worst;
    std::vector<TrackNis> tracks;  ///< by rising id, where rows are kept
};

/// Gathers the NIS of the updates of confirmed tracks: 8 bytes an update of a track that lives,
/// and 8 MB for all of them together: behind so many updates, `all` is told from every second one,
/// then from every fourth, and so on. Rows, if they are kept, are 100 bytes a track.
class NisCollector
{
public:
    enum class Rows
    {
        Keep,
        Drop
    };
    explicit NisCollector(Rows rows) : keepsRows_(rows == Rows::Keep) {}

    void add(const FrameResult& frame);
    NisReport report() const;

private:
    void addToAll(double nis);
    void addTo(NisReport& report, const TrackNis& track) const;

    bool keepsRows_;
    std::map<std::uint64_t, std::vector<double>> living_;  ///< by track
    NisReport ended_;                                      ///< of those that have ended
    std::vector<double> all_;
    std::uint64_t updates_ = 0;
    std::uint64_t stride_ = 1;  ///< of the updates that are in all_
};

/// too_few, consistent, overconfident, underconfident, heavy_tailed.
const char* verdictName(Verdict verdict);

/// Table with one row a track: track_id, updates, mean_nis_per_dof (1 is expected), lower_bound and
/// upper_bound (95 % band of this mean), within_95 (share of the updates), verdict.
std::string toCsv(const NisReport& report);

}  // namespace vdamf
