// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/association/auction.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "association/candidates.h"

namespace vdamf
{
namespace
{
// Extent of hits along the axes of a box's heading.
struct Extent
{
    double minX = 1e30, maxX = -1e30, minY = 1e30, maxY = -1e30;

    // Those of hits where a target of that velocity has them at time zero.
    void add(const Hits& hits, const PredictedTarget& target)
    {
        const auto [c, s] = directionOf(target.box.heading);
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

// What a target makes of the bids for it.
struct Choice
{
    std::vector<Bid> taken;
    std::vector<std::size_t> refused;  // clusters
};

// Takes the best bid, then each that keeps the union consistent.
Choice chosen(std::vector<Bid> bids, const PredictedTarget& target,
              const std::vector<Hits>& clusters, const AssociationOptions& options)
{
    std::stable_sort(bids.begin(), bids.end(),
                     [](const Bid& a, const Bid& b) { return a.benefit > b.benefit; });
    const double maxLength = target.box.length + options.lengthSlack + 2.0 * target.lengthSigma;
    const double maxWidth = target.box.width + options.widthSlack + 2.0 * target.widthSigma;
    Choice choice;
    Extent extent;
    for (const Bid& bid : bids)
    {
        Extent grown = extent;
        grown.add(clusters[bid.cluster], target);
        const bool fits =
            grown.maxX - grown.minX <= maxLength && grown.maxY - grown.minY <= maxWidth;
        if (!choice.taken.empty() && !fits)
        {
            choice.refused.push_back(bid.cluster);
            continue;
        }
        extent = grown;
        choice.taken.push_back(bid);
    }
    return choice;
}
}  // namespace

std::vector<std::vector<std::size_t>> assignClusters(const std::vector<PredictedTarget>& targets,
                                                     const std::vector<Hits>& clusters,
                                                     const AssociationOptions& options,
                                                     const std::vector<bool>& isVehicle)
{
    const CandidateFinder finder(targets, clusters, options);
    std::vector<std::vector<Candidate>> wishes;
    wishes.reserve(clusters.size());
    for (const Hits& hits : clusters) wishes.push_back(finder.candidates(hits));
    for (std::size_t i = 0; i < isVehicle.size(); ++i)
        if (isVehicle[i])
            wishes[i].erase(std::remove_if(wishes[i].begin(), wishes[i].end(),
                                           [&](const Candidate& wish)
                                           { return targets[wish.target].isClutter; }),
                            wishes[i].end());

    std::vector<std::vector<Bid>> held(targets.size());
    std::vector<std::vector<Bid>> bids(targets.size());
    std::vector<std::size_t> nextWish(clusters.size(), 0);
    std::vector<std::size_t> bidding(clusters.size());
    std::iota(bidding.begin(), bidding.end(), std::size_t{0});
    while (!bidding.empty())
    {
        std::vector<std::size_t> asked;
        for (const std::size_t i : bidding)
        {
            if (nextWish[i] >= wishes[i].size()) continue;
            const Candidate& wish = wishes[i][nextWish[i]++];
            if (bids[wish.target].empty()) asked.push_back(wish.target);
            bids[wish.target].push_back({i, wish.benefit});
        }
        bidding.clear();
        for (const std::size_t j : asked)
        {
            bids[j].insert(bids[j].end(), held[j].begin(), held[j].end());
            Choice choice = chosen(std::move(bids[j]), targets[j], clusters, options);
            bids[j].clear();
            held[j] = std::move(choice.taken);
            bidding.insert(bidding.end(), choice.refused.begin(), choice.refused.end());
        }
        std::sort(bidding.begin(), bidding.end());
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
