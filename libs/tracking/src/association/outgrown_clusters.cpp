// SPDX-License-Identifier: BSD-3-Clause
#include "association/outgrown_clusters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "association/vehicle_surface.h"
#include "types/append_hit.h"

namespace vdamf
{
namespace
{
constexpr double kSureOfOutgrown = 0.5;  // m; vaguer targets do not tell where to cut
constexpr std::size_t kLeastHits = 5;    // on a vehicle, and off it

std::vector<PredictedTarget> knownAmong(const std::vector<PredictedTarget>& targets)
{
    std::vector<PredictedTarget> known;
    for (const PredictedTarget& t : targets)
    {
        const bool isBounded = t.isBounded && t.positionSigma.maxCoeff() < kSureOfOutgrown &&
                               std::min(t.lengthSigma, t.widthSigma) < kSureSize;
        const bool isTruck =
            t.isDrivingTruck && t.positionSigma.y() < kSureOfOutgrown && t.widthSigma < kSureSize;
        if (isBounded || isTruck) known.push_back(t);
    }
    // Of hits on both a car ahead and the strip that a truck's unknown length leaves, the car's.
    std::stable_partition(known.begin(), known.end(),
                          [](const PredictedTarget& t) { return t.isBounded; });
    return known;
}

std::vector<PlaneBounds> boundsOf(const std::vector<PredictedTarget>& targets)
{
    std::vector<PlaneBounds> bounds;
    bounds.reserve(targets.size());
    for (const PredictedTarget& t : targets)
        bounds.push_back(
            PlaneBounds::around(t.box.centre(), 0.5 * std::hypot(t.box.length, t.box.width)));
    return bounds;
}

// Where a truck ends is not sure: it may go on beyond a gap.
VehicleSurface surfaceOf(PredictedTarget vehicle, const Eigen::Vector2d& sensor,
                         const AssociationOptions& options)
{
    constexpr double kEndless = 1e6;  // m
    if (vehicle.isDrivingTruck) vehicle.box.length = kEndless;
    return {vehicle, sensor, options};
}

// Whose the hits of a cluster are: of the first vehicle that has them, or of none.
struct Shares
{
    Shares(const Cluster& cluster, const std::vector<VehicleSurface>& vehicles)
        : owner(cluster.size(), static_cast<std::int32_t>(vehicles.size()))
    {
        std::size_t left = cluster.size();
        for (std::size_t k = 0; k < vehicles.size(); ++k)
        {
            hits.push_back(vehicles[k].claim(cluster, static_cast<std::int32_t>(k),
                                             static_cast<std::int32_t>(vehicles.size()), owner));
            left -= hits.back();
        }
        hits.push_back(left);
    }

    // Of two at least, and not only of vehicles that end where their boxes do, which come first:
    // what two of those share is cut where their boxes meet.
    bool areEnough(std::size_t bounded) const
    {
        const auto isEnough = [](std::size_t count) { return count >= kLeastHits; };
        return std::count_if(hits.begin(), hits.end(), isEnough) >= 2 &&
               std::any_of(hits.begin() + static_cast<std::ptrdiff_t>(bounded), hits.end(),
                           isEnough);
    }

    std::vector<std::int32_t> owner;  // of each hit, among the vehicles and then none
    std::vector<std::size_t> hits;    // of each owner
};
}  // namespace

KnownVehicles::KnownVehicles(const std::vector<PredictedTarget>& targets,
                             const AssociationOptions& options)
    : options_(options), vehicles_(knownAmong(targets)), index_(boundsOf(vehicles_))
{
}

std::optional<CutCluster> KnownVehicles::cut(const Cluster& cluster, const ClusterBounds& bounds,
                                             const Eigen::Vector2d& sensor) const
{
    if (cluster.size() < 2 * kLeastHits || vehicles_.empty()) return std::nullopt;
    std::vector<VehicleSurface> outgrown;
    std::size_t bounded = 0;  // of these
    for (const std::size_t k : index_.overlapping(PlaneBounds::around(bounds)))
    {
        const VehicleSurface surface = surfaceOf(vehicles_[k], sensor, options_);
        if (!surface.isOutgrownBy(cluster)) continue;
        outgrown.push_back(surface);
        if (vehicles_[k].isBounded) ++bounded;
    }
    if (outgrown.empty()) return std::nullopt;
    const Shares shares(cluster, outgrown);
    if (!shares.areEnough(bounded)) return std::nullopt;
    CutCluster parts;
    parts.vehicles.resize(outgrown.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const auto k = static_cast<std::size_t>(shares.owner[i]);
        appendHit(k < outgrown.size() ? parts.vehicles[k] : parts.rest, cluster, i);
    }
    for (const Cluster& piece : parts.vehicles)
        if (piece.size() < kLeastHits) appendHits(parts.rest, piece);
    parts.vehicles.erase(
        std::remove_if(parts.vehicles.begin(), parts.vehicles.end(),
                       [](const Cluster& piece) { return piece.size() < kLeastHits; }),
        parts.vehicles.end());
    return parts;
}

}  // namespace vdamf
