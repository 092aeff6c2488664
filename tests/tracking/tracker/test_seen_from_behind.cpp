// SPDX-License-Identifier: BSD-3-Clause
// A car that is seen from behind alone for 10 s, then overtaken: what is known of its size and
// speed, and what happens to the speed while its length appears.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tracking/tracker/example_frames.h"
#include "tracking/tracker/simulated_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
constexpr double kCarSpeed = 12.0;  // m/s, of the car
constexpr double kBehind = 10.0;    // s

// The platform stays behind, then passes in the lane to the left.
Eigen::Vector2d platformAt(double t)
{
    const double passing = std::max(0.0, t - kBehind);
    const double across = 3.5 * std::min(1.0, passing / 2.0);
    return {-16.0 + kCarSpeed * t + 5.0 * passing, across};
}

class SeenFromBehind : public testing::TestWithParam<double>  // its length, m
{
};

TEST_P(SeenFromBehind, ThenOvertaken)
{
    TrackerOptions options;
    options.discriminator.model = "none";  // upright plates are no car to it
    Tracker tracker{options};
    double squares = 0.0;
    double fastest = 0.0;
    double last = 0.0;
    int frames = 0;
    for (int k = 0; k < 140; ++k)
    {
        const double t = 0.1 * k;
        const OrientedBox car{kCarSpeed * t, 0.0, 0.0, GetParam(), 1.8};
        const FrameResult result =
            tracker.process(exampleFrame(t, platformAt(t), {{car, 1.5}}, 500U + unsigned(k)));
        if (k < 10) continue;
        ASSERT_EQ(result.tracks.size(), 1U) << t;
        const TrackReport& track = result.tracks.front();
        const double speed = track.speed - kCarSpeed;
        const double length = track.box.length - GetParam();
        EXPECT_LT(std::abs(track.box.width - 1.8), 0.1) << t;
        EXPECT_LT(std::abs(length), 3.0 * std::sqrt(track.lengthVariance)) << t;
        if (t < kBehind)
        {
            EXPECT_GT(std::sqrt(track.lengthVariance), 0.3) << t;
            squares += speed * speed;
            ++frames;
        }
        else
        {
            fastest = std::max(fastest, std::abs(speed));
        }
        last = length;
    }
    EXPECT_LT(std::sqrt(squares / frames), 0.3);
    EXPECT_LT(fastest, 0.5);
    EXPECT_LT(std::abs(last), 0.2);
}

// Rays that run along a side pass its corner where the body is widest, however round it is.
TEST(SeenFromAnEnd, TheWidthIsThatOfTheRoundBody)
{
    const std::string scene = R"(
[scenario]
duration_s = 2

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
speed_mps = 0

[object ahead]
class = suv
x_m = 9
y_m = 0

[object behind]
class = hatchback
x_m = -7
y_m = 0
)";
    for (int seed = 1; seed <= 3; ++seed)
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        for (const std::string name : {"ahead", "behind"})
        {
            const Seen& last = tracked.at(name).back();
            ASSERT_FALSE(last.tracks.empty()) << name << ", seed " << seed;
            EXPECT_NEAR(last.tracks.front().box.width, last.truth.box.width, 0.06)
                << name << ", seed " << seed;
        }
    }
}

// Rows of hits lie 0.43 m apart there: one meets it at 1.7 m, the next one passes over its roof.
TEST(SeenFromAnEnd, AVanIsLongThoughNoRowOfHitsShowsItsRoof)
{
    const std::string scene = R"(
[scenario]
duration_s = 2

[sensor]
x_m = 0.8
z_m = 1.7

[platform]
speed_mps = 0

[object van]
class = van
x_m = 22
y_m = 0
)";
    const auto tracked = trackedObjects(scenarioOf(scene));
    const Seen& last = tracked.at("van").back();
    ASSERT_FALSE(last.tracks.empty());
    const TrackReport& track = last.tracks.front();
    EXPECT_LT(track.height, 1.8);
    EXPECT_GT(track.box.length, 4.7);
    EXPECT_LT(std::abs(track.box.length - last.truth.box.length),
              2.0 * std::sqrt(track.lengthVariance));
}

// The rear of a bus is closed down to its skirt, that of a truck open below its floor.
TEST(SeenFromAnEnd, ABusIsLongerThanATruck)
{
    const std::string scene = R"(
[scenario]
duration_s = 3

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
speed_mps = 8

[object ahead]
length_m = 12
width_m = 2.55
height_m = 3.1
x_m = 29
y_m = 0
speed_mps = 8
class = )";
    for (int seed = 1; seed <= 3; ++seed)
    {
        const auto lengthOf = [&](const std::string& kind)
        {
            const auto tracked = trackedObjects(scenarioOf(scene + kind + "\n", seed));
            const Seen& last = tracked.at("ahead").back();
            return last.tracks.empty() ? 0.0 : last.tracks.front().box.length;
        };
        EXPECT_NEAR(lengthOf("bus"), 12.0, 1.0) << "seed " << seed;
        EXPECT_NEAR(lengthOf("truck"), 9.0, 1.0) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Lengths, SeenFromBehind, testing::Values(3.7, 4.4, 5.2));

}  // namespace
}  // namespace vdamf
