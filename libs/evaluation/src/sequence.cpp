// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/sequence.h"

#include <algorithm>
#include <stdexcept>

#include "frame_rows.h"
#include "overlaps.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
bool hasRegion(const ScoringOptions& options)
{
    return options.maxRange > 0.0 || options.regionFov > 0.0;
}

bool isInRegion(const Eigen::Vector2d& centre, const std::optional<PlanePose>& sensor,
                const ScoringOptions& options)
{
    if (!hasRegion(options)) return true;
    const Eigen::Vector2d ray =
        rotation(-sensor->heading) * (centre - Eigen::Vector2d(sensor->x, sensor->y));
    if (options.maxRange > 0.0 && ray.norm() > options.maxRange) return false;
    const double bearing = std::abs(std::atan2(ray.y(), ray.x()));
    return !(options.regionFov > 0.0) || bearing <= 0.5 * options.regionFov;
}

bool doesCount(const TruthRow& row, const std::optional<PlanePose>& sensor,
               const ScoringOptions& options)
{
    const bool hasHits = row.points < 0 || row.points >= options.minPoints;
    const bool isAskedFor = std::find(options.classes.begin(), options.classes.end(),
                                      row.objectClass) != options.classes.end();
    return isAskedFor && hasHits && isInRegion(row.box.centre(), sensor, options);
}

bool isPublished(const TrackReport& report, const ScoringOptions& options)
{
    if (report.status == TrackStatus::Ended) return false;
    if (report.status == TrackStatus::Tentative && !options.withTentative) return false;
    return !options.onlyVehicles || isCalledVehicle(report).value_or(true);
}

bool overlapsWhatCounts(const ScoredFrame& frame, const OrientedBox& box, double minOverlap)
{
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        if (frame.counts[i] && reaches(birdsEyeIou(frame.truth[i].box, box), minOverlap))
        {
            return true;
        }
    }
    return false;
}

void checkSensor(const FrameRows& rows, const ScoringOptions& options)
{
    if (!hasRegion(options) || rows.sensor) return;
    throw std::runtime_error(
        "a range or a field of view needs the sensor's pose, and the truth has none at " +
        toFixedText(rows.time, 6) +
        " s: fill its columns sensor_x_m, sensor_y_m and sensor_heading_rad, or score all around");
}

ScoredFrame scoredFrame(FrameRows rows, const ScoringOptions& options)
{
    checkSensor(rows, options);
    ScoredFrame frame;
    frame.time = rows.time;
    frame.sensor = rows.sensor;
    frame.truth = std::move(rows.truth);
    for (const TruthRow& row : frame.truth)
    {
        frame.counts.push_back(doesCount(row, frame.sensor, options));
    }
    for (TrackRow& row : rows.tracks)
    {
        const OrientedBox& box = row.report.box;
        if (!isPublished(row.report, options)) continue;
        if (isInRegion(box.centre(), frame.sensor, options) ||
            overlapsWhatCounts(frame, box, options.overlap))
        {
            frame.tracks.push_back(std::move(row));
        }
    }
    return frame;
}
}  // namespace

Sequence makeSequence(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                      const ScoringOptions& options)
{
    Sequence sequence;
    for (FrameRows& rows : framesOf(truth, tracks, options.timeTolerance))
    {
        sequence.frames.push_back(scoredFrame(std::move(rows), options));
    }
    return sequence;
}

}  // namespace vdamf
