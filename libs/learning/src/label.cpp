// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/label.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "vdamf/evaluation/box_overlap.h"

namespace vdamf
{
namespace
{
bool holdsCentreOf(const OrientedBox& box, const OrientedBox& other)
{
    const Eigen::Vector2d at = toBoxFrame(box, other.centre()).cwiseAbs();
    return at.x() <= 0.5 * box.length && at.y() <= 0.5 * box.width;
}

LabelledRow labelOf(const ScoredFrame& frame, const TrackRow& track)
{
    constexpr double kOn = 0.3;
    constexpr double kTouching = 0.02;
    const OrientedBox& box = track.report.box;
    LabelledRow row = {track.time, track.report.id, ObjectLabel::Clutter, {}};
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        const TruthRow& object = frame.truth[i];
        const double overlap = birdsEyeIou(object.box, box);
        const bool isOn = overlap >= kOn || holdsCentreOf(object.box, box);
        if (!isOn && overlap < kTouching) continue;
        if (!isVehicleClass(object.objectClass))
        {
            if (isOn && row.object.empty()) row.object = object.objectId;
            continue;
        }
        row.object = object.objectId;
        row.label = isOn && frame.counts[i] ? ObjectLabel::Vehicle : ObjectLabel::Unknown;
        if (row.label == ObjectLabel::Vehicle) break;
    }
    return row;
}
/// Labels by track, by time.
using RowsOfTracks = std::map<std::uint64_t, std::vector<LabelledRow>>;

bool isLimited(const ScoringOptions& options)
{
    return options.regionFov > 0.0 || options.maxRange > 0.0;
}

/// By time, the tracks in the region where all vehicles are labelled.
std::set<std::pair<double, std::uint64_t>> tracksInRegion(const std::vector<TruthRow>& truth,
                                                          const std::vector<TrackRow>& tracks,
                                                          const ScoringOptions& options)
{
    std::set<std::pair<double, std::uint64_t>> inside;
    for (const ScoredFrame& frame : makeSequence(truth, tracks, options).frames)
        for (const TrackRow& track : frame.tracks) inside.emplace(track.time, track.report.id);
    return inside;
}

/// What stands where it was labelled is still the same.
ObjectLabel rememberedLabel(const std::optional<LabelledRow>& last, const OrientedBox& lastBox,
                            const OrientedBox& box)
{
    constexpr double kStands = 0.5;  // m
    if (!last || (lastBox.centre() - box.centre()).norm() > kStands) return ObjectLabel::Unknown;
    return last->label;
}

/// Partial labels leave out vehicles that are hidden or cut off by the camera's border: what is on
/// a vehicle at any time is clutter at none.
void withdrawClutterOfVehicles(RowsOfTracks& rows)
{
    for (auto& [id, track] : rows)
    {
        const bool onVehicle =
            std::any_of(track.begin(), track.end(),
                        [](const LabelledRow& r) { return r.label == ObjectLabel::Vehicle; });
        if (!onVehicle) continue;
        for (LabelledRow& row : track)
            if (row.label == ObjectLabel::Clutter) row.label = ObjectLabel::Unknown;
    }
}

RowsOfTracks partlyLabelled(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                            const ScoringOptions& options)
{
    const auto inside = tracksInRegion(truth, tracks, options);
    ScoringOptions everywhere = options;
    everywhere.regionFov = 0.0;
    RowsOfTracks rows;
    std::map<std::uint64_t, std::pair<std::optional<LabelledRow>, OrientedBox>> last;
    for (const ScoredFrame& frame : makeSequence(truth, tracks, everywhere).frames)
    {
        for (const TrackRow& track : frame.tracks)
        {
            LabelledRow row = labelOf(frame, track);
            auto& [known, box] = last[track.report.id];
            const bool isTold = row.label == ObjectLabel::Vehicle ||
                                (!frame.truth.empty() && inside.count({track.time, row.track}) > 0);
            if (isTold)
            {
                known = row;
                box = track.report.box;
            }
            else if (row.label == ObjectLabel::Clutter)
            {
                row.label = rememberedLabel(known, box, track.report.box);
                if (row.label == ObjectLabel::Vehicle) row.object = known->object;
            }
            rows[row.track].push_back(std::move(row));
        }
    }
    withdrawClutterOfVehicles(rows);
    return rows;
}
}  // namespace

std::vector<LabelledRow> labelTracks(const std::vector<TruthRow>& truth,
                                     const std::vector<TrackRow>& tracks,
                                     const ScoringOptions& options)
{
    std::vector<LabelledRow> rows;
    if (isLimited(options))
    {
        for (auto& [id, track] : partlyLabelled(truth, tracks, options))
            std::move(track.begin(), track.end(), std::back_inserter(rows));
        return rows;
    }
    for (const ScoredFrame& frame : makeSequence(truth, tracks, options).frames)
    {
        if (frame.truth.empty()) continue;
        for (const TrackRow& track : frame.tracks) rows.push_back(labelOf(frame, track));
    }
    return rows;
}

}  // namespace vdamf
