// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/newcomers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "tracker/segmentation.h"
#include "types/append_hit.h"
#include "types/cluster_bounds.h"

namespace vdamf
{
namespace
{
constexpr double kMayGrow = 0.5;         // m, to each side, as more of it shows
constexpr std::size_t kStayingHits = 3;  // of what stands
constexpr std::size_t kHitsOfTwo = 16;   // of it and a newcomer
constexpr double kExtentOfTwo = 2.0;     // m

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

// What stands, and what is beyond it.
struct Parted
{
    Cluster old, fresh;
};

Parted parted(const Cluster& cluster, const OrientedBox& stands)
{
    Parted parts;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const Eigen::Vector2d p = toBoxFrame(stands, {cluster.x[i], cluster.y[i]}).cwiseAbs();
        const bool isNear =
            p.x() <= 0.5 * stands.length + kMayGrow && p.y() <= 0.5 * stands.width + kMayGrow;
        appendHit(isNear ? parts.old : parts.fresh, cluster, i);
    }
    return parts;
}

bool isNewcomer(const Cluster& cluster)
{
    constexpr std::size_t kHits = 8;
    constexpr double kExtent = 1.0;  // m
    return cluster.size() >= kHits && boundsOf(cluster).diagonal() > kExtent;
}

// What stands, in place of the cluster, and what is beyond it; nothing where that is no newcomer.
std::optional<ClusteredHits> withoutNewcomers(const Cluster& cluster, const PredictedTarget& stands,
                                              const SegmentedFrame& frame,
                                              const ClusterOptions& options)
{
    if (boundsOf(cluster).diagonal() < diagonalOf(stands.box) + kMayGrow) return std::nullopt;
    Parted parts = parted(cluster, stands.box);
    if (parts.old.size() < kStayingHits || !isNewcomer(parts.fresh)) return std::nullopt;
    ClusteredHits all = clusteredAnew(std::move(parts.fresh), frame, options);
    if (std::none_of(all.clusters.begin(), all.clusters.end(), isNewcomer)) return std::nullopt;
    all.clusters.insert(all.clusters.begin(), std::move(parts.old));
    return all;
}
}  // namespace

SegmentedFrame withNewcomersCutOff(SegmentedFrame frame,
                                   const std::vector<PredictedTarget>& targets,
                                   const std::vector<Track>& tracks, const Clutter& clutter,
                                   const ClusterOptions& options)
{
    std::vector<Cluster> all;
    all.reserve(frame.clusters.size());
    for (Cluster& cluster : frame.clusters)
    {
        std::optional<ClusteredHits> parts;
        const ClusterBounds bounds = boundsOf(cluster);
        if (cluster.size() >= kHitsOfTwo && bounds.diagonal() >= kExtentOfTwo)
        {
            const auto held = clutter.within(bounds);
            if (held.size() == 1 && mayBeTouched(targets[held.front()], tracks[held.front()]))
                parts = withoutNewcomers(cluster, targets[held.front()], frame, options);
        }
        if (!parts)
        {
            all.push_back(std::move(cluster));
            continue;
        }
        std::move(parts->clusters.begin(), parts->clusters.end(), std::back_inserter(all));
        appendHits(frame.loose, parts->loose);
    }
    frame.clusters = std::move(all);
    return frame;
}

}  // namespace vdamf
