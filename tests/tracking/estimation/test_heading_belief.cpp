// SPDX-License-Identifier: BSD-3-Clause
// Headings change for good reasons only.
#include "vdamf/tracking/estimation/heading_belief.h"

#include <gtest/gtest.h>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kDecisive = 3.0;  // as for tracks that are not young

HeadingCues driving(double direction, double speed)
{
    HeadingCues cues;
    cues.course = {direction, speed};
    return cues;
}

// Faces seen from end to end.
HeadingCues seen(std::optional<double> side, std::optional<double> end, double height = 1.5)
{
    HeadingCues cues;
    if (side) cues.side = {*side, 1.0};
    if (end) cues.end = {*end, 1.0};
    cues.height = height;
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
    EXPECT_DOUBLE_EQ(belief.axesProbability(), 0.5);
    EXPECT_EQ(belief.turnDue(0.5), 0);
}

TEST(HeadingBelief, StartsFromWhatTheFirstSightingTellsOfTheAxes)
{
    EXPECT_GT(HeadingBelief(seen(4.3, 1.8)).axesProbability(), 0.95);
    EXPECT_LT(HeadingBelief(seen(1.8, 4.3)).axesProbability(), 0.05);
}

TEST(HeadingBelief, NeighboursTellTheAxesWhileTheyAreThereAndSizesOutweighThem)
{
    HeadingCues across;
    across.neighbours = -3.0;
    const HeadingBelief among = afterFrames({}, across, 10);
    EXPECT_LT(among.axesProbability(), 0.1);
    EXPECT_DOUBLE_EQ(among.ownAxesProbability(), 0.5);
    EXPECT_DOUBLE_EQ(among.turned(1).axesProbability(), 1.0 - among.axesProbability());
    EXPECT_DOUBLE_EQ(among.after({}).axesProbability(), 0.5);
    HeadingCues both = seen(4.3, 1.8);
    both.neighbours = -3.0;
    EXPECT_EQ(afterFrames({}, both, 10).turnDue(0.0), 0);
}

TEST(HeadingBelief, VehiclesInLineTellTheFrontUntilItDrives)
{
    HeadingCues behind;
    behind.inLine = -4.0;
    const HeadingBelief reversed = HeadingBelief().after(behind);
    EXPECT_LT(reversed.forwardProbability(), 0.05);
    EXPECT_DOUBLE_EQ(reversed.forwardProbabilityByCourse(), 0.5);
    EXPECT_NEAR(reversed.axesProbability(), 0.5, 1e-12) << "of the axes they tell nothing";
    EXPECT_EQ(reversed.turnDue(2.5), 2);
    EXPECT_GT(reversed.turned(2).forwardProbability(), 0.95);
    EXPECT_DOUBLE_EQ(reversed.turned(1).forwardProbability(), 0.5);
    EXPECT_DOUBLE_EQ(reversed.after({}).forwardProbability(), 0.5) << "while they are there";
    HeadingCues drives = driving(0.0, 6.0);
    drives.inLine = -4.0;
    EXPECT_EQ(afterFrames({}, drives, 10).turnDue(2.5), 0);
}

