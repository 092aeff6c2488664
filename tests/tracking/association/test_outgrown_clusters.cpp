// SPDX-License-Identifier: BSD-3-Clause
#include "association/outgrown_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tracking/sensor_at_origin.h"

namespace vdamf
{
namespace
{
void addLine(Cluster& to, const Eigen::Vector2f& from, const Eigen::Vector2f& end, int hits,
             float time = 0.0F)
{
    for (int i = 0; i < hits; ++i)
    {
        const Eigen::Vector2f p =
            from + (end - from) * static_cast<float>(i) / static_cast<float>(hits);
        to.x.push_back(p.x());
        to.y.push_back(p.y());
        to.z.push_back(0.5F);
        to.height.push_back(0.5F);
        to.time.push_back(time);
    }
}

// Rear and left side of the car below.
Cluster carAlone(float ahead = 0.0F, float time = 0.0F)
{
    Cluster cluster;
    addLine(cluster, {10.0F + ahead, -4.75F}, {10.0F + ahead, -3.0F}, 20, time);
    addLine(cluster, {10.0F + ahead, -3.0F}, {14.5F + ahead, -3.0F}, 20, time);
    return cluster;
}

// With a hedge along its far side.
Cluster carAndHedge(float ahead = 0.0F, float time = 0.0F)
{
    Cluster cluster = carAlone(ahead, time);
    addLine(cluster, {4.0F, -4.9F}, {24.0F, -4.9F}, 100, time);
    return cluster;
}

PredictedTarget car()
{
    PredictedTarget target;
    target.box = {12.25, -3.9, 0.0, 4.5, 1.8};
    target.positionSigma = {0.1, 0.1};
    target.lengthSigma = target.widthSigma = 0.1;
    target.isBounded = true;
    return target;
}

// Of which no more than the width is known.
PredictedTarget drivingTruck(const OrientedBox& box)
{
    PredictedTarget target;
    target.box = box;
    target.positionSigma = {1.0, 0.1};
    target.lengthSigma = 2.0;
    target.widthSigma = 0.1;
    target.isDrivingTruck = true;
    return target;
}

std::optional<CutCluster> cut(const Cluster& cluster, const PredictedTarget& vehicle)
{
    return KnownVehicles({vehicle}, {}).cut(cluster, boundsOf(cluster), kSensor);
}

TEST(OutgrownClusters, TheCarAndTheHedgeBehindIt)
{
    const auto parts = cut(carAndHedge(), car());
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 1U);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
    EXPECT_EQ(parts->rest.size(), 100U) << "the hedge is 10 cm behind the car's far side";
    EXPECT_EQ(parts->rest.time.size(), 100U);
}

TEST(OutgrownClusters, NotThatOfTheCarAlone)
{
    EXPECT_FALSE(cut(carAlone(), car()));
    PredictedTarget shorter = car();
    shorter.box.length = 4.0;
    EXPECT_FALSE(cut(carAlone(), shorter)) << "it may grow";
}

TEST(OutgrownClusters, TheFrontOfACarAndTheBushBeforeIt)
{
    Cluster both;
    addLine(both, {13.5F, -3.0F}, {14.5F, -3.0F}, 12);
    addLine(both, {14.6F, -3.2F}, {17.5F, -3.2F}, 25);  // together they are as long as the car
    PredictedTarget known = car();
    known.endSigma = {0.05, 0.05};
    const auto parts = cut(both, known);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 1U);
    EXPECT_EQ(parts->vehicles[0].size(), 12U);
    known.endSigma = {0.2, 0.05};
    EXPECT_TRUE(cut(both, known)) << "wherever its rear is";
    known.endSigma = {0.05, 0.2};
    EXPECT_FALSE(cut(both, known)) << "it may be there";
}

// What is cut off behind a rear that is known leaves the car what its unknown length may show.
TEST(OutgrownClusters, ACarOfUnknownLengthKeepsWhatGoesOnPastItsFront)
{
    Cluster both = carAlone();
    addLine(both, {14.6F, -3.0F}, {15.0F, -3.0F}, 10);  // its side is longer than was assumed
    addLine(both, {6.0F, -3.2F}, {9.0F, -3.2F}, 25);    // a bush before its rear
    PredictedTarget known = car();
    known.lengthSigma = 0.6;
    known.endSigma = {0.05, 0.6};
    const auto parts = cut(both, known);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 1U);
    EXPECT_EQ(parts->vehicles[0].size(), 50U);
    EXPECT_EQ(parts->rest.size(), 25U);
    known.lengthSigma = 0.1;
    known.endSigma = {0.05, 0.1};
    const auto sure = cut(both, known);
    ASSERT_TRUE(sure);
    EXPECT_EQ(sure->vehicles[0].size(), 40U) << "it ends there";
}

// The bush that is cut off stands beyond its front, which is known.
TEST(OutgrownClusters, ACarOfUnknownLengthHasNothingBehindTheEndThatIsKnown)
{
    Cluster both = carAlone();
    addLine(both, {14.7F, -3.2F}, {18.0F, -3.2F}, 33);
    PredictedTarget known = car();
    known.lengthSigma = 0.6;
    known.endSigma = {0.6, 0.05};
    const auto parts = cut(both, known);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
    EXPECT_EQ(parts->rest.size(), 33U);
}

