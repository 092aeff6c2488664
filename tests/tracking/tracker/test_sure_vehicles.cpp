// SPDX-License-Identifier: BSD-3-Clause
// Parked cars in full view are published from their second frame on.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
// What is published of a car by its first two frames. `keys`: of the car.
std::vector<Seen> seenTwice(const std::string& keys)
{
    const std::string scene = R"(
[scenario]
duration_s = 0.15

[sensor]
z_m = 1.9

[platform]
speed_mps = 0

[object car]
class = car
)";
    return trackedObjects(scenarioOf(scene + keys)).at("car");
}

std::vector<Seen> seenTwice(double x, double headingDegrees)
{
    return seenTwice("y_m = -6\nx_m = " + std::to_string(x) +
                     "\nheading_deg = " + std::to_string(headingDegrees) + "\n");
}

TEST(SureVehicles, ArePublishedFromTheirSecondFrameOn)
{
    for (const double x : {12.0, 15.0, 18.0})
    {
        const std::vector<Seen> seen = seenTwice(x, 180.0);
        ASSERT_EQ(seen.size(), 2U);
        EXPECT_TRUE(seen[0].tracks.empty());
        ASSERT_EQ(seen[1].tracks.size(), 1U) << x;
        EXPECT_LT(std::abs(seen[1].tracks.front().speed), 0.1) << x;
        EXPECT_LT((seen[1].tracks.front().box.centre() - seen[1].truth.box.centre()).norm(), 0.3);
    }
}

// By the first frame alone they might be something else.
TEST(SureVehicles, AreThoseThatTheSecondFrameTells)
{
    for (const auto& [x, headingDegrees] :
         std::vector<std::pair<double, double>>{{18.4, 190.0}, {19.5, 175.0}, {22.9, 170.0}})
    {
        const std::vector<Seen> seen = seenTwice(x, headingDegrees);
        ASSERT_EQ(seen.size(), 2U);
        ASSERT_EQ(seen[1].tracks.size(), 1U) << x;
        EXPECT_GT(seen[1].tracks.front().vehicleProbability.value(), 0.8) << x;
    }
}

// While the speed is not known, nothing tells how a path that turns is bent.
TEST(SureVehicles, TurnFromTheirSecondFrameOn)
{
    for (const double curvature : {-0.125, 0.125})
    {
        const std::vector<Seen> seen =
            seenTwice("x_m = 20\ny_m = " + std::to_string(-64.0 * curvature) +
                      "\nspeed_mps = 5\nsegments = 30 0 " + std::to_string(curvature) + "\n");
        ASSERT_EQ(seen.size(), 2U);
        ASSERT_EQ(seen[1].tracks.size(), 1U) << curvature;
        EXPECT_NEAR(seen[1].tracks.front().yawRate, 5.0 * curvature, 0.15) << curvature;
    }
}

}  // namespace
}  // namespace vdamf
