// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/one_time.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kSeamGap = 0.03;      // s; nothing else than the seam of revolutions takes longer
constexpr double kMostDistance = 0.3;  // m, by which parts that are put together may be misplaced
constexpr double kStill = 0.005;       // m, of motion that needs no correction

struct TimeSpan
{
    double first = 1e9;
    double last = -1e9;
    double length() const { return last - first; }
};

Cluster joinedClusters(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters)
{
    Cluster all;
    for (const std::size_t k : clusters)
    {
        const Cluster& c = frame.clusters[k];
        all.x.insert(all.x.end(), c.x.begin(), c.x.end());
        all.y.insert(all.y.end(), c.y.begin(), c.y.end());
        all.height.insert(all.height.end(), c.height.begin(), c.height.end());
        all.time.insert(all.time.end(), c.time.begin(), c.time.end());
    }
    return all;
}

TimeSpan spanOf(const Cluster& cluster)
{
    TimeSpan span;
    for (const float t : cluster.time)
    {
        span.first = std::min(span.first, static_cast<double>(t));
        span.last = std::max(span.last, static_cast<double>(t));
    }
    return span;
}

// The hits before or after the middle of the span, whichever are more.
Cluster largerPart(const Cluster& cluster, const TimeSpan& span)
{
    const double middle = 0.5 * (span.first + span.last);
    const auto early = std::count_if(cluster.time.begin(), cluster.time.end(),
                                     [&](float t) { return t < middle; });
    const bool keepEarly = 2 * static_cast<std::size_t>(early) >= cluster.size();
    Cluster part;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        if ((cluster.time[i] < middle) != keepEarly) continue;
        part.x.push_back(cluster.x[i]);
        part.y.push_back(cluster.y[i]);
        part.height.push_back(cluster.height[i]);
        part.time.push_back(cluster.time[i]);
    }
    return part;
}

double meanTime(const Cluster& cluster)
{
    double sum = 0.0;
    for (const float t : cluster.time) sum += t;
    return sum / static_cast<double>(cluster.size());
}

Cluster movedTo(double time, Cluster cluster, const TargetMotion& motion)
{
    const Eigen::Vector2d centre = motion.centre + time * motion.velocity;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const double dt = time - cluster.time[i];
        const double dx = cluster.x[i] - centre.x();
        const double dy = cluster.y[i] - centre.y();
        cluster.x[i] += static_cast<float>(dt * (motion.velocity.x() - motion.yawRate * dy));
        cluster.y[i] += static_cast<float>(dt * (motion.velocity.y() + motion.yawRate * dx));
    }
    return cluster;
}
}  // namespace

TargetMotion motionOf(const VehicleState& state, const SegmentedFrame& frame)
{
    const double v = state.mean(kSpeed);
    TargetMotion motion;
    motion.centre = state.mean.head<2>() - frame.origin.head<2>();
    motion.yawRate = state.yawRate();
    motion.velocity =
        rotation(state.mean(kHeading)) * Eigen::Vector2d(v, state.mean(kAxis) * motion.yawRate);
    motion.speedSigma = std::sqrt(state.covariance(kSpeed, kSpeed));
    return motion;
}

HitsAtOneTime hitsAtOneTime(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                            const TargetMotion& motion, double mergeCell)
{
    const bool timed = std::all_of(clusters.begin(), clusters.end(),
                                   [&](std::size_t k) { return !frame.clusters[k].time.empty(); });
    if (!timed) return {hitsOf(frame, clusters), 0.0};
    Cluster all = joinedClusters(frame, clusters);
    TimeSpan span = spanOf(all);
    if (span.length() > kSeamGap && motion.speedSigma * span.length() > kMostDistance)
    {
        all = largerPart(all, span);
        span = spanOf(all);
    }
    const double lag = meanTime(all);
    if (motion.velocity.norm() * span.length() > kStill) all = movedTo(lag, std::move(all), motion);
    return {projectHits(all, mergeCell), lag};
}

}  // namespace vdamf
