// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/convex_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tracking/joined_clusters.h"
#include "tracking/sensor_at_origin.h"

namespace vdamf
{
namespace
{
// Hits along a path, every 5 cm, with the noise of a LADAR.
Cluster along(const std::vector<Eigen::Vector2d>& path, float height = 0.7F)
{
    std::mt19937 generator(3);
    std::normal_distribution<float> noise(0.0F, 0.02F);
    Cluster cluster;
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
    {
        const Eigen::Vector2d step = path[k + 1] - path[k];
        const int count = static_cast<int>(step.norm() / 0.05);
        for (int i = 0; i < count; ++i)
        {
            const Eigen::Vector2f p = (path[k] + step * i / count).cast<float>();
            cluster.x.push_back(p.x() + noise(generator));
            cluster.y.push_back(p.y() + noise(generator));
            cluster.z.push_back(height);
            cluster.height.push_back(height);
        }
    }
    return cluster;
}

// Left side and rear of a car ahead to the right, as seen from the sensor.
const std::vector<Eigen::Vector2d> kCarOutline = {{10.0, -4.8}, {10.0, -3.0}, {14.5, -3.0}};

TEST(ConvexPieces, AVehicleHasNoDents)
{
    EXPECT_TRUE(convexPieces(along(kCarOutline), kSensor).empty());
    EXPECT_TRUE(convexPieces(along({{10.0, -1.0}, {10.0, 1.0}}), kSensor).empty());
    EXPECT_TRUE(convexPieces(Cluster(), kSensor).empty());
}

TEST(ConvexPieces, AWheelHouseIsNone)
{
    const Cluster car = along({{10.0, -4.8},
                               {10.0, -3.0},
                               {11.0, -3.0},
                               {11.0, -3.3},
                               {11.6, -3.3},
                               {11.6, -3.0},
                               {14.5, -3.0}});
    EXPECT_TRUE(convexPieces(car, kSensor).empty());
}

TEST(ConvexPieces, ACarAndTheHedgeThatItStandsBefore)
{
    const Cluster car = along(kCarOutline);
    const auto pieces = convexPieces(together(along({{6.0, -4.8}, {10.0, -4.8}}), car), kSensor);
    ASSERT_EQ(pieces.size(), 2U);
    // Counter-clockwise: the hedge, then the car.
    EXPECT_LT(*std::max_element(pieces[0].x.begin(), pieces[0].x.end()), 10.3F);
    EXPECT_GT(*std::min_element(pieces[1].x.begin(), pieces[1].x.end()), 9.7F);
    EXPECT_NEAR(static_cast<double>(pieces[1].size()), static_cast<double>(car.size()), 10.0);
}

TEST(ConvexPieces, ACarBetweenTwoPartsOfAWall)
{
    const Cluster both =
        together(along({{4.0, -5.0}, {9.9, -5.0}}), along({{26.0, -5.0}, {32.0, -5.0}}));
    EXPECT_EQ(convexPieces(together(both, along(kCarOutline)), kSensor).size(), 3U);
}

TEST(ConvexPieces, WhatHangsOverACarIsNoPartOfItsOutline)
{
    const Cluster crown = along({{9.0, -2.0}, {9.0, -1.0}, {9.5, -1.0}}, 2.5F);
    EXPECT_TRUE(convexPieces(together(along(kCarOutline), crown), kSensor).empty());
}

TEST(ConvexPieces, BehindTheSensorTheyAreTheSame)
{
    // Across the bearing at which turns begin anew.
    Cluster cluster = along({{6.0, -1.0}, {10.0, -1.0}, {10.0, 0.8}});
    EXPECT_EQ(convexPieces(cluster, kSensor).size(), 2U);
    for (float& x : cluster.x) x = -x;
    EXPECT_EQ(convexPieces(cluster, kSensor).size(), 2U);
}

TEST(ConvexPieces, AroundMostOfTheSensorTheyAreTheSameWhicheverWayItLooks)
{
    // A yard open to one side, with a niche in its rear wall.
    const std::vector<Eigen::Vector2d> yard = {{-6.0, -5.0}, {8.0, -5.0}, {8.0, -1.0}, {11.0, -1.0},
                                               {11.0, 1.0},  {8.0, 1.0},  {8.0, 5.0},  {-6.0, 5.0}};
    const std::size_t count = convexPieces(along(yard), kSensor).size();
    EXPECT_GE(count, 4U);
    for (const double turned : {0.5 * kPi, kPi, 1.5 * kPi})
    {
        std::vector<Eigen::Vector2d> path = yard;
        for (Eigen::Vector2d& p : path) p = rotation(turned) * p;
        EXPECT_EQ(convexPieces(along(path), kSensor).size(), count) << turned;
    }
}

}  // namespace
}  // namespace vdamf
