// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that share their clusters with hedges and walls.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
const std::string kScene = R"(
[scenario]
duration_s = 4

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
y_m = -1.75
speed_mps = 4

[object parked]
class = car
x_m = 20
y_m = -4.35
heading_deg = 0
)";

std::string bushAt(int number, double x, double length)
{
    return "\n[object bush_" + std::to_string(number) +
           "]\nclass = bush\nlength_m = " + std::to_string(length) +
           "\nwidth_m = 2\nheight_m = 1.3\ny_m = -6.2\nx_m = " + std::to_string(x) + "\n";
}

void expectTracked(const std::string& scene)
{
    for (const int seed : {1, 2, 3})
    {
        std::size_t found = 0;
        std::size_t frames = 0;
        std::set<std::uint64_t> ids;
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        for (const Seen& seen : tracked.at("parked"))
        {
            if (seen.time < 1.5 || seen.truth.points < 20) continue;
            ++frames;
            if (seen.tracks.empty()) continue;
            const TrackReport& track = seen.tracks.front();
            const double turned = std::remainder(track.box.heading - seen.truth.box.heading, kPi);
            const bool isThere = (track.box.centre() - seen.truth.box.centre()).norm() < 0.5;
            if (!isThere || std::abs(turned) > 0.15) continue;
            ++found;
            ids.insert(track.id);
        }
        EXPECT_GT(frames, 20U);
        EXPECT_GE(found, frames - 2) << "seed " << seed;
        EXPECT_EQ(ids.size(), 1U) << "seed " << seed;
    }
}

TEST(VehiclesBeside, ACarAlone)
{
    expectTracked(kScene);
}

TEST(VehiclesBeside, ACarBesideABush)
{
    expectTracked(kScene + bushAt(1, 17.0, 7.0));
}

TEST(VehiclesBeside, ACarBesideAHedgeThatIsLongerThanAllThatIsTracked)
{
    std::string scene = kScene;
    for (int k = 0; k < 8; ++k) scene += bushAt(k, 7.0 * k - 3.0, 8.0);
    expectTracked(scene);
}

// Its side is as wide as the end of a car that would stand in the one beside it.
TEST(VehiclesBeside, AMotorcycleBesideACar)
{
    const std::string scene = R"(
[scenario]
duration_s = 4

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
speed_mps = 2

[object car]
class = car
x_m = 12
y_m = 5.2

[object motorcycle]
class = motorcycle
x_m = 12
y_m = 3.2
)";
    for (const int seed : {1, 2, 3})
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        std::set<std::uint64_t> ids;
        std::size_t found = 0;
        for (const Seen& seen : tracked.at("motorcycle"))
        {
            if (seen.tracks.empty()) continue;
            const TrackReport& track = seen.tracks.front();
            ++found;
            ids.insert(track.id);
            EXPECT_LT(std::abs(std::remainder(track.box.heading, kPi)), 0.2);
        }
        EXPECT_GT(found, 30U) << "seed " << seed;
        EXPECT_EQ(ids.size(), 1U) << "seed " << seed;
    }
}

// Its side is 1.3 m from the sensor of a small robot: most of it lies within what a large platform
// could be.
TEST(VehiclesBeside, ACarThatPassesARobotAtArmsLength)
{
    const std::string scene = R"(
[scenario]
duration_s = 9

[sensor]
model = VLP-16
x_m = 0.2
z_m = 1.0

[platform]
speed_mps = 1.2

[object car]
class = car
x_m = 20
y_m = 2.2
heading_deg = 180
speed_mps = 3
)";
    for (const int seed : {1, 2})
    {
        const auto tracked = trackedObjects(scenarioOf(scene, seed));
        std::set<std::uint64_t> ids;
        for (const Seen& seen : tracked.at("car"))
        {
            if (seen.time < 1.0) continue;
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(seen.time) + " s");
            ASSERT_FALSE(seen.tracks.empty());
            const TrackReport& track = seen.tracks.front();
            ids.insert(track.id);
            EXPECT_NEAR(track.speed, 3.0, 0.6);
            EXPECT_LT(std::abs(wrapAngle(track.box.heading - kPi)), 0.1);
        }
        EXPECT_EQ(ids.size(), 1U) << "seed " << seed;
    }
}

}  // namespace
}  // namespace vdamf
