// SPDX-License-Identifier: BSD-3-Clause
// Cars that pass beside a sensor that looks down on them: rows of hits along bonnet, roof and boot
// lie in one line across the car, few are on its side, and those on its windows.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr double kPlatformSpeed = 8.0;  // m/s
constexpr double kBeside = 8.0;         // m along the road: so near, its ends are out of view

struct Passing
{
    const char* name;
    int rate;         // frames a second
    double from;      // m along the road
    double lane;      // m across
    int heading;      // degrees
    double speed;     // m/s
    double mayPlace;  // m along the road: error while it is beside
    double maySpeed;  // m/s: the same
};

std::ostream& operator<<(std::ostream& out, const Passing& passing)
{
    return out << passing.name;
}

class PassingBeside : public testing::TestWithParam<Passing>
{
};

TEST_P(PassingBeside, KeepsHeadingPlaceAndSpeed)
{
    const Passing& p = GetParam();
    const auto number = [](auto value) { return std::to_string(value); };
    const std::string scene =
        "[scenario]\nduration_s = 5\n"
        "[sensor]\nmodel = VLP-16\nx_m = 0.8\nz_m = 1.9\ninstantaneous = false\nrate_hz = " +
        number(p.rate) +
        "\n[platform]\nx_m = 0\ny_m = -1.75\nspeed_mps = " + number(kPlatformSpeed) +
        "\n[object car]\nclass = car\nx_m = " + number(p.from) + "\ny_m = " + number(p.lane) +
        "\nheading_deg = " + number(p.heading) + "\nspeed_mps = " + number(p.speed) + "\n";
    for (int seed = 1; seed <= 3; ++seed)
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        int beside = 0;
        for (const Seen& frame : tracked.at("car"))
        {
            const OrientedBox& truth = frame.truth.box;
            if (std::abs(truth.x - kPlatformSpeed * frame.time - 0.8) > kBeside) continue;
            const std::string at = "seed " + number(seed) + ", " + number(frame.time) + " s";
            ASSERT_FALSE(frame.tracks.empty()) << at;
            ++beside;
            const TrackReport& track = frame.tracks.front();
            EXPECT_LT(std::abs(wrapAngle(track.box.heading - truth.heading)), 5.0 * kDegree) << at;
            EXPECT_NEAR(track.box.x, truth.x, p.mayPlace) << at;
            EXPECT_NEAR(track.speed, p.speed, p.maySpeed) << at;
        }
        EXPECT_GT(beside, p.rate / 2) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cars, PassingBeside,
    testing::Values(Passing{"oncoming_10_Hz", 10, 40.0, 1.75, 180, 6.0, 0.5, 1.2},
                    Passing{"oncoming_20_Hz", 20, 40.0, 1.75, 180, 6.0, 0.5, 1.2},
                    Passing{"passed_10_Hz", 10, 22.0, 1.25, 0, 2.0, 0.5, 1.2},
                    Passing{"passed_20_Hz", 20, 22.0, 1.25, 0, 2.0, 0.7, 1.8}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace vdamf
