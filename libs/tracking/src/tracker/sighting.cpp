// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/sighting.h"

#include <algorithm>

#include "vdamf/tracking/estimation/occlusion.h"

namespace vdamf
{
double heightOf(const Cluster& cluster)
{
    if (cluster.height.empty()) return 0.0;
    return *std::max_element(cluster.height.begin(), cluster.height.end());
}

Hits hitsOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters)
{
    Hits all;
    for (const std::size_t k : clusters) all = joined(all, frame.hits[k]);
    return all;
}

Sighting sightingOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                    const Hits& hits, const OrientedBox& start,
                    const std::optional<Eigen::Vector2d>& knownLengthWidth,
                    const MeasureOptions& options)
{
    const Eigen::Vector2d sensor = frame.sensorInFrame();
    Sighting s;
    s.time = frame.time;
    s.sensor = frame.sensor.head<2>();
    s.measurement = measureTarget(hits, sensor, start, options, knownLengthWidth);
    Measurement& m = s.measurement;
    m.hiddenEnds = hiddenEnds(m.box, m.facesSeen, sensor, frame.profile);
    m.box.x += frame.origin.x();
    m.box.y += frame.origin.y();

    double ground = 0.0;
    double count = 0.0;
    for (const std::size_t k : clusters)
    {
        const Cluster& cluster = frame.clusters[k];
        for (std::size_t i = 0; i < cluster.size(); ++i) ground += cluster.z[i] - cluster.height[i];
        count += static_cast<double>(cluster.size());
        s.height = std::max(s.height, heightOf(cluster));
    }
    s.groundZ = frame.origin.z() + (count > 0.0 ? ground / count : 0.0);
    return s;
}

}  // namespace vdamf
