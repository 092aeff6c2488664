// SPDX-License-Identifier: BSD-3-Clause
// HOTA on scenes worked out by hand.
#include "vdamf/evaluation/hota.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_sequences.h"

namespace vdamf
{
namespace
{
constexpr double kExact = 1e-12;

TEST(Hota, PerfectCopy)
{
    const Hota hota = hotaOf(twoObjects(20, 0.0, 20).sequence());
    for (const double HotaScores::*member :
         {&HotaScores::hota, &HotaScores::detA, &HotaScores::assA, &HotaScores::locA,
          &HotaScores::detRe, &HotaScores::detPr, &HotaScores::assRe, &HotaScores::assPr})
    {
        EXPECT_NEAR(hota.*member, 1.0, kExact);
    }
}

TEST(Hota, ShiftedBoxesCountUpToTheirOverlap)
{
    // Overlap 2/3: all right at the 13 alphas to 0.65, all wrong at the 6 from 0.70 on.
    const Hota hota = hotaOf(twoObjects(20, kShiftForTwoThirds, 20).sequence());
    ASSERT_EQ(hota.atAlpha.size(), 19U);
    for (std::size_t a = 0; a < 19; ++a)
    {
        const HotaAtAlpha& at = hota.atAlpha[a];
        EXPECT_NEAR(at.alpha, 0.05 + 0.05 * static_cast<double>(a), kExact);
        EXPECT_NEAR(at.hota, a < 13 ? 1.0 : 0.0, kExact);
        EXPECT_NEAR(at.detA, a < 13 ? 1.0 : 0.0, kExact);
        EXPECT_NEAR(at.assA, a < 13 ? 1.0 : 0.0, kExact);
        EXPECT_NEAR(at.locA, a < 13 ? 2.0 / 3.0 : 1.0, kExact);
    }
    EXPECT_NEAR(hota.hota, 13.0 / 19.0, kExact);
    EXPECT_NEAR(hota.detA, 13.0 / 19.0, kExact);
    EXPECT_NEAR(hota.assA, 13.0 / 19.0, kExact);
    EXPECT_NEAR(hota.locA, (13.0 * 2.0 / 3.0 + 6.0) / 19.0, kExact);
}

TEST(Hota, AnOverlapAtAnAlphaReachesIt)
{
    // Shifted by 1 of 4 m: 3 / 5, which in binary numbers is not quite 12 * 0.05.
    const Hota hota = hotaOf(twoObjects(20, 1.0, 20).sequence());
    EXPECT_NEAR(hota.hota, 12.0 / 19.0, kExact);
}

TEST(Hota, SwapOfTwoIdentities)
{
    // Each of the four relations: TPA 10, FNA 10, FPA 10.
    const Hota hota = hotaOf(twoObjects(20, 0.0, 10).sequence());
    EXPECT_NEAR(hota.detA, 1.0, kExact);
    EXPECT_NEAR(hota.assA, 1.0 / 3.0, kExact);
    EXPECT_NEAR(hota.assRe, 0.5, kExact);
    EXPECT_NEAR(hota.assPr, 0.5, kExact);
    EXPECT_NEAR(hota.hota, std::sqrt(1.0 / 3.0), kExact);
}

TEST(Hota, EveryFifthFrameLost)
{
    // TP 20, FN 5, and TPA 20, FNA 5: both 0.8.
    const Hota hota = hotaOf(everyFifthLost().sequence());
    EXPECT_NEAR(hota.detA, 0.8, kExact);
    EXPECT_NEAR(hota.assA, 0.8, kExact);
    EXPECT_NEAR(hota.hota, 0.8, kExact);
    EXPECT_NEAR(hota.detRe, 0.8, kExact);
    EXPECT_NEAR(hota.detPr, 1.0, kExact);
}

TEST(Hota, GhostOfOneFrame)
{
    const Hota hota = hotaOf(withGhost().sequence());
    EXPECT_NEAR(hota.detA, 10.0 / 11.0, kExact);
    EXPECT_NEAR(hota.assA, 1.0, kExact);
    EXPECT_NEAR(hota.hota, std::sqrt(10.0 / 11.0), kExact);
}

// In the manner of the publication's first figure: one object of 40 frames, three trackers with
// more and more detection and less and less association, that HOTA finds about equally good.
TEST(Hota, BalancesDetectionAndAssociation)
{
    // One track on half of it: TP 20, FN 20; TPA 20, FNA 20.
    const Hota a = hotaOf(inPieces(40, 20, 1).sequence());
    EXPECT_NEAR(a.detA, 0.5, kExact);
    EXPECT_NEAR(a.assA, 0.5, kExact);
    EXPECT_NEAR(a.hota, 0.5, kExact);
    // Two tracks of 14: TP 28, FN 12; each TPA 14, FNA 26.
    const Hota b = hotaOf(inPieces(40, 14, 2).sequence());
    EXPECT_NEAR(b.detA, 0.7, kExact);
    EXPECT_NEAR(b.assA, 0.35, kExact);
    EXPECT_NEAR(b.hota, std::sqrt(0.7 * 0.35), kExact);
    // Four tracks of 10: TP 40; each TPA 10, FNA 30.
    const Hota c = hotaOf(inPieces(40, 10, 4).sequence());
    EXPECT_NEAR(c.detA, 1.0, kExact);
    EXPECT_NEAR(c.assA, 0.25, kExact);
    EXPECT_NEAR(c.hota, 0.5, kExact);
}

TEST(Hota, PairsTheTrackThatLastsLonger)
{
    // Track 2 fits better (overlap 1 against 0.6) but for 2 of 20 frames. With s and t the sums of
    // the overlaps' shares (per frame 1 alone: 1; both: 0.6/1.6 and 1/1.6) track 1 has s = 18.75 of
    // 40 - 18.75, track 2 t = 1.25 of 22 - 1.25: 0.6 * 0.882 against 0.060. So track 1 is paired
    // in all frames and track 2 twice wrong: at alpha 0.6 DetA = 20 / 22, AssA = 1.
    Scene scene = lonelyObject(20);
    for (int f = 0; f < 20; ++f) scene.track(f, 1, carAt(f + 1.0));
    for (int f = 10; f < 12; ++f) scene.track(f, 2, carAt(f));
    const HotaAtAlpha at = hotaOf(scene.sequence()).atAlpha[11];
    EXPECT_NEAR(at.detA, 20.0 / 22.0, kExact);
    EXPECT_NEAR(at.assA, 1.0, kExact);
}

TEST(Hota, DontCareTakesNoPart)
{
    const Hota hota = hotaOf(withPedestrian().sequence());
    EXPECT_NEAR(hota.hota, 1.0, kExact);
}

TEST(Hota, UndefinedValuesAreNotANumber)
{
    const Hota noTracks = hotaOf(lonelyObject(4).sequence());
    EXPECT_EQ(noTracks.hota, 0.0);
    EXPECT_EQ(noTracks.detRe, 0.0);
    EXPECT_TRUE(std::isnan(noTracks.detPr));
    EXPECT_TRUE(std::isnan(noTracks.locA));

    Scene nothingCounts = withGhost();
    for (TruthRow& row : nothingCounts.truth) row.objectClass = "Cyclist";
    const Hota onlyGhost = hotaOf(nothingCounts.sequence());
    EXPECT_EQ(onlyGhost.hota, 0.0);
    EXPECT_TRUE(std::isnan(onlyGhost.detRe));

    EXPECT_TRUE(std::isnan(hotaOf({}).hota));
    EXPECT_EQ(hotaOf({}).atAlpha.size(), 19U);
}

}  // namespace
}  // namespace vdamf
