// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/segmentation.h"

#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "vdamf/tracking/preprocessing/range_profile.h"

namespace vdamf
{
SegmentedFrame segmentedFrame(const LadarFrame& frame, const AboveGround& above,
                              const FieldOfView& view, ClusterOptions options)
{
    SegmentedFrame s;
    s.time = frame.time;
    s.sensor = (frame.sensor - frame.origin).head<2>();
    s.sensorZ = frame.sensor.z() - frame.origin.z();
    s.points = frame.points.size();
    s.planar = frame.planar;
    s.times = timeRangeOf(frame.points.time);
    s.pointsAboveGround = above.index.size();
    s.profile = rangeProfile(frame, above);
    // A level scan does not tell where it looks and hits nothing.
    if (!frame.planar) s.profile = withinView(std::move(s.profile), view);
    options.maxExtent = std::numeric_limits<double>::infinity();
    ClusteredHits hits = clusterHits(frame, above, options);
    s.clusters = std::move(hits.clusters);
    s.loose = std::move(hits.loose);
    return s;
}

SegmentedFrame withHits(SegmentedFrame frame, const MeasureOptions& options, WorkerPool& workers)
{
    frame.hits.resize(frame.clusters.size());
    workers.forEach(
        frame.clusters.size(), [&](std::size_t i, std::size_t)
        { frame.hits[i] = projected(frame.clusters[i], options.mergeCell, frame.planar); });
    return frame;
}

ClusteredHits clusteredAnew(Cluster hits, const SegmentedFrame& frame, ClusterOptions options)
{
    options.maxExtent = std::numeric_limits<double>::infinity();
    AboveGround above{std::vector<std::uint32_t>(hits.size()), std::move(hits.height)};
    std::iota(above.index.begin(), above.index.end(), 0U);
    LadarFrame alone;
    alone.sensor << frame.sensor, frame.sensorZ;
    alone.points = {
        std::move(hits.x), std::move(hits.y), std::move(hits.z), {}, std::move(hits.time)};
    return clusterHits(alone, above, options);
}

}  // namespace vdamf
