// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/matching.h"

#include <gtest/gtest.h>

#include "small_sequences.h"
#include "vdamf/evaluation/dont_care.h"

namespace vdamf
{
namespace
{
TEST(MatchFrames, PairsCarryTheirOverlap)
{
    const std::vector<FrameMatches> matches =
        matchFrames(twoObjects(3, kShiftForTwoThirds, 3).sequence(), 0.5);
    ASSERT_EQ(matches.size(), 3U);
    for (const FrameMatches& frame : matches)
    {
        ASSERT_EQ(frame.pairs.size(), 2U);
        EXPECT_EQ(frame.pairs[1].truth, 1U);
        EXPECT_EQ(frame.pairs[1].track, 1U);
        EXPECT_NEAR(frame.pairs[0].overlap, 2.0 / 3.0, 1e-12);
        EXPECT_TRUE(frame.missed.empty());
        EXPECT_TRUE(frame.falseAlarms.empty());
    }
}

TEST(MatchFrames, BelowTheLeastOverlapIsAMissAndAFalseAlarm)
{
    const Sequence sequence = twoObjects(1, kShiftForTwoThirds, 1).sequence();
    const FrameMatches matches = matchFrames(sequence, 0.67).at(0);
    EXPECT_TRUE(matches.pairs.empty());
    EXPECT_EQ(matches.missed, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(matches.falseAlarms, (std::vector<std::size_t>{0, 1}));
}

TEST(MatchFrames, TheLeastOverlapItselfIsEnoughFarFromTheOrigin)
{
    // Shifted by 1 of 4 m: 3 / 5.
    Scene scene;
    scene.object(0, "a", carAt(5e5 + 1.0 / 3.0, -3e6));
    scene.track(0, 1, carAt(5e5 + 4.0 / 3.0, -3e6));
    EXPECT_EQ(matchFrames(scene.sequence(), 0.6).at(0).pairs.size(), 1U);
    EXPECT_EQ(matchFrames(scene.sequence(), 0.6001).at(0).pairs.size(), 0U);
}

/// Track 1 stays beside the object (overlap 0.6); from frame 1 on track 2 fits it perfectly.
Scene betterTrackComesLater()
{
    Scene scene = lonelyObject(3);
    for (int f = 0; f < 3; ++f) scene.track(f, 1, carAt(f + 1.0));
    for (int f = 1; f < 3; ++f) scene.track(f, 2, carAt(f));
    return scene;
}

TEST(MatchFrames, KeepsThePairOfTheFrameBefore)
{
    const std::vector<FrameMatches> matches = matchFrames(betterTrackComesLater().sequence(), 0.5);
    for (std::size_t f = 1; f < 3; ++f)
    {
        ASSERT_EQ(matches[f].pairs.size(), 1U);
        EXPECT_EQ(matches[f].pairs[0].track, 0U);
        EXPECT_EQ(matches[f].falseAlarms, (std::vector<std::size_t>{1}));
    }
}

TEST(MatchFrames, APairThatNoLongerOverlapsIsNotKept)
{
    const std::vector<FrameMatches> matches = matchFrames(betterTrackComesLater().sequence(), 0.7);
    EXPECT_TRUE(matches[0].pairs.empty());
    ASSERT_EQ(matches[1].pairs.size(), 1U);
    EXPECT_EQ(matches[1].pairs[0].track, 1U);
}

TEST(MatchFrames, PairsLastThroughFramesWithoutTracks)
{
    Scene scene = betterTrackComesLater();
    scene.tracks.clear();
    scene.track(0, 1, carAt(1.0));
    scene.track(2, 1, carAt(3.0));
    scene.track(2, 2, carAt(2.0));
    const std::vector<FrameMatches> matches = matchFrames(scene.sequence(), 0.5);
    EXPECT_EQ(matches[1].missed.size(), 1U);
    EXPECT_EQ(matches[2].pairs.at(0).track, 0U);
}

TEST(MatchFrames, TracksOnDontCareAreNotScored)
{
    const Sequence sequence = withPedestrian().sequence();
    for (const FrameMatches& frame : matchFrames(sequence, 0.5))
    {
        EXPECT_EQ(frame.pairs.size(), 1U);
        EXPECT_TRUE(frame.missed.empty());
        EXPECT_TRUE(frame.falseAlarms.empty());
        EXPECT_EQ(frame.onDontCare, (std::vector<std::size_t>{1}));
    }
}

TEST(MatchFrames, WhatCountsComesBeforeDontCare)
{
    // Track 1 has an overlap of 2/3 with the car and of 1 with a don't-care object: the car's.
    Scene scene;
    scene.object(0, "car", carAt(0.8));
    scene.object(0, "hidden", carAt(0.0)).points = 0;
    scene.track(0, 1, carAt(0.0));
    scene.track(0, 2, carAt(-1.9));  // overlap 1.3 / 6.7 with the car, centre in the hidden one
    scene.track(0, 3, carAt(-2.1));  // centre outside, overlap 1.9 / 6.1
    const FrameMatches matches = matchFrames(scene.sequence(), 0.5).at(0);
    ASSERT_EQ(matches.pairs.size(), 1U);
    EXPECT_EQ(matches.pairs[0].track, 0U);
    EXPECT_EQ(matches.onDontCare, (std::vector<std::size_t>{1}));
    EXPECT_EQ(matches.falseAlarms, (std::vector<std::size_t>{2}));
}

TEST(WithoutDontCare, LeavesWhatCounts)
{
    const Sequence kept = withoutDontCare(withPedestrian().sequence(), 0.5);
    ASSERT_EQ(kept.frames.size(), 10U);
    for (const ScoredFrame& frame : kept.frames)
    {
        ASSERT_EQ(frame.truth.size(), 1U);
        EXPECT_EQ(frame.truth[0].objectId, "a");
        EXPECT_EQ(frame.counts, std::vector<bool>{true});
        ASSERT_EQ(frame.tracks.size(), 1U);
        EXPECT_EQ(frame.tracks[0].report.id, 1U);
    }
}

}  // namespace
}  // namespace vdamf
