// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/rough_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tracking/tracker/seen_as.h"
#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
// Hits on a car's rear 1.8 m wide, 20 m ahead, and `more` of them to its right: `far` of x to
// either side of the rear's.
Cluster rearAnd(int more, double near, double far, std::size_t seed = 7)
{
    std::mt19937 random(seed);
    const auto between = [&](double low, double high)
    { return static_cast<float>(std::uniform_real_distribution<>(low, high)(random)); };
    Cluster hits;
    const auto add = [&](float x, float y)
    {
        hits.x.push_back(x);
        hits.y.push_back(y);
        hits.height.push_back(0.7F);
    };
    for (int i = 0; i < 80; ++i) add(between(19.96, 20.04), between(-0.9, 0.9));
    for (int i = 0; i < more; ++i) add(between(20.0 - near, 20.0 + far), between(-2.6, -0.95));
    return hits;
}

Sighting rearSeen(const Cluster& hits)
{
    Sighting s;
    s.measurement.box = {22.0, -0.5, 0.0, 4.0, 3.2};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.hits = static_cast<int>(hits.size());
    s.end = rowAlongFace(*seenAs(hits).hits, s.measurement.box, s.sensor, 0);
    return s;
}

TEST(RoughEnds, OfAHedgeAreLeftOut)
{
    const Cluster hits = rearAnd(30, 0.5, 0.9);
    const auto smooth = withoutRoughEnd(rearSeen(hits), seenAs(hits), 0.0, 0.0, false);
    ASSERT_TRUE(smooth);
    const auto& y = smooth->each->y;
    EXPECT_GE(y.size(), 76U) << "the rear stays";
    EXPECT_GT(*std::min_element(y.begin(), y.end()), -1.6F) << "two bins further at most";
    EXPECT_EQ(smooth->hits->totalWeight, static_cast<double>(y.size()));
    ASSERT_TRUE(smooth->goesOn);
    EXPECT_LT(smooth->goesOn->y(), -1.2) << "what is left out may hide the rest";
}

TEST(RoughEnds, StayWhereTheyAreTheVehiclesOwn)
{
    const auto isCut = [](const Cluster& hits)
    { return withoutRoughEnd(rearSeen(hits), seenAs(hits), 0.0, 0.0, false).has_value(); };
    EXPECT_FALSE(isCut(rearAnd(30, 0.04, 0.04))) << "the face goes on";
    EXPECT_FALSE(isCut(rearAnd(30, -0.2, 0.6))) << "round corners lie behind it";
    EXPECT_FALSE(isCut(rearAnd(4, 0.5, 0.9))) << "hardly any hits";
    EXPECT_FALSE(isCut(Cluster()));
}

TEST(RoughEnds, StayWhereTooLittleWouldBeLeft)
{
    const Cluster hits = rearAnd(200, 0.5, 0.9);
    const auto left = [&](double leastShare)
    { return withoutRoughEnd(rearSeen(hits), seenAs(hits), leastShare, 0.0, false); };
    ASSERT_TRUE(left(0.25));
    const double share = static_cast<double>(left(0.25)->each->size()) / 280.0;
    EXPECT_LT(share, 0.5);
    EXPECT_TRUE(left(share - 0.01));
    EXPECT_FALSE(left(share + 0.01));
}

// With its right side, smooth up to where a hedge goes on behind it.
TEST(RoughEnds, OfTheSideWhereTooLittleWouldBeLeftOfTheEnd)
{
    Cluster hits = rearAnd(200, 0.5, 0.9);
    std::mt19937 random(5);
    const auto add = [&](double x, double y)
    {
        hits.x.push_back(static_cast<float>(x));
        hits.y.push_back(static_cast<float>(y));
        hits.height.push_back(0.7F);
    };
    std::uniform_real_distribution<> unit(0.0, 1.0);
    for (int i = 0; i < 500; ++i) add(20.9 + 2.1 * unit(random), 1.1 + 0.04 * (unit(random) - 0.5));
    for (int i = 0; i < 60; ++i) add(23.05 + 1.2 * unit(random), 0.6 + 1.0 * unit(random));
    Sighting s = rearSeen(hits);
    s.sensor = {0.0, 20.0};
    s.measurement.facesSeen.add(Face::Left);
    s.side = rowAlongFace(*seenAs(hits).hits, s.measurement.box, s.sensor, 1);
    const auto cut = withoutRoughEnd(s, seenAs(hits), 0.8, 0.0, false);
    ASSERT_TRUE(cut);
    EXPECT_LT(*std::max_element(cut->each->x.begin(), cut->each->x.end()), 23.4F);
    EXPECT_GT(cut->each->size(), 700U) << "the hits of the end stay";
}

// Parked cars that touch a hedge, before a sensor with dense rows: the hedge makes their ends as
// long as sides are.
TEST(RoughEnds, OfAHedgeTurnNoParkedCars)
{
    std::string scene =
        "[scenario]\nduration_s = 4\n"
        "[sensor]\nmodel = HDL-64E\nx_m = 0.8\nz_m = 1.9\n"
        "[platform]\nx_m = 0\ny_m = -1.75\nspeed_mps = 4\n"
        "[object before]\nclass = car\nx_m = 14\ny_m = -4.35\nheading_deg = 0.5\n"
        "[object parked]\nclass = suv\nx_m = 27\ny_m = -4.4\nheading_deg = -0.5\n"
        "[object behind]\nclass = hatchback\nx_m = 41\ny_m = -4.35\nheading_deg = 181\n";
    const char* heights[] = {"1.3", "1.6", "1.2", "1.8", "1.3", "1.6", "1.2", "1.8"};
    for (int k = 0; k < 8; ++k)
        scene += "[object hedge_" + std::to_string(k) + "]\nclass = bush\nlength_m = 7\n" +
                 "width_m = 2\nheight_m = " + heights[k] + "\nx_m = " + std::to_string(4 + 7 * k) +
                 "\ny_m = -6.2\n";
    for (int seed = 1; seed <= 3; ++seed)
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        int turned = 0;
        for (const Seen& frame : tracked.at("parked"))
        {
            if (frame.time < 1.0) continue;
            const auto isTurned = [&](const TrackReport& track)
            {
                const double off = track.box.heading - frame.truth.box.heading;
                return std::abs(std::remainder(off, kPi)) > 5.0 * kDegree;
            };
            if (frame.tracks.empty() || isTurned(frame.tracks.front())) ++turned;
        }
        EXPECT_EQ(turned, 0) << "seed " << seed;
    }
}

}  // namespace
}  // namespace vdamf
