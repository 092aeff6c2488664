// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/association/auction.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
struct Circle
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;
};

Circle around(const Hits& hits)
{
    Circle c;
    for (std::size_t i = 0; i < hits.size(); ++i)
        c.centre += hits.weight[i] * Eigen::Vector2d(hits.x[i], hits.y[i]);
    if (hits.totalWeight > 0.0) c.centre /= hits.totalWeight;
    for (std::size_t i = 0; i < hits.size(); ++i)
        c.radius = std::max(c.radius, (Eigen::Vector2d(hits.x[i], hits.y[i]) - c.centre).norm());
    return c;
}

// Log likelihood ratio of the hits: on the target's surface against on a new object.
double benefit(const Hits& hits, const PredictedTarget& target, const AssociationOptions& options)
{
    const double variance =
        options.surfaceSigma * options.surfaceSigma + target.positionSigma * target.positionSigma;
    // Vague targets pay for their reach, so that a precise one wins a cluster both could explain.
    const double cost = 0.5 * std::log(variance / (options.surfaceSigma * options.surfaceSigma));
    const double c = std::cos(target.box.heading);
    const double s = std::sin(target.box.heading);
    const Eigen::Vector2d centre = target.box.centre() + hits.time * target.velocity;
    double sum = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - centre.x();
        const double dy = hits.y[i] - centre.y();
        const double outX = std::max(0.0, std::abs(c * dx + s * dy) - 0.5 * target.box.length);
        const double outY = std::max(0.0, std::abs(c * dy - s * dx) - 0.5 * target.box.width);
        const double d2 = (outX * outX + outY * outY) / variance;
        sum += hits.weight[i] * (0.5 * options.gate * options.gate - 0.5 * d2 - cost);
    }
    return sum;
}

struct Candidate
{
    std::size_t target;
    double benefit;
};

// Targets that a cluster benefits from, best first.
std::vector<Candidate> candidates(const Hits& hits, const std::vector<PredictedTarget>& targets,
                                  const AssociationOptions& options)
{
    const Circle circle = around(hits);
    std::vector<Candidate> found;
    for (std::size_t j = 0; j < targets.size(); ++j)
    {
        const PredictedTarget& t = targets[j];
        const double reach = circle.radius + 0.5 * std::hypot(t.box.length, t.box.width) +
                             options.gate * std::hypot(options.surfaceSigma, t.positionSigma);
        const Eigen::Vector2d centre = t.box.centre() + hits.time * t.velocity;
        if ((centre - circle.centre).squaredNorm() > reach * reach) continue;
        const double b = benefit(hits, t, options);
        if (b > 0.0) found.push_back({j, b});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Candidate& a, const Candidate& b) { return a.benefit > b.benefit; });
    return found;
}

// Extent of hits along the axes of a box's heading.
struct Extent
{
    double minX = 1e30, maxX = -1e30, minY = 1e30, maxY = -1e30;

    // Those of hits where a target of that velocity has them at time zero.
    void add(const Hits& hits, const PredictedTarget& target)
    {
        const double c = std::cos(target.box.heading);
        const double s = std::sin(target.box.heading);
        const Eigen::Vector2d moved = hits.time * target.velocity;
        for (std::size_t i = 0; i < hits.size(); ++i)
        {
            const double dx = hits.x[i] - moved.x();
            const double dy = hits.y[i] - moved.y();
            const double x = c * dx + s * dy;
            const double y = c * dy - s * dx;
            minX = std::min(minX, x);
            maxX = std::max(maxX, x);
            minY = std::min(minY, y);
            maxY = std::max(maxY, y);
        }
    }
};

struct Bid
{
    std::size_t cluster;
    double benefit;
};

// The bids that a target takes: the best one, then each that keeps the union consistent.
std::vector<Bid> accepted(std::vector<Bid> bids, const PredictedTarget& target,
                          const std::vector<Hits>& clusters, const AssociationOptions& options)
{
    std::stable_sort(bids.begin(), bids.end(),
                     [](const Bid& a, const Bid& b) { return a.benefit > b.benefit; });
    const double maxLength = target.box.length + options.lengthSlack + 2.0 * target.lengthSigma;
    const double maxWidth = target.box.width + options.widthSlack + 2.0 * target.widthSigma;
    std::vector<Bid> taken;
    Extent extent;
    for (const Bid& bid : bids)
    {
        Extent grown = extent;
        grown.add(clusters[bid.cluster], target);
        const bool fits =
            grown.maxX - grown.minX <= maxLength && grown.maxY - grown.minY <= maxWidth;
        if (!taken.empty() && !fits) continue;
        extent = grown;
        taken.push_back(bid);
    }
    return taken;
}
}  // namespace

std::vector<std::vector<std::size_t>> assignClusters(const std::vector<PredictedTarget>& targets,
                                                     const std::vector<Hits>& clusters,
                                                     const AssociationOptions& options)
{
    std::vector<std::vector<Candidate>> wishes;
    wishes.reserve(clusters.size());
    for (const Hits& hits : clusters) wishes.push_back(candidates(hits, targets, options));

    std::vector<std::vector<Bid>> held(targets.size());
    std::vector<std::size_t> nextWish(clusters.size(), 0);
    std::vector<bool> placed(clusters.size(), false);
    for (bool anyBid = true; anyBid;)
    {
        anyBid = false;
        std::vector<std::vector<Bid>> bids(targets.size());
        for (std::size_t i = 0; i < clusters.size(); ++i)
        {
            if (placed[i] || nextWish[i] >= wishes[i].size()) continue;
            const Candidate& wish = wishes[i][nextWish[i]++];
            bids[wish.target].push_back({i, wish.benefit});
            anyBid = true;
        }
        for (std::size_t j = 0; j < targets.size(); ++j)
        {
            if (bids[j].empty()) continue;
            for (const Bid& bid : held[j]) placed[bid.cluster] = false;
            bids[j].insert(bids[j].end(), held[j].begin(), held[j].end());
            held[j] = accepted(bids[j], targets[j], clusters, options);
            for (const Bid& bid : held[j]) placed[bid.cluster] = true;
        }
    }

    std::vector<std::vector<std::size_t>> assignment(targets.size());
    for (std::size_t j = 0; j < targets.size(); ++j)
    {
        for (const Bid& bid : held[j]) assignment[j].push_back(bid.cluster);
        std::sort(assignment[j].begin(), assignment[j].end());
    }
    return assignment;
}

}  // namespace vdamf
