// SPDX-License-Identifier: BSD-3-Clause
#include "association/candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "types/hit_bounds.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
// The most by which a cluster's time differs from the frame's, s.
double sweepOf(const std::vector<Hits>& clusters)
{
    double sweep = 0.0;
    for (const Hits& hits : clusters) sweep = std::max(sweep, std::abs(hits.time));
    return sweep;
}

// Of a target's centre along and across its box at a time, m.
Eigen::Vector2d placeSigma(const PredictedTarget& target, double time)
{
    const double along = target.positionSigma.x();
    const double moved = time * target.speedSigma;
    const double variance = along * along + 2.0 * time * target.speedCovariance + moved * moved;
    return Eigen::Vector2d(std::sqrt(std::max(0.0, variance)), target.positionSigma.y())
        .cwiseMin(target.greatestSigma);
}

std::vector<PlaneBounds> reachOf(const std::vector<PredictedTarget>& targets, double sweep,
                                 const AssociationOptions& options)
{
    const double gate = std::sqrt(squaredGate(options));
    std::vector<PlaneBounds> all;
    all.reserve(targets.size());
    for (const PredictedTarget& t : targets)
    {
        const Direction forward = directionOf(t.box.heading);
        const double c = std::abs(forward.cos);
        const double s = std::abs(forward.sin);
        const Eigen::Vector2d half(0.5 * (c * t.box.length + s * t.box.width),
                                   0.5 * (s * t.box.length + c * t.box.width));
        // Of a variance that is a parabola of the time the greatest one is at an end.
        const double vaguest =
            std::max(placeSigma(t, -sweep).maxCoeff(), placeSigma(t, sweep).maxCoeff());
        const double margin =
            gate * std::hypot(options.surfaceSigma, vaguest) + sweep * t.velocity.norm();
        const Eigen::Vector2d reach = half.array() + margin;
        all.push_back({t.box.centre() - reach, t.box.centre() + reach});
    }
    return all;
}

PlaneBounds boundsOf(const Hits& hits)
{
    const HitBounds b = boundsAlong(Direction(), hits);
    return {{b.minX, b.minY}, {b.maxX, b.maxY}};
}
}  // namespace

TargetSurface::TargetSurface(const PredictedTarget& target, double time,
                             const AssociationOptions& options)
    : centre_(target.box.centre() + time * target.velocity),
      half_(0.5 * target.box.length, 0.5 * target.box.width),
      forward_(directionOf(target.box.heading)),
      weight_(
          (placeSigma(target, time).array().square() + options.surfaceSigma * options.surfaceSigma)
              .inverse()),
      // Vague targets pay for their reach, so that a precise one wins a cluster both could explain.
      worth_(0.5 * squaredGate(options) +
             0.25 * std::log(weight_.prod() * std::pow(options.surfaceSigma, 4)))
{
}

double TargetSurface::benefit(const Hits& hits) const
{
    double squares = 0.0;
    inWideLanes([
        surface = *this, size = hits.size(), px = hits.x.data(), py = hits.y.data(),
        weight = hits.weight.data(), result = &squares
    ]() __attribute__((always_inline)) {
        Doubles sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles square;
            Doubles w;
            surface.squares(px + first, py + first, count, square);
            load(w, weight + first, count);
            sum += w * square;
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = sumOf(sum);
    });
    return worth_ * hits.totalWeight - 0.5 * squares;
}

double TargetSurface::weightBeyond(double squaredDistance, const Hits& hits) const
{
    double beyond = 0.0;
    inWideLanes([
        surface = *this, limit = squaredDistance, size = hits.size(), px = hits.x.data(),
        py = hits.y.data(), weight = hits.weight.data(), result = &beyond
    ]() __attribute__((always_inline)) {
        Doubles sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles square;
            Doubles w;
            surface.squares(px + first, py + first, count, square);
            load(w, weight + first, count);
            sum += square > limit ? w : Doubles{};
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = sumOf(sum);
    });
    return beyond;
}

double squaredGate(const AssociationOptions& options)
{
    return -2.0 * std::log1p(-options.gateProbability);
}

CandidateFinder::CandidateFinder(const std::vector<PredictedTarget>& targets,
                                 const std::vector<Hits>& clusters,
                                 const AssociationOptions& options)
    : targets_(targets), options_(options), index_(reachOf(targets, sweepOf(clusters), options))
{
}

std::vector<std::size_t> CandidateFinder::inReach(const Hits& hits) const
{
    if (hits.size() == 0) return {};
    return index_.overlapping(boundsOf(hits));
}

std::vector<Candidate> CandidateFinder::candidates(const Hits& hits) const
{
    std::vector<Candidate> found;
    for (const std::size_t j : inReach(hits))
    {
        const double benefit = surfaceOf(j, hits).benefit(hits);
        if (benefit > 0.0) found.push_back({j, benefit});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.benefit > b.benefit; });
    return found;
}

}  // namespace vdamf
