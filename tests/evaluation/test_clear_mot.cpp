// SPDX-License-Identifier: BSD-3-Clause
// CLEAR MOT on scenes worked out by hand.
#include "vdamf/evaluation/clear_mot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_sequences.h"

namespace vdamf
{
namespace
{
ClearMot scoreOf(const Scene& scene)
{
    const Sequence sequence = scene.sequence();
    return clearMot(sequence, matchFrames(sequence, 0.5));
}

TEST(ClearMot, PerfectCopy)
{
    const ClearMot score = scoreOf(twoObjects(20, 0.0, 20));
    EXPECT_EQ(score.mota, 1.0);
    EXPECT_NEAR(score.motp, 1.0, 1e-12);
    EXPECT_EQ(score.motpDistance, 0.0);
    EXPECT_EQ(score.recall, 1.0);
    EXPECT_EQ(score.precision, 1.0);
    EXPECT_EQ(score.truePositives, 40U);
    EXPECT_EQ(score.falsePositives + score.falseNegatives, 0U);
    EXPECT_EQ(score.identitySwitches + score.fragmentations, 0U);
    EXPECT_EQ(score.objects, 2U);
    EXPECT_EQ(score.mostlyTracked, 2U);
}

TEST(ClearMot, ShiftedBoxes)
{
    const ClearMot score = scoreOf(twoObjects(20, kShiftForTwoThirds, 20));
    EXPECT_EQ(score.mota, 1.0);
    EXPECT_NEAR(score.motp, 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(score.motpDistance, 0.8, 1e-12);
}

TEST(ClearMot, SwapOfTwoIdentities)
{
    const ClearMot score = scoreOf(twoObjects(20, 0.0, 10));
    EXPECT_EQ(score.identitySwitches, 2U);  // one for each object
    EXPECT_EQ(score.mota, 0.95);            // (40 - 0 - 2) / 40
    EXPECT_EQ(score.fragmentations, 0U);
    EXPECT_EQ(score.mostlyTracked, 2U);
}

TEST(ClearMot, EveryFifthFrameLost)
{
    const ClearMot score = scoreOf(everyFifthLost());
    EXPECT_EQ(score.recall, 0.8);  // 20 / 25
    EXPECT_EQ(score.mota, 0.8);
    EXPECT_EQ(score.precision, 1.0);
    EXPECT_EQ(score.fragmentations, 4U);  // after frames 4, 9, 14, 19; it is not found after 24
    EXPECT_EQ(score.identitySwitches, 0U);
    EXPECT_EQ(score.mostlyTracked, 0U);  // 80 % is not more than 80 %
    EXPECT_EQ(score.partlyTracked, 1U);
}

TEST(ClearMot, GhostOfOneFrame)
{
    const ClearMot score = scoreOf(withGhost());
    EXPECT_EQ(score.falsePositives, 1U);
    EXPECT_EQ(score.mota, 0.9);  // (10 - 1) / 10
    EXPECT_EQ(score.precision, 10.0 / 11.0);
    EXPECT_EQ(score.recall, 1.0);
}

TEST(ClearMot, ManyGhostsMakeMotaNegative)
{
    Scene scene = lonelyObject(2);
    for (std::uint64_t id = 1; id <= 5; ++id)
    {
        scene.track(0, id, carAt(0.0, 100.0 * static_cast<double>(id)));
    }
    EXPECT_EQ(scoreOf(scene).mota, -2.5);  // (0 - 5) / 2
}

TEST(ClearMot, ASwitchIsCountedHoweverLongAgo)
{
    Scene scene = lonelyObject(10);
    for (int f = 0; f < 10; ++f)
    {
        if (f < 3 || f > 6) scene.track(f, f < 3 ? 1 : 2, carAt(f));
    }
    const ClearMot score = scoreOf(scene);
    EXPECT_EQ(score.identitySwitches, 1U);
    EXPECT_EQ(score.fragmentations, 1U);
    EXPECT_EQ(score.mota, 0.5);  // (6 - 0 - 1) / 10
}

TEST(ClearMot, AbsenceOfTheObjectIsNoFragmentation)
{
    Scene scene;
    for (int f = 0; f < 10; ++f)
    {
        scene.object(f, "other", carAt(f, 30.0));
        if (f > 2 && f < 7) continue;
        scene.object(f, "a", carAt(f));
        scene.track(f, 1, carAt(f));
    }
    const ClearMot score = scoreOf(scene);
    EXPECT_EQ(score.fragmentations, 0U);
    EXPECT_EQ(score.truePositives, 6U);
    EXPECT_EQ(score.falseNegatives, 10U);
}

TEST(ClearMot, ObjectsByTheShareOfTheirFrames)
{
    // Of 10 frames 9 (mostly tracked), 8, 2 (partly), and 1, 0 (mostly lost: less than 20 %).
    Scene scene;
    const int found[] = {9, 8, 2, 1, 0};
    for (int i = 0; i < 5; ++i)
    {
        for (int f = 0; f < 10; ++f)
        {
            scene.object(f, std::to_string(i), carAt(f, 10.0 * i));
            const auto id = static_cast<std::uint64_t>(i + 1);
            if (f < found[i]) scene.track(f, id, carAt(f, 10.0 * i));
        }
    }
    const ClearMot score = scoreOf(scene);
    EXPECT_EQ(score.objects, 5U);
    EXPECT_EQ(score.mostlyTracked, 1U);
    EXPECT_EQ(score.partlyTracked, 2U);
    EXPECT_EQ(score.mostlyLost, 2U);
    EXPECT_EQ(score.recall, 0.4);  // 20 / 50
}

TEST(ClearMot, DontCareTakesNoPart)
{
    const ClearMot score = scoreOf(withPedestrian());
    EXPECT_EQ(score.mota, 1.0);
    EXPECT_EQ(score.objects, 1U);
    EXPECT_EQ(score.truePositives, 10U);
}

TEST(ClearMot, UndefinedValuesAreNotANumber)
{
    const ClearMot noTracks = scoreOf(lonelyObject(4));
    EXPECT_EQ(noTracks.mota, 0.0);
    EXPECT_EQ(noTracks.recall, 0.0);
    EXPECT_TRUE(std::isnan(noTracks.precision));
    EXPECT_TRUE(std::isnan(noTracks.motp));
    EXPECT_TRUE(std::isnan(noTracks.motpDistance));
    EXPECT_EQ(noTracks.mostlyLost, 1U);

    Scene nothingCounts = withGhost();
    for (TruthRow& row : nothingCounts.truth) row.objectClass = "Cyclist";
    const ClearMot score = scoreOf(nothingCounts);
    EXPECT_TRUE(std::isnan(score.mota));
    EXPECT_TRUE(std::isnan(score.recall));
    EXPECT_EQ(score.precision, 0.0);  // 0 / 1: the ghost
    EXPECT_EQ(score.objects, 0U);
    EXPECT_TRUE(std::isnan(clearMot({}, {}).mota));
}

}  // namespace
}  // namespace vdamf
