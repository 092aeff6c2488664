// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/new_sightings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tracker/one_time.h"
#include "tracker/track.h"

namespace vdamf
{
namespace
{
constexpr double kAtSeam = 0.002;    // s, from the begin or the end of a revolution
constexpr double kAcrossSeam = 0.3;  // rad, between what is hit at both ends of one
constexpr double kSeamMotion = 4.5;  // m, of a fast target in a revolution

bool mayStart(const SegmentedFrame& frame, std::size_t i, const LifecycleOptions& options)
{
    return frame.hits[i].totalWeight >= options.minHits &&
           isHighEnough(frame.clusters[i], frame.planar, options);
}

// When a hit was taken, s after the frame's time, and where, from the sensor.
struct TimedHit
{
    float time = 0.0F;
    Eigen::Vector2d at;
};

struct TimeRange
{
    TimedHit first, last;
};

TimeRange timesOf(const Cluster& cluster, const Eigen::Vector2d& sensor)
{
    const auto [first, last] = std::minmax_element(cluster.time.begin(), cluster.time.end());
    const auto hit = [&](std::vector<float>::const_iterator time)
    {
        const auto i = static_cast<std::size_t>(time - cluster.time.begin());
        return TimedHit{*time, Eigen::Vector2d(cluster.x[i], cluster.y[i]) - sensor};
    };
    return {hit(first), hit(last)};
}

Eigen::Vector2d middleOf(const Hits& hits)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < hits.size(); ++i)
        sum += hits.weight[i] * Eigen::Vector2d(hits.x[i], hits.y[i]);
    return sum / hits.totalWeight;
}

double rangeOf(const SegmentedFrame& frame, std::size_t i)
{
    return (middleOf(frame.hits[i]) - frame.sensor).norm();
}

// A cluster that ends at the seam, and its hit next to it.
struct SeamEnd
{
    std::size_t cluster;
    Eigen::Vector2d at;  // from the sensor, m
};

// Clusters that end at the seam, before it (late) and behind it (early).
struct Seam
{
    std::vector<SeamEnd> early, late;
};

Seam seamOf(const SegmentedFrame& frame, const std::vector<std::size_t>& free)
{
    Seam seam;
    for (const std::size_t i : free)
    {
        if (frame.clusters[i].time.empty()) continue;
        const auto [first, last] = timesOf(frame.clusters[i], frame.sensor);
        if (last.time - first.time > 0.5F * (frame.times.last - frame.times.first)) continue;
        if (first.time < frame.times.first + kAtSeam)
            seam.early.push_back({i, first.at});
        else if (last.time > frame.times.last - kAtSeam)
            seam.late.push_back({i, last.at});
    }
    return seam;
}

// But for the motion between both: sensors that do not turn all around end their scans elsewhere
// than they begin them.
bool areAtOneBearing(const SeamEnd& a, const SeamEnd& b)
{
    const double cross = a.at.x() * b.at.y() - a.at.y() * b.at.x();
    const double range = std::max(1.0, std::min(a.at.norm(), b.at.norm()));
    return std::abs(std::atan2(cross, a.at.dot(b.at))) < kAcrossSeam + kSeamMotion / range;
}

constexpr std::size_t kNoOther = static_cast<std::size_t>(-1);

// For each cluster the one that it continues beyond the seam, or kNoOther.
std::vector<std::size_t> partners(const SegmentedFrame& frame, const std::vector<std::size_t>& free)
{
    std::vector<std::size_t> partner(frame.clusters.size(), kNoOther);
    const Seam seam = seamOf(frame, free);
    for (const SeamEnd& early : seam.early)
        for (const SeamEnd& late : seam.late)
        {
            const std::size_t i = early.cluster;
            const std::size_t j = late.cluster;
            const bool near = areAtOneBearing(early, late) &&
                              std::abs(rangeOf(frame, i) - rangeOf(frame, j)) < kSeamMotion;
            if (!near || partner[i] != kNoOther || partner[j] != kNoOther) continue;
            partner[i] = j;
            partner[j] = i;
        }
    return partner;
}

// A cluster that may be a new target, with the one that it continues beyond the seam, or kNoOther.
struct Start
{
    std::size_t cluster;
    std::size_t other;
};

// Of two that are one target the larger one, or the earlier of equals.
std::vector<Start> startsAmong(const SegmentedFrame& frame, const std::vector<bool>& claimed,
                               const LifecycleOptions& options)
{
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < frame.clusters.size(); ++i)
        if (!claimed[i]) free.push_back(i);
    const std::vector<std::size_t> partner = partners(frame, free);
    std::vector<Start> starts;
    for (const std::size_t i : free)
    {
        const std::size_t other = partner[i];
        const bool isSmaller =
            other != kNoOther &&
            (frame.hits[other].totalWeight > frame.hits[i].totalWeight ||
             (frame.hits[other].totalWeight == frame.hits[i].totalWeight && other < i));
        if (!isSmaller && mayStart(frame, i, options)) starts.push_back({i, other});
    }
    return starts;
}

// Nothing for what is too large.
std::optional<Sighting> firstSighting(const SegmentedFrame& frame, const Start& at,
                                      const Neighbourhood& around, const TrackerOptions& options)
{
    TargetMotion unknown;
    unknown.speedSigma = options.lifecycle.startSpeedSigma;
    HitsAtOneTime seen = hitsAtOneTime(frame, {at.cluster}, unknown, options.measurement.mergeCell);
    if (at.other != kNoOther) seen.goesOn = middleOf(frame.hits[at.other]);
    const OrientedBox start =
        startBox(*seen.hits, frame.sensor, widestEnd(heightOf(frame.clusters[at.cluster])),
                 options.measurement.fit);
    if (std::hypot(start.length, start.width) > options.lifecycle.maxExtent) return std::nullopt;
    return withLikelierAxes(
        sightingOf(frame, {at.cluster}, seen, start, std::nullopt, options.measurement), around,
        options);
}
}  // namespace

bool isHighEnough(const Cluster& cluster, bool isPlanar, const LifecycleOptions& options)
{
    return isPlanar || heightOf(cluster) >= options.minHeight;
}

Sighting withLikelierAxes(Sighting sighting, const Neighbourhood& around,
                          const TrackerOptions& options)
{
    constexpr std::uint64_t kNew = 0;
    const Measurement& m = sighting.measurement;
    const auto taken = [&](const Measurement& as)
    { return placeTaken(as, sighting.height, sighting.sensor, around, kNew, options); };
    const double evidence = axesEvidence(sizeCues(sighting, m, sighting.height)) +
                            around.axesEvidence(m.box, kNew) + taken(turnedBy(m, 1)) - taken(m);
    if (evidence < 0.0) sighting = turnedBy(std::move(sighting), 1);
    if (sighting.front < 0.0) sighting = turnedBy(std::move(sighting), 2);
    return withHeadingOfNeighbours(std::move(sighting), around, kNew);
}

std::vector<Sighting> newSightings(const SegmentedFrame& frame, const std::vector<bool>& claimed,
                                   const Neighbourhood& around, const TrackerOptions& options,
                                   WorkerPool& workers)
{
    const std::vector<Start> starts = startsAmong(frame, claimed, options.lifecycle);
    std::vector<std::optional<Sighting>> found(starts.size());
    workers.forEach(starts.size(), [&](std::size_t k, std::size_t)
                    { found[k] = firstSighting(frame, starts[k], around, options); });
    std::vector<Sighting> all;
    all.reserve(found.size());
    for (std::optional<Sighting>& one : found)
        if (one) all.push_back(std::move(*one));
    return all;
}

}  // namespace vdamf
