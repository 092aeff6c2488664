// SPDX-License-Identifier: BSD-3-Clause
// What becomes of pose samples is counted.
#include <gtest/gtest.h>

#include "example_car.h"

namespace vdamf
{
namespace
{
using test::kStart;
using test::robotPose;

TEST(InsReportTest, CountsWhatHappensToSamples)
{
    InsTrajectory ins{InsOptions{}};
    for (int i = 0; i < 100; ++i)
    {
        if (i >= 40 && i < 50) continue;  // 1.1 s
        ins.insert(robotPose(0.1 * i));
        if (i == 20) ins.insert(robotPose(1.95));
        if (i == 30) ins.insert(robotPose(3.0));
    }
    auto unstamped = robotPose(1.0);
    unstamped.timestamp = INVALID_TIMESTAMP;
    ins.insert(unstamped);
    ins.insert(robotPose(5.05));  // 4.85 s back
    ASSERT_TRUE(ins.at(kStart + 9.0));
    ins.forgetBefore(kStart + 9.0);
    const InsReport report = ins.report();
    EXPECT_EQ(report.taken, 92U);
    EXPECT_EQ(report.outOfOrder, 2U);
    EXPECT_EQ(report.duplicates, 1U);
    EXPECT_EQ(report.impossible, 1U);
    EXPECT_EQ(report.timeJumps, 1U);
    EXPECT_EQ(report.gaps, 1U);
    EXPECT_NEAR(report.longestGap, 1.1, 1e-6);
    EXPECT_NEAR(report.firstGapAt, kStart + 3.9, 1e-6);
}

TEST(InsReportTest, AStampFarAheadEndsNoWaiting)
{
    InsTrajectory ins{InsOptions{}};
    ins.insert(robotPose(0.0));
    ins.insert(robotPose(1e6));
    ins.insert(robotPose(0.1));
    EXPECT_TRUE(ins.covers(kStart + 0.1));
    EXPECT_FALSE(ins.covers(kStart + 0.2));
}

}  // namespace
}  // namespace vdamf
