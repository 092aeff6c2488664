// SPDX-License-Identifier: BSD-3-Clause
// Headings change for good reasons only.
#include "vdamf/tracking/estimation/heading_belief.h"

#include <gtest/gtest.h>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kDecisive = 5.0;

HeadingCues driving(double direction, double speed)
{
    HeadingCues cues;
    cues.course = {direction, speed};
    return cues;
}

HeadingBelief afterFrames(HeadingBelief belief, const HeadingCues& cues, int frames)
{
    for (int k = 0; k < frames; ++k) belief = belief.after(cues);
    return belief;
}

TEST(HeadingBelief, KnowsNothingOfFrontAndRearAtFirst)
{
    const HeadingBelief belief;
    EXPECT_DOUBLE_EQ(belief.forwardProbability(), 0.5);
    EXPECT_GT(belief.axesProbability(), 0.8);
    EXPECT_EQ(belief.turnDue(0.5), 0);
}

TEST(HeadingBelief, OneFrameTurnsNothing)
{
    EXPECT_EQ(HeadingBelief().after(driving(kPi, 8.0)).turnDue(kDecisive), 0);
    HeadingCues wide;
    wide.width = 4.2;
    wide.length = 1.7;
    EXPECT_EQ(HeadingBelief().after(wide).turnDue(kDecisive), 0);
}

TEST(HeadingBelief, DrivingBackwardsForLongTurnsByHalf)
{
    const HeadingBelief belief = afterFrames({}, driving(kPi, 8.0), 5);
    EXPECT_EQ(belief.turnDue(kDecisive), 2);
    EXPECT_LT(belief.forwardProbability(), 0.01);
    EXPECT_GT(belief.turned(2).forwardProbability(), 0.99);
}

TEST(HeadingBelief, WhoDroveForwardMayReverseSlowlyButNotFast)
{
    const HeadingBelief forward = afterFrames({}, driving(0.1, 8.0), 10);
    EXPECT_GT(forward.forwardProbability(), 0.999);
    EXPECT_EQ(afterFrames(forward, driving(kPi, 2.0), 100).turnDue(kDecisive), 0);
    EXPECT_EQ(afterFrames(forward, driving(kPi, 9.0), 20).turnDue(kDecisive), 2);
}

TEST(HeadingBelief, DrivingAcrossTurnsByAQuarter)
{
    EXPECT_EQ(afterFrames({}, driving(0.5 * kPi, 5.0), 6).turnDue(kDecisive), 1);
    EXPECT_EQ(afterFrames({}, driving(-0.5 * kPi, 5.0), 6).turnDue(kDecisive), 3);
}

TEST(HeadingBelief, SidesTakenForEndsTurnByAQuarterAndNeverBack)
{
    HeadingCues across;
    across.width = 4.3;
    across.length = 1.8;
    const HeadingBelief belief = afterFrames({}, across, 10);
    const int quarters = belief.turnDue(kDecisive);
    EXPECT_EQ(quarters % 2, 1);
    HeadingCues right;
    right.width = 1.8;
    right.length = 4.3;
    EXPECT_EQ(afterFrames(belief.turned(quarters), right, 50).turnDue(kDecisive), 0);
}

TEST(HeadingBelief, WideEndsOfTrucksAreEnds)
{
    HeadingCues truck;
    truck.width = 2.55;
    truck.widestEnd = 2.7;
    EXPECT_EQ(afterFrames({}, truck, 100).turnDue(kDecisive), 0);
    truck.widestEnd = 2.15;  // as low as a car
    EXPECT_EQ(afterFrames({}, truck, 100).turnDue(kDecisive) % 2, 1);
}

TEST(HeadingBelief, PolesAndPeopleTellNothing)
{
    HeadingCues small;
    small.width = 0.8;
    small.length = 0.6;
    const HeadingBelief belief = afterFrames({}, small, 100);
    EXPECT_NEAR(belief.axesProbability(), HeadingBelief().axesProbability(), 1e-9);
}

}  // namespace
}  // namespace vdamf
