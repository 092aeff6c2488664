// SPDX-License-Identifier: BSD-3-Clause
// What comes out from behind something nearer is who went in.
#include <gtest/gtest.h>

#include <ostream>
#include <set>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr int kSeenHits = 20;

const char* const kStandingPlatform =
    "[scenario]\nduration_s = 6.5\n"
    "[sensor]\nx_m = 0\nz_m = 1.9\n"
    "[platform]\nx_m = 0\ny_m = 0\nspeed_mps = 0\n";

struct Identities
{
    std::set<std::uint64_t> before, after;
    int hidden = 0;  // frames without a hit
    int lost = 0;    // frames with hits, but without a track, once it was seen
};

Identities identitiesOf(const std::vector<Seen>& frames)
{
    Identities result;
    for (const Seen& frame : frames)
    {
        if (frame.truth.points == 0) ++result.hidden;
        if (frame.truth.points < kSeenHits) continue;
        const bool wasHidden = result.hidden > 0;
        if (frame.tracks.empty())
            result.lost += wasHidden || !result.before.empty() ? 1 : 0;
        else
            (wasHidden ? result.after : result.before).insert(frame.tracks.front().id);
    }
    return result;
}

struct Passage
{
    const char* name;
    double hidden;         // s, about
    const char* segments;  // of the car's motion, 8 m/s at the start
    int seed;
};

std::ostream& operator<<(std::ostream& out, const Passage& passage)
{
    return out << passage.name;
}

// The car passes 20 m away, behind a wall at 9 m.
std::string sceneOf(const Passage& passage)
{
    constexpr double kSpeed = 8.0;
    constexpr double kLength = 4.5;
    const double hiddenWay = passage.hidden * kSpeed + kLength;
    return kStandingPlatform + std::string("[object wall]\nclass = wall\nlength_m = ") +
           std::to_string(hiddenWay * 9.0 / 20.0) +
           "\nwidth_m = 0.5\nheight_m = 3\nx_m = 0\ny_m = 9\n"
           "[object car]\nclass = car\ny_m = 20\nspeed_mps = 8\nx_m = " +
           std::to_string(-0.5 * hiddenWay - 2.0 * kSpeed) + "\nsegments = " + passage.segments +
           "\n";
}

class BehindAWall : public testing::TestWithParam<Passage>
{
};

TEST_P(BehindAWall, KeepsItsIdentity)
{
    const auto seen = trackedObjects(scenarioOf(sceneOf(GetParam()), GetParam().seed));
    const Identities ids = identitiesOf(seen.at("car"));
    EXPECT_GE(ids.hidden, static_cast<int>(8.0 * GetParam().hidden)) << "not hidden for so long";
    EXPECT_EQ(ids.before.size(), 1U);
    EXPECT_EQ(ids.before, ids.after);
    EXPECT_LE(ids.lost, 1);
}

INSTANTIATE_TEST_SUITE_P(
    Cars, BehindAWall,
    testing::Values(Passage{"straight_05", 0.5, "keep 20", 1},
                    Passage{"straight_10", 1.0, "keep 20", 2},
                    Passage{"straight_15", 1.5, "keep 20", 3},
                    Passage{"straight_20", 2.0, "keep 20", 4},
                    Passage{"turning_10", 1.0, "keep 1.2, turn -15 25, keep 9", 5},
                    Passage{"turning_20", 2.0, "keep 1.2, turn -15 25, keep 9", 6},
                    Passage{"braking_10", 1.0, "keep 1.8, speed_to 5.2 1.5, keep 9", 7},
                    Passage{"speeding_up_20", 2.0, "keep 1.8, speed_to 10 1.2, keep 9", 8}),
    [](const auto& test) { return std::string(test.param.name); });

// Nothing tells in sight that it will go on around the island: after 3.5 s it is 9 m from where it
// would have been.
TEST(Occlusion, ACarThatTurnsOutOfSightIsKnownAgain)
{
    constexpr double kGoesIn = 3.0;    // s
    constexpr double kComesOut = 7.5;  // s
    const auto seen = trackedObjects(scenarioOf(
        "[scenario]\nduration_s = 9\n"
        "[sensor]\nx_m = 0.8\nz_m = 1.9\n"
        "[platform]\nx_m = 8\ny_m = -4\nheading_deg = 10\nspeed_mps = 0\n"
        "[object around]\nclass = car\nx_m = 30\ny_m = -15\nspeed_mps = 6\n"
        "segments = turn 1080 15\n"
        "[object tree]\nclass = tree\nlength_m = 5\nwidth_m = 5\nheight_m = 6\nx_m = 30\ny_m = 0\n"
        "[object bush]\nclass = bush\nlength_m = 4\nwidth_m = 3\nheight_m = 1.2\nx_m = 33\n"
        "y_m = 4\n",
        4));
    std::set<std::uint64_t> before, between, after;
    for (const Seen& frame : seen.at("around"))
    {
        if (frame.tracks.empty()) continue;
        const std::uint64_t id = frame.tracks.front().id;
        (frame.time < kGoesIn ? before : frame.time < kComesOut ? between : after).insert(id);
    }
    EXPECT_EQ(before.size(), 1U);
    EXPECT_EQ(before, after);
}

TEST(Occlusion, StandingCarsKeepTheirIdentityWhileABusPasses)
{
    const auto seen = trackedObjects(scenarioOf(
        kStandingPlatform + std::string("[object bus]\nclass = bus\nx_m = -24\ny_m = 8\n"
                                        "speed_mps = 8\n"
                                        "[object along]\nclass = car\nx_m = 0\ny_m = 15\n"
                                        "[object across]\nclass = car\nx_m = 7\ny_m = 19\n"
                                        "heading_deg = 80\n"),
        9));
    for (const char* name : {"along", "across"})
    {
        const Identities ids = identitiesOf(seen.at(name));
        EXPECT_GE(ids.hidden, 10) << name;
        EXPECT_EQ(ids.before.size(), 1U) << name;
        EXPECT_EQ(ids.before, ids.after) << name;
        EXPECT_LE(ids.lost, 1) << name;
    }
}

}  // namespace
}  // namespace vdamf
