// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/sighting.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/estimation/occlusion.h"

namespace vdamf
{
namespace
{
// A level scan line measures none; those of its hits are assumed.
Hits withoutHeights(Hits hits)
{
    hits.heights = 0;
    return hits;
}
}  // namespace

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

Eigen::Vector2d extentOf(const Hits& hits, double heading)
{
    Eigen::Vector2d extent = Eigen::Vector2d::Zero();
    const std::size_t outermost = hits.size() / 100;
    if (hits.size() == 0) return extent;
    const Eigen::Matrix2d axes = rotation(heading);
    std::vector<double> places(hits.size());
    for (int axis = 0; axis < 2; ++axis)
    {
        for (std::size_t i = 0; i < hits.size(); ++i)
            places[i] = axes(0, axis) * hits.x[i] + axes(1, axis) * hits.y[i];
        const auto low = places.begin() + static_cast<std::ptrdiff_t>(outermost);
        const auto high = places.end() - 1 - static_cast<std::ptrdiff_t>(outermost);
        std::nth_element(places.begin(), low, places.end());
        const double lowest = *low;
        std::nth_element(places.begin(), high, places.end());
        extent(axis) = *high - lowest;
    }
    return extent;
}

Measurement goingOnTowards(const Measurement& measurement, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d there = toBoxFrame(measurement.box, point);
    // Rows of hits run along the faces seen; what goes on is one of them.
    const bool alongLength =
        measurement.facesSeen.seesSide() &&
        (!measurement.facesSeen.seesEnd() || std::abs(there.x()) > std::abs(there.y()));
    Measurement m = measurement;
    if (alongLength)
        m.hiddenEnds.add(there.x() > 0.0 ? Face::Front : Face::Back);
    else
        m.hiddenEnds.add(there.y() > 0.0 ? Face::Left : Face::Right);
    return m;
}

Sighting sightingOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                    const HitsAtOneTime& seen, const OrientedBox& start,
                    const std::optional<Eigen::Vector2d>& knownLengthWidth,
                    const MeasureOptions& options)
{
    const Eigen::Vector2d& sensor = frame.sensor;
    Sighting s;
    s.time = frame.time;
    s.sensor = sensor;
    s.lag = seen.lag;
    s.clusters = clusters;
    s.measurement = measureTarget(frame.planar ? withoutHeights(seen.hits) : seen.hits, sensor,
                                  start, options, knownLengthWidth);
    Measurement& m = s.measurement;
    m.hiddenEnds = hiddenEnds(m.box, m.facesSeen, sensor, frame.profile);
    s.extent = extentOf(seen.hits, m.box.heading);
    if (seen.goesOn) m = goingOnTowards(m, *seen.goesOn);

    double ground = 0.0;
    double count = 0.0;
    for (const std::size_t k : clusters)
    {
        const Cluster& cluster = frame.clusters[k];
        for (std::size_t i = 0; i < cluster.size(); ++i) ground += cluster.z[i] - cluster.height[i];
        count += static_cast<double>(cluster.size());
        s.height = std::max(s.height, heightOf(cluster));
    }
    s.groundZ = count > 0.0 ? ground / count : 0.0;
    return s;
}

}  // namespace vdamf
