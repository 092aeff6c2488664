// SPDX-License-Identifier: BSD-3-Clause
#include "association/candidates.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::vector<PlaneBounds> reachOf(const std::vector<PredictedTarget>& targets, double sweep,
                                 const AssociationOptions& options)
{
    const double gate = std::sqrt(squaredGate(options));
    std::vector<PlaneBounds> all;
    all.reserve(targets.size());
    for (const PredictedTarget& t : targets)
    {
        const double c = std::abs(std::cos(t.box.heading));
        const double s = std::abs(std::sin(t.box.heading));
        const Eigen::Vector2d half(0.5 * (c * t.box.length + s * t.box.width),
                                   0.5 * (s * t.box.length + c * t.box.width));
        const double margin =
            gate * std::hypot(options.surfaceSigma, t.positionSigma) + sweep * t.velocity.norm();
        const Eigen::Vector2d reach = half.array() + margin;
        all.push_back({t.box.centre() - reach, t.box.centre() + reach});
    }
    return all;
}

PlaneBounds boundsOf(const Hits& hits)
{
    const auto [minX, maxX] = std::minmax_element(hits.x.begin(), hits.x.end());
    const auto [minY, maxY] = std::minmax_element(hits.y.begin(), hits.y.end());
    return {{*minX, *minY}, {*maxX, *maxY}};
}
}  // namespace

TargetSurface::TargetSurface(const PredictedTarget& target, const AssociationOptions& options)
    : centre_(target.box.centre()),
      velocity_(target.velocity),
      half_(0.5 * target.box.length, 0.5 * target.box.width),
      c_(std::cos(target.box.heading)),
      s_(std::sin(target.box.heading)),
      variance_(options.surfaceSigma * options.surfaceSigma +
                target.positionSigma * target.positionSigma),
      // Vague targets pay for their reach, so that a precise one wins a cluster both could explain.
      worth_(0.5 * squaredGate(options) -
             0.5 * std::log(variance_ / (options.surfaceSigma * options.surfaceSigma)))
{
}

TargetSurface TargetSurface::at(double time) const
{
    TargetSurface then = *this;
    then.centre_ += time * velocity_;
    return then;
}

double squaredGate(const AssociationOptions& options)
{
    return -2.0 * std::log1p(-options.gateProbability);
}

CandidateFinder::CandidateFinder(const std::vector<PredictedTarget>& targets,
                                 const std::vector<Hits>& clusters,
                                 const AssociationOptions& options)
    : index_(reachOf(targets, sweepOf(clusters), options))
{
    surfaces_.reserve(targets.size());
    for (const PredictedTarget& target : targets) surfaces_.emplace_back(target, options);
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
        const TargetSurface surface = surfaceOf(j, hits);
        double sum = 0.0;
        for (std::size_t i = 0; i < hits.size(); ++i)
            sum += hits.weight[i] * surface.benefit(surface.squaredDistance(hits.x[i], hits.y[i]));
        if (sum > 0.0) found.push_back({j, sum});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.benefit > b.benefit; });
    return found;
}

}  // namespace vdamf