TEST(OutgrownClusters, NotByWhatIsNotKnown)
{
    PredictedTarget perhaps = car();
    perhaps.isBounded = false;
    EXPECT_FALSE(cut(carAndHedge(), perhaps));
    PredictedTarget vague = car();
    vague.positionSigma = {1.0, 0.1};
    EXPECT_FALSE(cut(carAndHedge(), vague));
    PredictedTarget ofAnySize = car();
    ofAnySize.lengthSigma = ofAnySize.widthSigma = 0.5;
    EXPECT_FALSE(cut(carAndHedge(), ofAnySize));
}

TEST(OutgrownClusters, ATruckThatDrivesAndWhatItPasses)
{
    const PredictedTarget truck = drivingTruck({14.5, -3.9, 0.0, 9.0, 2.4});
    Cluster both;
    addLine(both, {10.0F, -5.1F}, {10.0F, -2.7F}, 30);
    addLine(both, {20.0F, -2.7F}, {24.0F, -2.7F}, 10);  // farther than it seemed to reach
    addLine(both, {10.5F, -8.2F}, {10.5F, -5.7F}, 25);  // a parked bus
    const auto parts = cut(both, truck);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 1U);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
    EXPECT_EQ(parts->rest.size(), 25U);
    PredictedTarget vague = truck;
    vague.positionSigma.y() = 0.6;
    EXPECT_FALSE(cut(both, vague));
    vague = truck;
    vague.widthSigma = 0.5;
    EXPECT_FALSE(cut(both, vague));
}

// Two vehicles that stand and drive beside each other have all hits between them.
TEST(OutgrownClusters, ATruckThatDrivesAndAKnownVehicleThatItPasses)
{
    const PredictedTarget truck = drivingTruck({17.5, -1.2, 0.0, 5.0, 2.4});
    Cluster both = carAlone();
    addLine(both, {15.0F, -2.4F}, {15.0F, 0.0F}, 30);
    const auto parts = KnownVehicles({truck, car()}, {}).cut(both, boundsOf(both), kSensor);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 2U);
    EXPECT_EQ(parts->vehicles[0].size(), 40U) << "the car's first";
    EXPECT_EQ(parts->vehicles[1].size(), 30U);
    EXPECT_EQ(parts->rest.size(), 0U);
    PredictedTarget ends = truck;
    ends.isDrivingTruck = false;
    ends.isBounded = true;
    ends.positionSigma.x() = 0.1;
    EXPECT_FALSE(KnownVehicles({ends, car()}, {}).cut(both, boundsOf(both), kSensor))
        << "they meet at a line";
}

TEST(OutgrownClusters, NotByAnAssumedLength)
{
    Cluster lorry;
    addLine(lorry, {10.0F, -4.75F}, {10.0F, -3.0F}, 20);
    addLine(lorry, {10.0F, -3.0F}, {19.0F, -3.0F}, 20);
    EXPECT_TRUE(cut(lorry, car()));
    PredictedTarget seenFromBehind = car();
    seenFromBehind.lengthSigma = 0.45;
    EXPECT_FALSE(cut(lorry, seenFromBehind));
}

TEST(OutgrownClusters, NotWhereTheCarHasNoHits)
{
    Cluster hedge;
    addLine(hedge, {4.0F, -4.9F}, {24.0F, -4.9F}, 100);
    EXPECT_FALSE(cut(hedge, car()));
}

TEST(OutgrownClusters, HitsLieWhereTheCarIsAtTheirTime)
{
    PredictedTarget fast = car();
    fast.velocity = {20.0, 0.0};
    const auto parts = cut(carAndHedge(2.0F, 0.1F), fast);
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
}

TEST(OutgrownClusters, OfTwoCarsEachHasItsOwn)
{
    Cluster both = carAndHedge();
    addLine(both, {17.0F, -4.75F}, {17.0F, -3.0F}, 15);
    PredictedTarget ahead = car();
    ahead.box.x += 7.0;
    const auto parts = KnownVehicles({car(), ahead}, {}).cut(both, boundsOf(both), kSensor);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 2U);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
    EXPECT_EQ(parts->vehicles[1].size(), 15U);
}

TEST(OutgrownClusters, OfACarWithHardlyAnyHitsTheyStayWithTheRest)
{
    Cluster both = carAndHedge();
    addLine(both, {17.0F, -4.75F}, {17.0F, -3.0F}, 3);
    PredictedTarget ahead = car();
    ahead.box.x += 7.0;
    const auto parts = KnownVehicles({car(), ahead}, {}).cut(both, boundsOf(both), kSensor);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->vehicles.size(), 1U);
    EXPECT_EQ(parts->vehicles[0].size(), 40U);
    EXPECT_EQ(parts->rest.size(), 103U);
}

}  // namespace
}  // namespace vdamf
