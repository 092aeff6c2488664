// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/association/shared_clusters.h"

#include <algorithm>
#include <cmath>

#include "association/candidates.h"
#include "types/append_hit.h"

namespace vdamf
{
namespace
{
constexpr double kSureOfSharing = 0.7;  // m; vaguer targets do not tell where to cut
constexpr double kLeastHitsOfSharer = 5.0;
constexpr double kLeastShareOfHits = 0.1;    // of a cluster's hits
constexpr double kLeastShareOfBefore = 0.5;  // of those that a vehicle had before
// Squared distances in standard deviations: of hits that are on a target's surface, and of those
// that are not. Wide gates would not do: the side of a car that drives close to another's is inside
// both.
constexpr double kOn = 0.5;
constexpr double kOff = 1.0;

// Whether an axis of the first box has both boxes' corners on different sides.
bool hasSeparatingAxis(const OrientedBox& box, const OrientedBox& other)
{
    Eigen::Vector2d min = Eigen::Vector2d::Constant(1e30);
    Eigen::Vector2d max = -min;
    for (const Eigen::Vector2d& corner : corners(other))
    {
        const Eigen::Vector2d p = toBoxFrame(box, corner);
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    return (min.array() > half.array()).any() || (max.array() < -half.array()).any();
}

bool overlap(const OrientedBox& a, const OrientedBox& b)
{
    return !hasSeparatingAxis(a, b) && !hasSeparatingAxis(b, a);
}

// What a vehicle for sure passes closely it may seem to touch, where its heading errs by a few
// degrees.
OrientedBox coreOf(const PredictedTarget& target)
{
    constexpr double kSlack = 0.3;  // m, on each side
    OrientedBox box = target.box;
    if (!target.isBounded && !target.isDrivingTruck) return box;
    box.length = std::max(0.0, box.length - 2.0 * kSlack);
    box.width = std::max(0.0, box.width - 2.0 * kSlack);
    return box;
}

// Squared distances of the hits of a cluster from a target.
struct HitsOfTarget
{
    std::size_t target;
    double off;  // weight of the hits that are not on it
    std::vector<double> squares;
};

HitsOfTarget hitsOfTarget(const Hits& hits, std::size_t target, const TargetSurface& surface,
                          double off)
{
    HitsOfTarget fit{target, off, std::vector<double>(hits.size())};
    for (std::size_t i = 0; i < hits.size(); ++i)
        fit.squares[i] = surface.squaredDistance(hits.x[i], hits.y[i]);
    return fit;
}

// Weight of the hits that are on the one and not on the other.
double onlyOn(const HitsOfTarget& one, const HitsOfTarget& other, const Hits& hits)
{
    double weight = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (one.squares[i] < kOn && other.squares[i] > kOff) weight += hits.weight[i];
    return weight;
}

// Weight of the hits that a sharing target has to itself at least. What is surely a vehicle may be
// behind another one that has a hundred times as many.
double leastHits(const PredictedTarget& target, const Hits& cluster)
{
    double least = kLeastShareOfHits * cluster.totalWeight;
    if ((target.isBounded || target.isDrivingTruck) && target.hits > 0.0)
        least = std::min(least, kLeastShareOfBefore * target.hits);
    return std::max(kLeastHitsOfSharer, least);
}

std::vector<std::size_t> targetsOn(const Hits& hits, const std::vector<std::size_t>& inReach,
                                   const std::vector<PredictedTarget>& targets,
                                   const CandidateFinder& finder)
{
    double fewest = hits.totalWeight;
    for (const std::size_t j : inReach) fewest = std::min(fewest, leastHits(targets[j], hits));
    std::vector<HitsOfTarget> fits;
    for (const std::size_t j : inReach)
    {
        if (targets[j].positionSigma.maxCoeff() >= kSureOfSharing) continue;
        const TargetSurface surface = finder.surfaceOf(j, hits);
        const double off = surface.weightBeyond(kOff, hits);
        // As for most clusters: nothing is left for another target.
        if (off < fewest) return {};
        fits.push_back(hitsOfTarget(hits, j, surface, off));
    }
    if (fits.size() < 2) return {};
    const auto best = std::min_element(fits.begin(), fits.end(),
                                       [](const HitsOfTarget& a, const HitsOfTarget& b)
                                       { return a.off < b.off; });
    std::vector<std::size_t> sharing;
    for (const HitsOfTarget& fit : fits)
    {
        const bool shares = &fit == &*best ||
                            (onlyOn(fit, *best, hits) >= leastHits(targets[fit.target], hits) &&
                             onlyOn(*best, fit, hits) >= leastHits(targets[best->target], hits) &&
                             !overlap(coreOf(targets[fit.target]), coreOf(targets[best->target])));
        if (shares) sharing.push_back(fit.target);
    }
    return sharing;
}
}  // namespace

std::vector<SharedCluster> sharedClusters(const std::vector<PredictedTarget>& targets,
                                          const std::vector<Hits>& clusters,
                                          const AssociationOptions& options)
{
    const CandidateFinder finder(targets, clusters, options);
    std::vector<SharedCluster> shared;
    for (std::size_t i = 0; i < clusters.size(); ++i)
    {
        const std::vector<std::size_t> inReach = finder.inReach(clusters[i]);
        if (inReach.size() < 2) continue;
        std::vector<std::size_t> on = targetsOn(clusters[i], inReach, targets, finder);
        if (on.size() >= 2) shared.push_back({i, std::move(on)});
    }
    return shared;
}

std::vector<Cluster> cutBetween(const Cluster& cluster, const std::vector<PredictedTarget>& targets,
                                double time, const AssociationOptions& options)
{
    std::vector<TargetSurface> surfaces;
    for (const PredictedTarget& target : targets) surfaces.emplace_back(target, time, options);
    std::vector<Cluster> pieces(targets.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        std::size_t nearest = 0;
        double least = 1e30;
        for (std::size_t k = 0; k < surfaces.size(); ++k)
        {
            const double square = surfaces[k].squaredDistance(cluster.x[i], cluster.y[i]);
            if (square < least) nearest = k;
            least = std::min(least, square);
        }
        appendHit(pieces[nearest], cluster, i);
    }
    pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                                [](const Cluster& piece) { return piece.size() == 0; }),
                 pieces.end());
    return pieces;
}

}  // namespace vdamf
