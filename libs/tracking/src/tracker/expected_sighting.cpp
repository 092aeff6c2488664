// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/expected_sighting.h"

#include "tracker/faceless.h"
#include "tracker/one_time.h"

namespace vdamf
{
Sighting expectedSighting(const Track& track, const SegmentedFrame& frame,
                          const std::vector<std::size_t>& clusters, const MeasureOptions& options,
                          const Attention& attention, const MotionOptions& motion)
{
    TargetMotion moves = motionOf(track.state);
    moves.changes = track.hypotheses->drivingProbability.front();
    const HitsAtOneTime seen = hitsAtOneTime(frame, clusters, moves, options.mergeCell);
    const OrientedBox start = stateAt(track.state, seen.lag, motion).box();
    const Eigen::Vector2d known(start.length, start.width);
    Sighting sighting = sightingOf(frame, clusters, seen, start, known, options, attention);
    if (track.isFaceless)
        sighting.around = bodyAround(rectangleAround(*seen.hits, start.heading), frame.sensor);
    return sighting;
}

}  // namespace vdamf
