// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/label.h"

#include <cmath>

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
}  // namespace

std::vector<LabelledRow> labelTracks(const std::vector<TruthRow>& truth,
                                     const std::vector<TrackRow>& tracks,
                                     const ScoringOptions& options)
{
    std::vector<LabelledRow> rows;
    for (const ScoredFrame& frame : makeSequence(truth, tracks, options).frames)
    {
        if (frame.truth.empty()) continue;
        for (const TrackRow& track : frame.tracks) rows.push_back(labelOf(frame, track));
    }
    return rows;
}

}  // namespace vdamf
