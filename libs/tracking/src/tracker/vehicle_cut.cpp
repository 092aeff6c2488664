// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/vehicle_cut.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "association/outgrown_clusters.h"
#include "preprocessing/convex_pieces.h"
#include "tracker/attention.h"
#include "tracker/clutter.h"
#include "tracker/newcomers.h"
#include "tracker/segmentation.h"
#include "tracker/vehicles_among.h"
#include "types/append_hit.h"
#include "types/cluster_bounds.h"

namespace vdamf
{
namespace
{
// Clusters to be, of vehicles and of all else.
struct Parts
{
    std::vector<Cluster> vehicles, rest;
    Cluster loose;  // hits of the rest that are in no cluster any more
};

// What a cluster is cut into by some vehicles; all of it is rest where they do not cut it.
Parts cutBy(const KnownVehicles& vehicles, Cluster cluster, const ClusterBounds& bounds,
            const SegmentedFrame& frame, const ClusterOptions& options)
{
    auto cut = vehicles.cut(cluster, bounds, frame.sensor);
    if (!cut)
    {
        Parts parts;
        parts.rest.push_back(std::move(cluster));
        return parts;
    }
    ClusteredHits rest = clusteredAnew(std::move(cut->rest), frame, options);
    return {std::move(cut->vehicles), std::move(rest.clusters), std::move(rest.loose)};
}

std::vector<PredictedTarget> drivingAmong(const std::vector<PredictedTarget>& targets)
{
    constexpr double kDrives = 2.0;  // m/s
    std::vector<PredictedTarget> driving;
    std::copy_if(targets.begin(), targets.end(), std::back_inserter(driving),
                 [](const PredictedTarget& t)
                 { return t.velocity.norm() > kDrives + 2.0 * t.speedSigma; });
    return driving;
}

void append(std::vector<Cluster>& to, std::vector<Cluster> more)
{
    std::move(more.begin(), more.end(), std::back_inserter(to));
}
}  // namespace

SegmentedFrame withVehiclesCutOut(SegmentedFrame frame, const std::vector<PredictedTarget>& targets,
                                  const std::vector<Track>& tracks, const Neighbourhood& around,
                                  const Discriminator& discriminator, const TrackerOptions& options)
{
    // What is smaller holds no more than a part of a car's end and a twig.
    constexpr double kLeastExtent = 2.0;  // m
    const Clutter clutter(targets);
    frame = withNewcomersCutOff(std::move(frame), targets, tracks, clutter, options.clustering);
    const KnownVehicles known(targets, options.association);
    const KnownVehicles driving(drivingAmong(targets), options.association);
    Parts all;
    for (Cluster& cluster : frame.clusters)
    {
        const ClusterBounds bounds = boundsOf(cluster);
        const bool maySplit = bounds.diagonal() >= kLeastExtent;
        std::vector<std::size_t> held;
        if (maySplit) held = clutter.within(bounds);
        const bool holdsClutter = !held.empty();
        const bool isSearched =
            maySplit && !(holdsClutter && isPassedOver(tracks[held.front()], discriminator));
        std::vector<Cluster> pieces;
        if (isSearched) pieces = convexPieces(cluster, frame.sensor);
        const bool isDented = !pieces.empty();
        // Whose hits they are is sure where something tells that they are not all of one thing,
        // or where the vehicle's own way tells how it lies.
        Parts parts = cutBy(isDented || holdsClutter ? known : driving, std::move(cluster), bounds,
                            frame, options.clustering);
        const bool isCut = !parts.vehicles.empty();
        append(all.vehicles, std::move(parts.vehicles));
        appendHits(all.loose, parts.loose);
        if (!isDented)
        {
            append(all.rest, std::move(parts.rest));
            continue;
        }
        for (Cluster& rest : parts.rest)
        {
            if (isCut) pieces = convexPieces(rest, frame.sensor);
            const KnownVehicles found(
                vehiclesAmong(std::move(pieces), frame, around, discriminator, options),
                options.association);
            const ClusterBounds within = boundsOf(rest);
            Parts more = cutBy(found, std::move(rest), within, frame, options.clustering);
            append(all.vehicles, std::move(more.vehicles));
            append(all.rest, std::move(more.rest));
            appendHits(all.loose, more.loose);
        }
    }
    const auto isLong = [&](const Cluster& cluster)
    { return boundsOf(cluster).diagonal() > options.clustering.maxExtent; };
    all.rest.erase(std::remove_if(all.rest.begin(), all.rest.end(), isLong), all.rest.end());
    frame.isVehicle.assign(all.rest.size(), false);
    frame.isVehicle.resize(all.rest.size() + all.vehicles.size(), true);
    frame.clusters = std::move(all.rest);
    append(frame.clusters, std::move(all.vehicles));
    appendHits(frame.loose, all.loose);
    return frame;
}

}  // namespace vdamf
