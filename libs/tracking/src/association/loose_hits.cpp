// SPDX-License-Identifier: BSD-3-Clause
#include "association/loose_hits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "association/vehicle_surface.h"
#include "types/append_hit.h"

namespace vdamf
{
namespace
{
// By rising x.
std::vector<std::uint32_t> sortedAlongX(const Cluster& hits)
{
    std::vector<std::uint32_t> order(hits.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return hits.x[a] < hits.x[b]; });
    return order;
}

// Trucks are open between their axles, so that hits beside one may be anything's; and what is less
// well known than hits scatter about a box would take its neighbours'.
bool mayHaveLooseHits(const PredictedTarget& target, const AssociationOptions& options)
{
    constexpr double kLongest = 6.5;  // m, of cars and vans
    constexpr double kWidest = 2.3;   // m
    return !target.isClutter && target.box.length <= kLongest && target.box.width <= kWidest &&
           target.positionSigma.maxCoeff() <= options.surfaceSigma;
}

// Loose hits are too few to tell that it is longer.
VehicleSurface closedSurfaceOf(PredictedTarget target, const Eigen::Vector2d& sensor,
                               const AssociationOptions& options)
{
    target.endSigma.setConstant(PredictedTarget::kUnknown);
    return {target, sensor, options};
}

double longestLag(const Cluster& hits)
{
    double lag = 0.0;
    for (const float t : hits.time) lag = std::max(lag, std::abs(static_cast<double>(t)));
    return lag;
}
}  // namespace

std::vector<Cluster> looseHitsOn(const std::vector<PredictedTarget>& targets,
                                 const std::vector<std::vector<std::size_t>>& assignment,
                                 const Cluster& loose, const Eigen::Vector2d& sensor,
                                 const AssociationOptions& options)
{
    std::vector<Cluster> found(targets.size());
    if (loose.size() == 0) return found;
    const std::vector<std::uint32_t> order = sortedAlongX(loose);
    const double lag = longestLag(loose);
    std::vector<bool> isTaken(loose.size(), false);
    for (std::size_t j = 0; j < targets.size(); ++j)
    {
        const PredictedTarget& target = targets[j];
        if (assignment[j].empty() || !mayHaveLooseHits(target, options)) continue;
        const VehicleSurface surface = closedSurfaceOf(target, sensor, options);
        const double reach = 0.5 * std::hypot(target.box.length, target.box.width) +
                             std::hypot(options.surfaceSigma, target.positionSigma.maxCoeff()) +
                             lag * target.velocity.norm();
        auto at = std::partition_point(order.begin(), order.end(),
                                       [&](std::uint32_t i)
                                       { return loose.x[i] < target.box.x - reach; });
        for (; at != order.end() && loose.x[*at] <= target.box.x + reach; ++at)
        {
            if (isTaken[*at] || !surface.has(surface.placeOf(loose, *at))) continue;
            isTaken[*at] = true;
            appendHit(found[j], loose, *at);
        }
    }
    return found;
}

bool anyLiesOn(const PredictedTarget& target, const Cluster& hits, const Eigen::Vector2d& sensor,
               const AssociationOptions& options)
{
    if (!mayHaveLooseHits(target, options)) return false;
    const VehicleSurface surface = closedSurfaceOf(target, sensor, options);
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (surface.has(surface.placeOf(hits, i))) return true;
    return false;
}

}  // namespace vdamf