TEST(HeadingBelief, ItsShapeTellsTheFrontOfWhatStandsButNotOfWhatDrives)
{
    HeadingCues shape;
    shape.shape = -2.0;
    EXPECT_LT(HeadingBelief(shape).forwardProbability(), 0.2) << "from the first sighting on";
    const HeadingBelief standing = afterFrames({}, shape, 20);
    EXPECT_EQ(standing.turnDue(kDecisive), 2);
    EXPECT_GT(standing.forwardProbability(), 0.01) << "all frames show the same";
    EXPECT_NEAR(standing.axesProbability(), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(standing.forwardProbabilityByCourse(), 0.5);
    EXPECT_NEAR(standing.turned(2).forwardProbabilityByShape(),
                1.0 - standing.forwardProbabilityByShape(), 1e-12);
    EXPECT_DOUBLE_EQ(standing.turned(1).forwardProbabilityByShape(), 0.5);
    HeadingCues drives = driving(0.0, 6.0);
    drives.shape = -2.0;
    EXPECT_EQ(afterFrames(standing, drives, 10).turnDue(0.0), 0);
}

TEST(HeadingBelief, WhichWayItMovesAlongAnAxisTellsNothingOfTheAxes)
{
    HeadingCues backwards;
    backwards.forth = 0.01;
    EXPECT_NEAR(afterFrames({}, backwards, 20).axesProbability(), 0.5, 1e-9);
}

TEST(HeadingBelief, AShortRowAfterALongOneIsAPartOfIt)
{
    HeadingCues part;
    part.end = {1.4, 0.2};
    EXPECT_GT(afterFrames({}, part, 20).axesProbability(), 0.5);
    HeadingCues once;
    once.end = {3.8, 0.4};
    EXPECT_LT(afterFrames(HeadingBelief().after(once), part, 5).axesProbability(), 0.05);
}

TEST(HeadingBelief, ARowThatIsLongForOnceIsForgotten)
{
    // Beside a hedge, of which one frame adds a part.
    const HeadingCues end = seen(std::nullopt, 1.8);
    const HeadingCues withHedge = seen(std::nullopt, 3.4);
    const HeadingBelief known(end);
    EXPECT_LT(known.after(withHedge).axesProbability(), 0.5);
    EXPECT_GT(afterFrames(known.after(withHedge), end, 3).axesProbability(), 0.9);
    EXPECT_LT(afterFrames(afterFrames(known, withHedge, 2), end, 3).axesProbability(), 0.5);
}

TEST(HeadingBelief, OneFrameTurnsNothingThatWasKnown)
{
    EXPECT_EQ(HeadingBelief().after(driving(kPi, 8.0)).turnDue(kDecisive), 0);
    EXPECT_EQ(HeadingBelief(seen(4.3, 1.8)).after(seen(1.7, 4.2)).turnDue(kDecisive), 0);
    EXPECT_EQ(afterFrames({}, seen(4.3, 1.8), 20).after(seen(1.7, 4.2)).turnDue(0.0), 0);
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

TEST(HeadingBelief, MovingBackwardsTellsTheFrontOfWhatIsNew)
{
    HeadingCues backwards;
    backwards.forth = 0.001;
    EXPECT_EQ(HeadingBelief().after(backwards).turnDue(2.5), 2);
    HeadingCues perhaps;
    perhaps.forth = 0.2;
    EXPECT_EQ(afterFrames({}, perhaps, 100).turnDue(2.5), 0);
    const HeadingBelief forward = afterFrames({}, driving(0.0, 3.0), 5);
    EXPECT_EQ(afterFrames(forward, backwards, 100).turnDue(0.0), 0);
}

TEST(HeadingBelief, WhatDrivesFastDoesSoForwardWhateverItsShape)
{
    HeadingCues drives;
    drives.forth = 1.0;
    drives.shape = -4.0;
    EXPECT_LT(afterFrames({}, drives, 10).forwardProbability(), 0.5);
    drives.fast = 1.0;
    EXPECT_GT(afterFrames({}, drives, 10).forwardProbability(), 0.9);
}

TEST(HeadingBelief, DrivingAcrossTurnsByAQuarter)
{
    EXPECT_EQ(afterFrames({}, driving(0.5 * kPi, 5.0), 6).turnDue(kDecisive), 1);
    EXPECT_EQ(afterFrames({}, driving(-0.5 * kPi, 5.0), 6).turnDue(kDecisive), 3);
}

TEST(HeadingBelief, ACourseOutweighsSizesThatWereSeenForLong)
{
    HeadingCues sideOfABicycle = seen(std::nullopt, 1.8);
    const HeadingBelief taken = afterFrames({}, sideOfABicycle, 100);
    EXPECT_GT(taken.axesProbability(), 0.99);
    sideOfABicycle.course = {0.5 * kPi, 5.0};
    EXPECT_EQ(afterFrames(taken, sideOfABicycle, 10).turnDue(3.0), 1);
}

TEST(HeadingBelief, SidesTakenForEndsTurnByAQuarterAndNeverBack)
{
    const HeadingBelief belief = afterFrames({}, seen(1.8, 4.3), 10);
    const int quarters = belief.turnDue(kDecisive);
    EXPECT_EQ(quarters % 2, 1);
    EXPECT_EQ(afterFrames(belief.turned(quarters), seen(4.3, 1.8), 50).turnDue(kDecisive), 0);
}

TEST(HeadingBelief, EndsTakenForSidesTurnEvenIfAMirrorMakesThemWide)
{
    EXPECT_EQ(afterFrames({}, seen(2.3, std::nullopt), 20).turnDue(kDecisive) % 2, 1);
    EXPECT_EQ(afterFrames({}, seen(2.7, std::nullopt, 3.0), 20).turnDue(kDecisive) % 2, 1);
}

TEST(HeadingBelief, APartThatIsTooLongForAnEndIsPartOfASide)
{
    HeadingCues part;
    part.end = {3.3, 0.0};
    EXPECT_EQ(afterFrames({}, part, 20).turnDue(kDecisive) % 2, 1);
    part.end = {1.5, 0.0};
    EXPECT_EQ(afterFrames({}, part, 100).turnDue(0.0), 0);
    HeadingCues partOfSide;
    partOfSide.side = {1.2, 0.0};
    EXPECT_EQ(afterFrames({}, partOfSide, 100).turnDue(kDecisive), 0);
}

TEST(HeadingBelief, ARowThatGrowsIsJudgedByAllOfIt)
{
    const auto endOf = [](double metres)
    {
        HeadingCues cues;
        cues.end = {metres, 0.3};
        return cues;
    };
    HeadingBelief belief(endOf(1.8));
    belief = belief.after(endOf(2.1));
    ASSERT_GT(belief.axesProbability(), 0.7);
    // It comes out of hiding: what looked like an end was a part of a side.
    belief = belief.after(endOf(2.8));
    EXPECT_LT(belief.axesProbability(), 0.4);
    // A row as long as before adds up.
    EXPECT_LT(belief.after(endOf(2.8)).axesProbability(), belief.axesProbability());
}

TEST(HeadingBelief, WeakEvidenceDoesNotGrowStrongByRepetition)
{
    HeadingCues vague;
    vague.end = {2.1, 0.0};
    const HeadingBelief some = afterFrames({}, vague, 10);
    EXPECT_DOUBLE_EQ(afterFrames(some, vague, 1000).axesProbability(), some.axesProbability());
}

TEST(HeadingBelief, CountsTheFramesThatLeaveItMoreLikelyAcross)
{
    HeadingCues across;
    across.neighbours = -1.5;
    const HeadingBelief belief = afterFrames(HeadingBelief(), across, 12);
    ASSERT_EQ(belief.turnDue(kDecisive), 0) << "likely, but not decisive";
    EXPECT_EQ(belief.acrossFor(), 12);
    EXPECT_EQ(belief.turned(2).acrossFor(), 12);
    EXPECT_EQ(belief.turned(1).acrossFor(), 0);
    EXPECT_EQ(belief.after(seen(4.3, {})).acrossFor(), 0);
}

TEST(HeadingBelief, PartsOfFacesGiveWayToTheVehiclesAround)
{
    // A metre of a side between parked cars, held for an end.
    HeadingCues part;
    part.end = FaceExtent{1.0, 0.1};
    HeadingBelief belief = afterFrames(HeadingBelief(part), part, 30);
    EXPECT_GT(belief.axesProbability(), 0.9);
    EXPECT_EQ(belief.turnDue(0.5), 0);
    part.neighbours = -3.0;
    EXPECT_EQ(belief.after(part).turnDue(0.5) % 2, 1);
    // An end that shows as a whole does not.
    HeadingCues whole = seen(std::nullopt, 1.8);
    belief = afterFrames(HeadingBelief(whole), whole, 30);
    whole.neighbours = -3.0;
    EXPECT_EQ(belief.after(whole).turnDue(0.5), 0);
}

TEST(HeadingBelief, WideEndsOfTrucksAreEnds)
{
    EXPECT_EQ(afterFrames({}, seen(std::nullopt, 2.55, 3.0), 100).turnDue(kDecisive), 0);
}

TEST(HeadingBelief, PolesAndPeopleTurnNothing)
{
    EXPECT_EQ(afterFrames({}, seen(0.6, 0.8), 100).turnDue(kDecisive), 0);
}

TEST(VehicleSizes, TellEndsFromSides)
{
    EXPECT_GT(endOverSide({1.8, 0.7}, 1.5), 2.0);
    EXPECT_LT(endOverSide({4.3, 0.7}, 1.5), -2.0);
    // As wide as a truck, as high as a car, as high as a truck.
    EXPECT_GT(endOverSide({2.6, 0.7}, 3.0), endOverSide({2.6, 0.7}, 1.5));
    // A part tells less than the whole, unless it is too long.
    EXPECT_LT(endOverSide({1.8, 0.0}, 1.5), endOverSide({1.8, 0.7}, 1.5));
    EXPECT_LT(endOverSide({3.5, 0.0}, 1.5), -2.0);
}

TEST(VehicleSizes, OfWhatIsSeenToBeLowAreNoTrucks)
{
    // A car of 2.96 m, as wide as a truck is.
    EXPECT_GT(endOverSide({2.96, 0.9}, 1.55), 0.0) << "rays may have missed its roof";
    EXPECT_LT(endOverSide({2.96, 0.9}, 1.55, true), -1.0);
    EXPECT_NEAR(endOverSide({2.5, 0.9}, 2.6, true), endOverSide({2.5, 0.9}, 2.6), 1e-12);
}

}  // namespace
}  // namespace vdamf
