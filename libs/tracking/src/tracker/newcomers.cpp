// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/newcomers.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "association/plane_index.h"
#include "tracker/segmentation.h"
#include "types/append_hit.h"
#include "types/cluster_bounds.h"

namespace vdamf
{
namespace
{
constexpr double kMayGrow = 0.5;          // m, to each side, as more of it shows
constexpr std::size_t kNewcomerHits = 8;  // at least
constexpr std::size_t kStayingHits = 3;   // of what stands
constexpr std::size_t kOfTwo = 16;        // hits, of both
constexpr double kExtentOfTwo = 2.0;      // m

double diagonalOf(const OrientedBox& box)
{
    return std::hypot(box.length, box.width);
}

// What is larger comes into view part by part.
bool mayBeTouched(const PredictedTarget& target, const Track& track)
{
    constexpr double kLargest = 6.0;      // m
    constexpr double kSurelyNone = 0.02;  // probability, of a vehicle
    constexpr int kSightings = 3;
    return track.stood() && track.misses == 0 && track.sightings >= kSightings &&
           track.judgement.probability < kSurelyNone && diagonalOf(target.box) < kLargest;
}

PlaneIndex placesOf(const std::vector<PredictedTarget>& targets, std::vector<std::size_t>& clutter)
{
    std::vector<PlaneBounds> places;
    for (std::size_t j = 0; j < targets.size(); ++j)
    {
        if (!targets[j].isClutter) continue;
        clutter.push_back(j);
        places.push_back(PlaneBounds::around(targets[j].box.centre(), 0.0));
    }
    return PlaneIndex(std::move(places));
}

struct Parted
{
    Cluster old, fresh;
};

// Nothing where all may well be what was there before.
std::optional<Parted> parted(const Cluster& cluster, const PredictedTarget& stands)
{
    constexpr double kLeastExtent = 1.0;  // m, of a newcomer
    if (boundsOf(cluster).diagonal() < diagonalOf(stands.box) + kMayGrow) return std::nullopt;
    Parted parts;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const Eigen::Vector2d p = toBoxFrame(stands.box, {cluster.x[i], cluster.y[i]}).cwiseAbs();
        const bool isNear = p.x() <= 0.5 * stands.box.length + kMayGrow &&
                            p.y() <= 0.5 * stands.box.width + kMayGrow;
        appendHit(isNear ? parts.old : parts.fresh, cluster, i);
    }
    const bool isCut = parts.old.size() >= kStayingHits && parts.fresh.size() >= kNewcomerHits &&
                       boundsOf(parts.fresh).diagonal() > kLeastExtent;
    if (!isCut) return std::nullopt;
    return parts;
}
}  // namespace

SegmentedFrame withNewcomersCutOff(SegmentedFrame frame,
                                   const std::vector<PredictedTarget>& targets,
                                   const std::vector<Track>& tracks, const ClusterOptions& options)
{
    std::vector<std::size_t> clutter;
    const PlaneIndex places = placesOf(targets, clutter);
    std::vector<Cluster> all;
    all.reserve(frame.clusters.size());
    for (Cluster& cluster : frame.clusters)
    {
        std::optional<Parted> parts;
        const ClusterBounds bounds = boundsOf(cluster);
        if (cluster.size() >= kOfTwo && bounds.diagonal() >= kExtentOfTwo)
        {
            const auto held = places.overlapping(PlaneBounds::around(bounds));
            const std::size_t j = held.size() == 1 ? clutter[held.front()] : targets.size();
            if (j < targets.size() && mayBeTouched(targets[j], tracks[j]))
                parts = parted(cluster, targets[j]);
        }
        if (!parts)
        {
            all.push_back(std::move(cluster));
            continue;
        }
        all.push_back(std::move(parts->old));
        std::vector<Cluster> fresh = clusteredAnew(std::move(parts->fresh), frame, options);
        std::move(fresh.begin(), fresh.end(), std::back_inserter(all));
    }
    frame.clusters = std::move(all);
    return frame;
}

}  // namespace vdamf
