// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/one_time.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "types/append_hit.h"

namespace vdamf
{
namespace
{
constexpr double kSeamGap = 0.03;      // s between hits; nothing else than the seam takes longer
constexpr double kMostDistance = 0.3;  // m, by which parts that are put together may be misplaced
constexpr double kStill = 0.005;       // m, of motion that needs no correction

struct TimeSpan
{
    double first = 1e9;
    double last = -1e9;
    double length() const { return last - first; }
};

Lent<Cluster> clustersOf(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters)
{
    if (clusters.size() == 1) return Lent<Cluster>::from(frame.clusters[clusters.front()]);
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

// Between the last hit before the middle of the span and the first one after it, s. What is close
// takes long as well, but a sensor hits it all the while.
double gapInMiddle(const Cluster& cluster, const TimeSpan& span)
{
    const double middle = 0.5 * (span.first + span.last);
    TimeSpan gap{span.first, span.last};
    for (const float t : cluster.time)
    {
        if (t < middle)
            gap.first = std::max(gap.first, static_cast<double>(t));
        else
            gap.last = std::min(gap.last, static_cast<double>(t));
    }
    return gap.length();
}

struct PartsInTime
{
    Cluster larger, smaller;
};

// The hits before and after the middle of the span.
PartsInTime splitInTime(const Cluster& cluster, const TimeSpan& span)
{
    const double middle = 0.5 * (span.first + span.last);
    Cluster part[2];
    for (std::size_t i = 0; i < cluster.size(); ++i)
        appendHit(part[cluster.time[i] < middle ? 0 : 1], cluster, i);
    const int larger = part[0].size() >= part[1].size() ? 0 : 1;
    return {std::move(part[larger]), std::move(part[1 - larger])};
}

Eigen::Vector2d middleOf(const Cluster& cluster)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < cluster.size(); ++i)
        sum += Eigen::Vector2d(cluster.x[i], cluster.y[i]);
    return sum / static_cast<double>(cluster.size());
}

double meanTime(const Cluster& cluster)
{
    double sum = 0.0;
    for (const float t : cluster.time) sum += t;
    return sum / static_cast<double>(cluster.size());
}

// By how much parts put together may seem to turn: one that is misplaced along its way, by an error
// of the speed, turns the line through both. Speeds follow what brakes late.
double turnSigma(const PartsInTime& parts, const TargetMotion& motion)
{
    constexpr double kLag = 1.0;  // m/s
    const double speed = motion.velocity.norm();
    if (parts.smaller.size() == 0 || speed * kSeamGap < kStill) return 0.0;
    const double between = meanTime(parts.smaller) - meanTime(parts.larger);
    const Eigen::Vector2d apart =
        middleOf(parts.smaller) - middleOf(parts.larger) - between * motion.velocity;
    const Eigen::Vector2d way = motion.velocity / speed;
    const double across = std::abs(way.x() * apart.y() - way.y() * apart.x());
    return std::hypot(motion.speedSigma, motion.changes * kLag) * std::abs(between) * across /
           apart.squaredNorm();
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

TargetMotion motionOf(const VehicleState& state)
{
    const double v = state.mean(kSpeed);
    TargetMotion motion;
    motion.centre = state.mean.head<2>();
    motion.yawRate = state.yawRate();
    motion.velocity =
        rotation(state.mean(kHeading)) * Eigen::Vector2d(v, state.mean(kAxis) * motion.yawRate);
    motion.speedSigma = state.speedSigma();
    return motion;
}

HitsAtOneTime hitsAtOneTime(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                            const TargetMotion& motion, double mergeCell)
{
    const bool timed = std::all_of(clusters.begin(), clusters.end(),
                                   [&](std::size_t k) { return !frame.clusters[k].time.empty(); });
    HitsAtOneTime result;
    if (!timed)
    {
        result.hits = hitsOf(frame, clusters);
        result.each = clustersOf(frame, clusters);
        return result;
    }
    Cluster all = *clustersOf(frame, clusters);
    TimeSpan span = spanOf(all);
    result.areParts = span.length() > kSeamGap && gapInMiddle(all, span) > kSeamGap;
    if (result.areParts)
    {
        PartsInTime parts = splitInTime(all, span);
        if (motion.speedSigma * span.length() <= kMostDistance)
            result.turnSigma = turnSigma(parts, motion);
        else
        {
            if (parts.smaller.size() > 0) result.goesOn = middleOf(parts.smaller);
            all = std::move(parts.larger);
            span = spanOf(all);
        }
    }
    result.lag = meanTime(all);
    if (motion.velocity.norm() * span.length() > kStill)
        all = movedTo(result.lag, std::move(all), motion);
    result.hits = projected(all, mergeCell, frame.planar);
    result.each = std::move(all);
    return result;
}

}  // namespace vdamf
