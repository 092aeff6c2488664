// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/association/auction.h"

#include <gtest/gtest.h>

#include "tracking/association/predicted_car.h"

#include <algorithm>
#include <random>

namespace vdamf
{
namespace
{
// A line of hits from a to b.
Hits line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, int count = 20)
{
    Hits hits;
    for (int k = 0; k < count; ++k)
    {
        const Eigen::Vector2d p = a + (b - a) * k / std::max(1, count - 1);
        hits.x.push_back(p.x());
        hits.y.push_back(p.y());
        hits.weight.push_back(1.0);
        hits.totalWeight += 1.0;
    }
    return hits;
}

using Assignment = std::vector<std::vector<std::size_t>>;

TEST(AssignClusters, OneTargetTakesSeveralConsistentClusters)
{
    const std::vector<Hits> clusters{line({8.0, -0.9}, {9.0, -0.9}),
                                     line({11.0, -0.9}, {12.2, -0.9}),
                                     line({30.0, 0.0}, {31.0, 0.0})};
    EXPECT_EQ(assignClusters({predictedCar(10.0, 0.0)}, clusters, {}), (Assignment{{0, 1}}));
}

TEST(AssignClusters, RefusesAUnionBeyondTheBox)
{
    // The second cluster alone would pass, but car and bush together are too long.
    const std::vector<Hits> clusters{line({7.8, -0.9}, {12.2, -0.9}, 40),
                                     line({12.9, -0.5}, {13.3, -0.5}, 6)};
    EXPECT_EQ(assignClusters({predictedCar(10.0, 0.0, 0.4)}, clusters, {}), (Assignment{{0}}));
}

TEST(AssignClusters, RefusedClusterGoesToItsSecondChoice)
{
    // Two cars end to end; the middle cluster prefers the left one, where it does not fit.
    const std::vector<PredictedTarget> targets{predictedCar(10.0, 0.0),
                                               predictedCar(15.6, 0.0, 0.6)};
    const std::vector<Hits> clusters{line({7.6, 0.0}, {12.0, 0.0}, 60),
                                     line({12.7, 0.0}, {13.1, 0.0}, 10),
                                     line({14.0, 0.0}, {17.0, 0.0}, 60)};
    const Assignment a = assignClusters(targets, clusters, {});
    EXPECT_EQ(a[0], (std::vector<std::size_t>{0}));
    EXPECT_EQ(a[1], (std::vector<std::size_t>{1, 2}));
}

TEST(AssignClusters, PreciseTargetWinsOverVague)
{
    const std::vector<PredictedTarget> targets{predictedCar(10.5, 0.0, 3.0),
                                               predictedCar(10.0, 0.0, 0.1)};
    EXPECT_EQ(assignClusters(targets, {line({8.0, -0.8}, {12.0, -0.8})}, {}),
              (Assignment{{}, {0}}));
}

TEST(AssignClusters, NothingIsWithinReach)
{
    EXPECT_EQ(assignClusters({predictedCar(0.0, 0.0)}, {line({20.0, 0.0}, {21.0, 0.0})}, {}),
              (Assignment{{}}));
    EXPECT_EQ(assignClusters({}, {line({0, 0}, {1, 0})}, {}), Assignment{});
    EXPECT_EQ(assignClusters({predictedCar(0.0, 0.0)}, {}, {}), (Assignment{{}}));
}

TEST(AssignClusters, DoesNotDependOnTheOrderOfTargets)
{
    std::mt19937 generator(4);
    const auto uniform = [&](double a, double b)
    { return a + (b - a) * static_cast<double>(generator()) / 4294967295.0; };
    for (int round = 0; round < 50; ++round)
    {
        std::vector<PredictedTarget> targets;
        std::vector<Hits> clusters;
        for (int k = 0; k < 6; ++k)
        {
            const double x = uniform(0, 20);
            const double y = uniform(0, 10);
            targets.push_back(predictedCar(x, y, uniform(0.1, 0.5)));
            clusters.push_back(line({x - 1.0, y}, {x + uniform(0, 1.5), y}));
            clusters.push_back(line({x + uniform(-2, 2), y}, {x + 2, y + 0.2}));
        }
        const Assignment forward = assignClusters(targets, clusters, {});
        std::reverse(targets.begin(), targets.end());
        Assignment backward = assignClusters(targets, clusters, {});
        std::reverse(backward.begin(), backward.end());
        EXPECT_EQ(forward, backward) << round;
        std::vector<int> owners(clusters.size(), 0);
        for (const auto& taken : forward)
            for (const std::size_t i : taken) ++owners[i];
        EXPECT_LE(*std::max_element(owners.begin(), owners.end()), 1);
    }
}

// What braked behind a wall is where it may be along its way, not beside it.
TEST(AssignClusters, VagueAlongTheWayReachesAlongTheWay)
{
    PredictedTarget hidden = predictedCar(10.0, 0.0);
    hidden.positionSigma = {1.5, 0.2};
    const auto takes = [&](const Hits& hits)
    { return !assignClusters({hidden}, {hits}, {}).front().empty(); };
    EXPECT_TRUE(takes(line({5.2, -0.9}, {7.7, -0.9})));
    EXPECT_FALSE(takes(line({9.0, 2.9}, {11.5, 2.9})));
    hidden.positionSigma = {0.2, 1.5};
    EXPECT_FALSE(takes(line({4.0, 0.0}, {6.5, 0.0})));
    EXPECT_TRUE(takes(line({9.0, 2.9}, {11.5, 2.9})));
}

// Seen once, at the end of a revolution: where it is then in the next one is as open as its speed.
TEST(AssignClusters, ReachesAsFarAsATargetMayHaveMovedByTheTimeOfTheHits)
{
    constexpr double kSpeedSigma = 16.0;  // m/s
    const double lag = 0.08;
    PredictedTarget fast = predictedCar(10.0, 0.0);
    // Of a place that is exact at the lag, carried to the frame's time a revolution later.
    const double since = 0.1 - lag;
    fast.positionSigma = {kSpeedSigma * since, 0.0};
    fast.speedSigma = kSpeedSigma;
    fast.speedCovariance = kSpeedSigma * kSpeedSigma * since;
    const auto takes = [&](double moved, double time)
    {
        Hits end = line({12.25 + moved, -0.9}, {12.25 + moved, 0.9});
        end.time = time;
        return !assignClusters({fast}, {end}, {}).front().empty();
    };
    EXPECT_TRUE(takes(2.9, lag)) << "29 m/s";
    EXPECT_FALSE(takes(2.9, 0.0)) << "145 m/s";
    EXPECT_FALSE(takes(8.0, lag)) << "80 m/s";
}

TEST(AssignClusters, AVehicleIsNoPartOfTheHedgeAroundIt)
{
    const std::vector<Hits> clusters{line({8.0, -0.9}, {12.0, -0.9})};
    PredictedTarget hedge{{10.0, 0.0, 0.0, 12.0, 3.0}, {0.1, 0.1}};
    EXPECT_EQ(assignClusters({hedge}, clusters, {}, {true}), (Assignment{{0}}));
    hedge.isClutter = true;
    EXPECT_EQ(assignClusters({hedge}, clusters, {}, {false}), (Assignment{{0}}));
    EXPECT_EQ(assignClusters({hedge}, clusters, {}, {true}), (Assignment{{}}));
    EXPECT_EQ(assignClusters({hedge, predictedCar(10.0, 0.0)}, clusters, {}, {true}),
              (Assignment{{}, {0}}));
}

}  // namespace
}  // namespace vdamf
