// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/one_time.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
// The rear of a car, hit at its bottom and 20 ms later, 0.2 m farther on, at its top.
SegmentedFrame rearInTwoShots(bool timed)
{
    Cluster rear;
    for (const float y : {-0.5F, 0.0F, 0.5F})
        for (const float later : {0.0F, 0.02F})
        {
            rear.x.push_back(20.0F + 10.0F * later);
            rear.y.push_back(y);
            rear.height.push_back(0.5F + 20.0F * later);
            rear.z.push_back(rear.height.back());
            if (timed) rear.time.push_back(later);
        }
    SegmentedFrame frame;
    frame.clusters.push_back(rear);
    frame.hits.push_back(projectHits(rear, 0.0));
    return frame;
}

TargetMotion tenMetresPerSecond()
{
    TargetMotion motion;
    motion.centre = {22.0, 0.0};
    motion.velocity = {10.0, 0.0};
    return motion;
}

TEST(OneTime, EachHitIsBroughtToTheMeanTimeWithItsHeight)
{
    const HitsAtOneTime seen = hitsAtOneTime(rearInTwoShots(true), {0}, tenMetresPerSecond(), 0.0);
    EXPECT_NEAR(seen.lag, 0.01, 1e-6);
    ASSERT_EQ(seen.each->size(), 6U);
    for (std::size_t i = 0; i < seen.each->size(); ++i)
    {
        EXPECT_NEAR(seen.each->x[i], 20.1, 1e-5) << i;
        EXPECT_NEAR(seen.hits->x[i], 20.1, 1e-5) << i;
        EXPECT_NEAR(seen.each->height[i], i % 2 == 0 ? 0.5 : 0.9, 1e-6) << i;
    }
}

TEST(OneTime, HitsWithoutTimesStayWhereTheyAre)
{
    const SegmentedFrame frame = rearInTwoShots(false);
    const HitsAtOneTime seen = hitsAtOneTime(frame, {0}, tenMetresPerSecond(), 0.0);
    EXPECT_EQ(seen.lag, 0.0);
    ASSERT_EQ(seen.each->size(), 6U);
    for (std::size_t i = 0; i < seen.each->size(); ++i)
        EXPECT_NEAR(seen.each->x[i], i % 2 == 0 ? 20.0 : 20.2, 1e-5) << i;
    EXPECT_EQ(&*seen.hits, &frame.hits.front()) << "copied for nothing";
}

// The left half of a car's rear, and a revolution later, 1 m farther on, the right one.
SegmentedFrame rearInHalves()
{
    Cluster rear;
    for (int i = 0; i < 5; ++i)
        for (const float side : {1.0F, -1.0F})
        {
            const float time = side > 0.0F ? 0.0F : 0.1F;
            rear.x.push_back(20.0F + 10.0F * time);
            rear.y.push_back(side * (0.1F + 0.2F * static_cast<float>(i)));
            rear.z.push_back(0.5F);
            rear.height.push_back(0.5F);
            rear.time.push_back(time);
        }
    SegmentedFrame frame;
    frame.clusters.push_back(rear);
    frame.hits.push_back(projectHits(rear, 0.0));
    return frame;
}

TEST(OneTime, PartsOfTwoRevolutionsMayBeTurnedWhileTheSpeedChanges)
{
    TargetMotion motion = tenMetresPerSecond();
    motion.speedSigma = 0.3;
    motion.changes = 0.4;
    const HitsAtOneTime seen = hitsAtOneTime(rearInHalves(), {0}, motion, 0.0);
    EXPECT_TRUE(seen.areParts);
    EXPECT_EQ(seen.each->size(), 10U);
    // 0.5 m/s over 0.1 s, between halves whose middles are 1 m apart.
    EXPECT_NEAR(seen.turnSigma, 0.05, 1e-3);
    motion.velocity = {0.0, 0.0};
    EXPECT_EQ(hitsAtOneTime(rearInHalves(), {0}, motion, 0.0).turnSigma, 0.0) << "it stands";
    motion.speedSigma = 16.0;
    const HitsAtOneTime part = hitsAtOneTime(rearInHalves(), {0}, motion, 0.0);
    EXPECT_EQ(part.each->size(), 5U);
    EXPECT_TRUE(part.goesOn);
    EXPECT_EQ(part.turnSigma, 0.0);
    EXPECT_FALSE(hitsAtOneTime(rearInTwoShots(true), {0}, motion, 0.0).areParts);
}

// The side of a car beside the sensor, which turns past it for 40 ms; or its ends alone.
SegmentedFrame sideOverLongTime(bool hasGap)
{
    Cluster side;
    for (int i = 0; i <= 40; ++i)
    {
        if (hasGap && i > 4 && i < 36) continue;
        side.x.push_back(0.1F * static_cast<float>(i) - 2.0F);
        side.y.push_back(2.0F);
        side.z.push_back(0.5F);
        side.height.push_back(0.5F);
        side.time.push_back(0.001F * static_cast<float>(i));
    }
    SegmentedFrame frame;
    frame.clusters.push_back(side);
    frame.hits.push_back(projectHits(side, 0.0));
    return frame;
}

TEST(OneTime, WhatIsCloseIsHitForLongAndWhole)
{
    TargetMotion unknown;
    unknown.speedSigma = 16.0;
    const HitsAtOneTime seen = hitsAtOneTime(sideOverLongTime(false), {0}, unknown, 0.0);
    EXPECT_FALSE(seen.areParts);
    EXPECT_FALSE(seen.goesOn);
    EXPECT_EQ(seen.each->size(), 41U);
    EXPECT_TRUE(hitsAtOneTime(sideOverLongTime(true), {0}, unknown, 0.0).areParts);
}
}  // namespace
}  // namespace vdamf
