// SPDX-License-Identifier: BSD-3-Clause
// Bushes do not grow by a car's length from one frame to the next.
#include "tracker/newcomers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vdamf
{
namespace
{
// Rows of hits from one place to another, 0.1 m apart.
void addRows(Cluster& cluster, float fromX, float toX, float y)
{
    for (float x = fromX; x < toX; x += 0.1F)
        for (const float height : {0.4F, 0.8F})
        {
            cluster.x.push_back(x);
            cluster.y.push_back(y);
            cluster.z.push_back(height);
            cluster.height.push_back(height);
            cluster.time.push_back(0.01F * x);
        }
}

// A bush from 9 to 11 m ahead, and what touches it, up to some x, m.
SegmentedFrame bushWith(float upTo)
{
    SegmentedFrame frame;
    frame.clusters.resize(1);
    addRows(frame.clusters[0], 9.0F, upTo, 4.0F);
    return frame;
}

// As it was before.
PredictedTarget bushBefore()
{
    PredictedTarget target;
    target.box = {10.0, 4.0, 0.0, 2.0, 0.2};
    target.isClutter = true;
    return target;
}

Track surelyABush()
{
    Track track;
    track.stoodProbability = 0.99;
    track.sightings = 5;
    track.judgement.probability = 0.005;
    return track;
}

SegmentedFrame cutOff(const SegmentedFrame& frame,
                      const std::vector<PredictedTarget>& targets = {bushBefore()},
                      const std::vector<Track>& tracks = {surelyABush()})
{
    return withNewcomersCutOff(frame, targets, tracks, Clutter(targets), {});
}

std::size_t clustersOf(const SegmentedFrame& frame, const Track& track,
                       const PredictedTarget& target = bushBefore())
{
    return cutOff(frame, {target}, {track}).clusters.size();
}

TEST(Newcomers, AreClustersOfTheirOwn)
{
    const SegmentedFrame before = bushWith(15.0F);
    const SegmentedFrame frame = cutOff(before);
    ASSERT_EQ(frame.clusters.size(), 2U);
    const Cluster& bush = frame.clusters[0];
    const Cluster& car = frame.clusters[1];
    EXPECT_LT(*std::max_element(bush.x.begin(), bush.x.end()), 11.55F);
    EXPECT_GT(*std::min_element(car.x.begin(), car.x.end()), 11.45F);
    EXPECT_EQ(bush.size() + car.size(), before.clusters[0].size()) << "no hit is lost";
    ASSERT_EQ(car.time.size(), car.size());
    EXPECT_EQ(car.time.front(), 0.01F * car.x.front());
}

TEST(Newcomers, AreNoMoreThanALittleOfTheSame)
{
    EXPECT_EQ(clustersOf(bushWith(11.4F), surelyABush()), 1U);
    EXPECT_EQ(clustersOf(bushWith(12.3F), surelyABush()), 1U) << "16 hits over 0.8 m";
    EXPECT_EQ(clustersOf(bushWith(13.0F), surelyABush()), 2U);
}

// 14 hits to each side of it: of one thing they would be enough.
TEST(Newcomers, AreOneThingEach)
{
    SegmentedFrame frame;
    frame.clusters.resize(1);
    addRows(frame.clusters[0], 7.8F, 12.2F, 4.0F);
    const SegmentedFrame after = cutOff(frame);
    ASSERT_EQ(after.clusters.size(), 1U);
    EXPECT_EQ(after.clusters[0].x, frame.clusters[0].x);
}

TEST(Newcomers, LeaveOtherHitsLoose)
{
    SegmentedFrame frame = bushWith(15.0F);
    addRows(frame.clusters[0], 8.2F, 8.35F, 4.0F);
    const SegmentedFrame after = cutOff(frame);
    ASSERT_EQ(after.clusters.size(), 2U);
    EXPECT_EQ(after.loose.size(), 4U);
    EXPECT_EQ(after.clusters[0].size() + after.clusters[1].size() + 4U, frame.clusters[0].size());
}

TEST(Newcomers, TouchOnlyWhatStandsAndSurelyIsNoVehicle)
{
    const SegmentedFrame frame = bushWith(15.0F);
    Track track = surelyABush();
    track.judgement.probability = 0.05;
    EXPECT_EQ(clustersOf(frame, track), 1U) << "it may be a part of a truck";
    track = surelyABush();
    track.stoodProbability = 0.1;
    EXPECT_EQ(clustersOf(frame, track), 1U);
    track = surelyABush();
    track.misses = 1;
    EXPECT_EQ(clustersOf(frame, track), 1U) << "it comes into view again";
    track = surelyABush();
    track.sightings = 2;
    EXPECT_EQ(clustersOf(frame, track), 1U);
    PredictedTarget mayBeOne = bushBefore();
    mayBeOne.isClutter = false;
    EXPECT_EQ(clustersOf(frame, surelyABush(), mayBeOne), 1U);
}

TEST(Newcomers, AreNotToldFromHedgesThatComeIntoView)
{
    SegmentedFrame frame;
    frame.clusters.resize(1);
    addRows(frame.clusters[0], 10.0F, 22.0F, 4.0F);
    PredictedTarget hedge = bushBefore();
    hedge.box = {13.5, 4.0, 0.0, 7.0, 0.2};
    EXPECT_EQ(clustersOf(frame, surelyABush(), hedge), 1U);
}

TEST(Newcomers, AreNotToldWhereSeveralThingsStand)
{
    PredictedTarget other = bushBefore();
    other.box.x = 14.0;
    const auto frame =
        cutOff(bushWith(15.0F), {bushBefore(), other}, {surelyABush(), surelyABush()});
    EXPECT_EQ(frame.clusters.size(), 1U);
}

}  // namespace
}  // namespace vdamf
