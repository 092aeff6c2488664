// SPDX-License-Identifier: BSD-3-Clause
// Scenes too large to score by hand: whoever swaps truth and tracks swaps misses and false alarms,
// and nothing else.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "small_sequences.h"
#include "vdamf/evaluation/clear_mot.h"
#include "vdamf/evaluation/hota.h"
#include "vdamf/evaluation/identity_score.h"

namespace vdamf
{
namespace
{
/// Four neighbours that overlap each other's tracks at times; tracks break, swap, and get lost.
Scene crowd(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, 0.5 * part(random));
    Scene scene;
    std::array<std::uint64_t, 4> ids = {1, 2, 3, 4};
    for (int f = 0; f < 25; ++f)
    {
        if (part(random) < 0.1) std::swap(ids[0], ids[1]);
        if (part(random) < 0.1) ids[2] += 10;
        // Both tables span all of the time: what lies outside of the truth is not scored.
        const bool all = f == 0 || f == 24;
        for (std::size_t i = 0; i < ids.size(); ++i)
        {
            const OrientedBox box = carAt(0.5 * f, 1.7 * static_cast<double>(i));
            if (all || part(random) < 0.9) scene.object(f, std::to_string(i), box);
            if (all || part(random) < 0.8)
            {
                scene.track(f, ids[i], carAt(box.x + noise(random), box.y + noise(random)));
            }
        }
    }
    return scene;
}

Scene swapped(const Scene& scene)
{
    Scene other;
    const auto frameOf = [](double time)
    { return static_cast<int>(std::lround((time - kStart) / kPeriod)); };
    for (const TrackRow& row : scene.tracks)
    {
        other.object(frameOf(row.time), std::to_string(row.report.id), row.report.box);
    }
    for (const TruthRow& row : scene.truth)
    {
        other.track(frameOf(row.time), std::stoull(row.objectId), row.box);
    }
    return other;
}

TEST(MetricSymmetry, SwappingTruthAndTracks)
{
    std::mt19937_64 random(13);
    for (int i = 0; i < 20; ++i)
    {
        const Scene scene = crowd(random);
        const Sequence there = scene.sequence();
        const Sequence back = swapped(scene).sequence();
        ASSERT_EQ(there.frames.size(), back.frames.size());
        const Hota a = hotaOf(there);
        const Hota b = hotaOf(back);
        EXPECT_NEAR(a.hota, b.hota, 1e-12);
        EXPECT_NEAR(a.locA, b.locA, 1e-12);
        EXPECT_NEAR(a.detRe, b.detPr, 1e-12);
        EXPECT_NEAR(a.detPr, b.detRe, 1e-12);
        EXPECT_NEAR(a.assRe, b.assPr, 1e-12);
        EXPECT_NEAR(a.assPr, b.assRe, 1e-12);
        EXPECT_GT(a.hota, 0.1);
        EXPECT_LT(a.hota, 0.9);
        const IdentityScore c = identityScore(there, 0.5);
        const IdentityScore d = identityScore(back, 0.5);
        EXPECT_EQ(c.idtp, d.idtp);
        EXPECT_EQ(c.idfp, d.idfn);
        EXPECT_EQ(c.idf1, d.idf1);
    }
}

TEST(MetricSymmetry, AllMetricsCountTheSameRows)
{
    std::mt19937_64 random(14);
    for (int i = 0; i < 20; ++i)
    {
        const Scene scene = crowd(random);
        const Sequence sequence = scene.sequence();
        const ClearMot clear = clearMot(sequence, matchFrames(sequence, 0.5));
        const IdentityScore identity = identityScore(sequence, 0.5);
        EXPECT_EQ(clear.truePositives + clear.falseNegatives, identity.idtp + identity.idfn);
        EXPECT_EQ(clear.truePositives + clear.falsePositives, identity.idtp + identity.idfp);
        EXPECT_GE(clear.motp, 0.5);
        EXPECT_EQ(clear.mostlyTracked + clear.partlyTracked + clear.mostlyLost, clear.objects);
    }
}

}  // namespace
}  // namespace vdamf
