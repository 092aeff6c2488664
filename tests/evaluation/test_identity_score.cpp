// SPDX-License-Identifier: BSD-3-Clause
// IDF1 on scenes worked out by hand.
#include "vdamf/evaluation/identity_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_sequences.h"

namespace vdamf
{
namespace
{
TEST(IdentityScore, PerfectCopy)
{
    const IdentityScore score = identityScore(twoObjects(20, 0.0, 20).sequence(), 0.5);
    EXPECT_EQ(score.idf1, 1.0);
    EXPECT_EQ(score.idPrecision, 1.0);
    EXPECT_EQ(score.idRecall, 1.0);
    EXPECT_EQ(score.idtp, 40U);
    EXPECT_EQ(score.idfp + score.idfn, 0U);
}

TEST(IdentityScore, NeedsTheLeastOverlap)
{
    const Sequence sequence = twoObjects(20, kShiftForTwoThirds, 20).sequence();
    EXPECT_EQ(identityScore(sequence, 0.66).idf1, 1.0);
    EXPECT_EQ(identityScore(sequence, 0.67).idf1, 0.0);
    EXPECT_EQ(identityScore(sequence, 0.67).idfn, 40U);
}

TEST(IdentityScore, SwapOfTwoIdentities)
{
    // Either way each object keeps one track for 10 of 20 frames: 2 * 20 / (40 + 40).
    const IdentityScore score = identityScore(twoObjects(20, 0.0, 10).sequence(), 0.5);
    EXPECT_EQ(score.idf1, 0.5);
    EXPECT_EQ(score.idfp, 20U);
    EXPECT_EQ(score.idfn, 20U);
}

TEST(IdentityScore, EveryFifthFrameLost)
{
    const IdentityScore score = identityScore(everyFifthLost().sequence(), 0.5);
    EXPECT_EQ(score.idf1, 40.0 / 45.0);  // 2 * 20 / (25 + 20)
    EXPECT_EQ(score.idPrecision, 1.0);
    EXPECT_EQ(score.idRecall, 0.8);
}

TEST(IdentityScore, GhostOfOneFrame)
{
    EXPECT_EQ(identityScore(withGhost().sequence(), 0.5).idf1, 20.0 / 21.0);  // 2 * 10 / (10 + 11)
}

TEST(IdentityScore, OfSeveralTracksTheLongestCounts)
{
    Scene scene = lonelyObject(10);
    for (int f = 0; f < 10; ++f) scene.track(f, f < 4 ? 1 : 2, carAt(f));
    const IdentityScore score = identityScore(scene.sequence(), 0.5);
    EXPECT_EQ(score.idtp, 6U);
    EXPECT_EQ(score.idf1, 0.6);  // 2 * 6 / (10 + 10)
}

TEST(IdentityScore, TheAssignmentIsTheBestForAllTogether)
{
    // Track 1 is 6 frames on a, then 5 on b; track 2 is 5 frames on a. a with 1 alone gives 6,
    // a with 2 and b with 1 give 5 + 5. Truth: 11 + 5 rows, tracks: 11 + 5 rows.
    Scene scene = lonelyObject(11);
    for (int f = 0; f < 11; ++f)
    {
        if (f >= 6) scene.object(f, "b", carAt(f, 10.0));
        if (f >= 6) scene.track(f, 2, carAt(f));
        scene.track(f, 1, carAt(f, f < 6 ? 0.0 : 10.0));
    }
    const IdentityScore score = identityScore(scene.sequence(), 0.5);
    EXPECT_EQ(score.idtp, 10U);
    EXPECT_EQ(score.idfp, 6U);
    EXPECT_EQ(score.idf1, 0.625);  // 2 * 10 / (16 + 16)
}

TEST(IdentityScore, DontCareTakesNoPart)
{
    const IdentityScore score = identityScore(withPedestrian().sequence(), 0.5);
    EXPECT_EQ(score.idf1, 1.0);
    EXPECT_EQ(score.idtp, 10U);
}

TEST(IdentityScore, UndefinedValuesAreNotANumber)
{
    const IdentityScore noTracks = identityScore(lonelyObject(4).sequence(), 0.5);
    EXPECT_EQ(noTracks.idf1, 0.0);
    EXPECT_EQ(noTracks.idRecall, 0.0);
    EXPECT_TRUE(std::isnan(noTracks.idPrecision));
    EXPECT_TRUE(std::isnan(identityScore({}, 0.5).idf1));
}

}  // namespace
}  // namespace vdamf
