// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/association/shared_clusters.h"

#include <gtest/gtest.h>

#include "tracking/association/predicted_car.h"
#include "tracking/joined_clusters.h"
#include "vdamf/tracking/matched_filter/hits.h"

namespace vdamf
{
namespace
{
// Hits along the lines from corner to corner.
Cluster outline(const std::vector<Eigen::Vector2d>& corners, int hitsALine = 25)
{
    Cluster cluster;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
        for (int i = 0; i < hitsALine; ++i)
        {
            const Eigen::Vector2d p =
                corners[k] + (corners[k + 1] - corners[k]) * ((i + 0.5) / hitsALine);
            cluster.x.push_back(static_cast<float>(p.x()));
            cluster.y.push_back(static_cast<float>(p.y()));
            cluster.z.push_back(0.5F);
            cluster.height.push_back(0.5F + 0.01F * static_cast<float>(i));
            cluster.time.push_back(0.001F * static_cast<float>(i));
        }
    return cluster;
}

// Rear and right side of a car with its centre at (x, y).
std::vector<Eigen::Vector2d> rearAndSide(double x, double y, double length = 4.5)
{
    return {{x - 0.5 * length, y + 0.9}, {x - 0.5 * length, y - 0.9}, {x + 0.5 * length, y - 0.9}};
}

std::vector<SharedCluster> shared(const std::vector<PredictedTarget>& targets,
                                  const Cluster& cluster)
{
    return sharedClusters(targets, {projectHits(cluster, 0.1)}, {});
}

TEST(SharedClusters, ThatOfTwoCarsSideBySide)
{
    const Cluster both = together(outline(rearAndSide(10.0, 0.0)), outline(rearAndSide(10.5, 2.4)));
    const auto found =
        shared({predictedCar(10.1, 0.1), predictedCar(30.0, 0.0), predictedCar(10.4, 2.5)}, both);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].cluster, 0U);
    EXPECT_EQ(found[0].targets, (std::vector<std::size_t>{0, 2}));
}

TEST(SharedClusters, ThatOfTwoOfThreeParkedCars)
{
    const Cluster both = together(outline(rearAndSide(14.8, 0.0)), outline(rearAndSide(19.6, 0.0)));
    const auto found =
        shared({predictedCar(10.0, 0.0), predictedCar(14.8, 0.0), predictedCar(19.6, 0.0)}, both);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].targets, (std::vector<std::size_t>{1, 2})) << "the first one has no hits";
}

TEST(SharedClusters, ThatOfTwoThatPassHalfAMetreApart)
{
    // Turned by four degrees, as its heading errs, a corner of one box lies in the other.
    const Cluster both = together(outline(rearAndSide(10.0, 0.0)), outline(rearAndSide(11.0, 2.3)));
    PredictedTarget turned = predictedCar(11.0, 1.93);
    turned.box.heading = 0.07;
    turned.isBounded = true;
    EXPECT_EQ(shared({predictedCar(10.0, 0.0), turned}, both).size(), 1U);
    turned.isBounded = false;
    EXPECT_TRUE(shared({predictedCar(10.0, 0.0), turned}, both).empty()) << "no vehicle for sure";
    turned.isBounded = true;
    turned.box.y = 1.2;
    EXPECT_TRUE(shared({predictedCar(10.0, 0.0), turned}, both).empty()) << "one on the other";
}

TEST(SharedClusters, ThatOfACarBehindOneOfTwentyTimesItsHits)
{
    const Cluster both =
        together(outline(rearAndSide(5.0, 0.0), 400), outline(rearAndSide(9.8, 0.0), 20));
    PredictedTarget behind = predictedCar(9.8, 0.0);
    behind.isBounded = true;
    EXPECT_TRUE(shared({predictedCar(5.0, 0.0), behind}, both).empty())
        << "seen with who knows what";
    behind.hits = 40.0;
    EXPECT_EQ(shared({predictedCar(5.0, 0.0), behind}, both).size(), 1U);
    behind.isBounded = false;
    EXPECT_TRUE(shared({predictedCar(5.0, 0.0), behind}, both).empty()) << "no vehicle for sure";
    behind.isBounded = true;
    behind.hits = 400.0;
    EXPECT_TRUE(shared({predictedCar(5.0, 0.0), behind}, both).empty()) << "it had far more hits";
}

TEST(SharedClusters, NotThatOfOneCarBesideAnother)
{
    const Cluster one = outline(rearAndSide(10.0, 0.0));
    EXPECT_TRUE(shared({predictedCar(10.1, 0.1), predictedCar(10.4, 2.5)}, one).empty());
}

TEST(SharedClusters, NotThatOfACarWithTwoTracks)
{
    const Cluster one = outline(rearAndSide(10.0, 0.0, 8.0));
    EXPECT_TRUE(shared({predictedCar(8.5, 0.0), predictedCar(11.5, 0.2)}, one).empty());
}

TEST(SharedClusters, NotThatOfATruckThatComesIntoView)
{
    // Its predicted box is the part that was seen so far; beside the rest stands a car.
    const Cluster truck = outline(rearAndSide(12.0, 0.0, 9.0), 50);
    EXPECT_TRUE(shared({predictedCar(9.75, 0.0), predictedCar(16.0, -2.9)}, truck).empty());
}

TEST(SharedClusters, NotWhereATargetsPlaceIsVague)
{
    const Cluster both = together(outline(rearAndSide(10.0, 0.0)), outline(rearAndSide(10.5, 2.4)));
    EXPECT_TRUE(shared({predictedCar(10.1, 0.1), predictedCar(10.4, 2.5, 1.5)}, both).empty());
}

TEST(SharedClusters, NothingToFind)
{
    EXPECT_TRUE(sharedClusters({}, {Hits{}}, {}).empty());
    EXPECT_TRUE(
        sharedClusters({predictedCar(0.0, 0.0), predictedCar(1.0, 0.0)}, {Hits{}}, {}).empty());
}

TEST(CutBetween, GivesEachTargetItsHits)
{
    const Cluster a = outline(rearAndSide(10.0, 0.0));
    const Cluster b = outline(rearAndSide(10.5, 2.4), 15);
    const std::vector<Cluster> pieces =
        cutBetween(together(a, b), {predictedCar(10.1, 0.1), predictedCar(10.4, 2.5)}, 0.0, {});
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].x, a.x);
    EXPECT_EQ(pieces[0].height, a.height);
    EXPECT_EQ(pieces[0].time, a.time);
    EXPECT_EQ(pieces[1].y, b.y);
    EXPECT_EQ(pieces[1].z, b.z);
}

TEST(CutBetween, MovesTheBoxesToTheTimeOfTheCluster)
{
    PredictedTarget fast = predictedCar(8.0, 0.0);
    fast.velocity = {20.0, 0.0};
    const Cluster a = outline(rearAndSide(10.0, 0.0));
    const std::vector<Cluster> pieces = cutBetween(a, {fast, predictedCar(4.4, 0.0)}, 0.1, {});
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].size(), a.size());
}

}  // namespace
}  // namespace vdamf
