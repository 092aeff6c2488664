// SPDX-License-Identifier: BSD-3-Clause
// Cars that pass beside a sensor that looks down on them: rows of hits along bonnet, roof and boot
// lie in one line across the car, and few hits on its side.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr double kBeside = 8.0;  // m along the road: so near, its ends are out of view

class PassingBeside : public testing::TestWithParam<int>  // frames a second
{
};

TEST_P(PassingBeside, KeepsHeadingAndSpeed)
{
    const std::string scene = "[scenario]\nduration_s = 5\n"
                              "[sensor]\nmodel = VLP-16\nx_m = 0.8\nz_m = 1.9\nrate_hz = " +
                              std::to_string(GetParam()) +
                              "\n[platform]\nx_m = 0\ny_m = -1.75\nspeed_mps = 8\n"
                              "[object oncoming]\nclass = car\nx_m = 40\ny_m = 1.75\n"
                              "heading_deg = 180\nspeed_mps = 6\n";
    for (int seed = 1; seed <= 3; ++seed)
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        int beside = 0;
        for (const Seen& frame : tracked.at("oncoming"))
        {
            const double ahead = frame.truth.box.x - 8.0 * frame.time - 0.8;
            if (std::abs(ahead) > kBeside) continue;
            ASSERT_FALSE(frame.tracks.empty()) << "seed " << seed << ", " << frame.time;
            ++beside;
            const TrackReport& track = frame.tracks.front();
            const double turned = wrapAngle(track.box.heading - frame.truth.box.heading);
            EXPECT_LT(std::abs(turned), 5.0 * kDegree) << "seed " << seed << ", " << frame.time;
            EXPECT_NEAR(track.speed, 6.0, 1.2) << "seed " << seed << ", " << frame.time;
        }
        EXPECT_GT(beside, GetParam() / 2) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, PassingBeside, testing::Values(10, 20),
                         [](const auto& test) { return std::to_string(test.param) + "_Hz"; });

}  // namespace
}  // namespace vdamf
