// SPDX-License-Identifier: BSD-3-Clause
// Line scanners, and several sensors on one platform.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenario_text.h"
#include "simulation/small_scenes.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

TEST(LineScanner, ScansItsFieldOfViewFromRightToLeft)
{
    const SpinningLadar ladar = ladarOf(LadarModel::LMS291);
    const Sweep sweep = sweepOf(ladar, 10.0, ladar.fieldOfView);
    EXPECT_EQ(sweep.firings, 361);
    EXPECT_NEAR(sweep.firstAzimuth, 0.5 * kPi, 1e-12);  // clockwise: to the right
    EXPECT_NEAR(sweep.azimuthStep, -0.5 * kPi / 180.0, 1e-12);
    EXPECT_NEAR(sweep.period * 720.0, 1.0 / 75.0, 1e-12);
    const SpinningLadar lms511 = ladarOf(LadarModel::LMS511);
    EXPECT_EQ(sweepOf(lms511, 10.0, lms511.fieldOfView).firings, 381);
    EXPECT_EQ(sweepOf(lms511, 10.0, 0.5 * kPi).firings, 181);
}

TEST(LineScanner, MeetsAWallAtTheRangesOfItsBearings)
{
    Scene scene;
    scene.objects = {objectAt(ObjectClass::Wall, {10.15, 0.0, 0.5 * kPi, 0, 0}, {200.0, 0.3, 3.0})};
    LadarMount mount = idealMount();
    mount.ladar = ladarOf(LadarModel::LMS291);
    mount.ladar.rangeNoise = 0.0;
    mount.position = {0.0, 0.0, 0.5};
    mount.fieldOfView = mount.ladar.fieldOfView;
    const std::vector<LadarFiring> scan = cast(scene, mount);
    ASSERT_EQ(scan.size(), 361U);
    for (std::size_t i = 0; i < scan.size(); ++i)
    {
        const double bearing = (-90.0 + 0.5 * static_cast<double>(i)) * kPi / 180.0;
        const double expected = 10.0 / std::cos(bearing);
        const bool isInReach = std::abs(bearing) < 1.55 && expected < 80.0;
        EXPECT_NEAR(scan[i].returns.at(0).range, isInReach ? expected : 0.0, 1e-9) << i;
    }
}

const char* const kThree = R"([scenario]
duration_s = 1
rate_hz = 10
[sensor roof]
model = VLP-16
z_m = 1.9
[sensor front]
model = LMS-291
rate_hz = 25
delay_s = 0.01
x_m = 3.7
z_m = 0.5
[sensor rear]
model = LMS-511
rate_hz = 5
heading_deg = 180
z_m = 0.5
[object ahead]
class = car
x_m = 15
speed_mps = 2
)";

TEST(Sensors, EachScansAtItsOwnRateInsideTheFrames)
{
    const Scenario scenario = scenarioOf(kThree);
    EXPECT_EQ(scenario.frames(), 10);
    std::vector<std::vector<double>> times(3);
    for (int i = 0; i < scenario.frames(); ++i)
    {
        const SimulatedFrame frame = simulateFrame(scenario, i);
        EXPECT_EQ(frame.scans.at(0).sensor, 0U);
        EXPECT_EQ(frame.scans.at(0).time, frame.time);
        double last = frame.time;
        for (const SimulatedScan& scan : frame.scans)
        {
            EXPECT_GE(scan.time, last);
            EXPECT_LT(scan.time, frame.time + 0.1 - 1e-9);
            last = scan.time;
            times.at(scan.sensor).push_back(scan.time);
        }
    }
    ASSERT_EQ(times[0].size(), 10U);
    ASSERT_EQ(times[1].size(), 25U);
    ASSERT_EQ(times[2].size(), 5U);
    for (std::size_t i = 0; i < 25; ++i)
        EXPECT_NEAR(times[1][i], 0.01 + 0.04 * static_cast<double>(i), 1e-9);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(times[2][i], 0.2 * static_cast<double>(i), 1e-9);
}

TEST(Sensors, TruthCountsTheHitsOfAllAndSaysWhereTheFirstOneIs)
{
    const Scenario scenario = scenarioOf(kThree);
    const SimulatedFrame frame = simulateFrame(scenario, 2);
    int hits = 0;
    for (const SimulatedScan& scan : frame.scans) hits += countHits(scan.firings, 1).at(0);
    EXPECT_EQ(frame.truth.at(0).points, hits);
    EXPECT_GT(hits, countHits(frame.scans.at(0).firings, 1).at(0));

    const Scenario moving = scenarioOf(
        "[sensor]\nx_m = 1\ny_m = 0.5\n[platform]\nx_m = 7\nheading_deg = 90\nspeed_mps = 10\n"
        "[object a]\nclass = car\nx_m = 30\n");
    const TruthRow row = simulateFrame(moving, 10).truth.at(0);
    ASSERT_TRUE(row.sensor);
    EXPECT_NEAR(row.sensor->x, -0.5, 1e-9);
    EXPECT_NEAR(row.sensor->y, 11.0, 1e-9);
    EXPECT_NEAR(row.sensor->heading, 0.5 * kPi, 1e-12);
}

TEST(Sensors, HaveRandomNumbersOfTheirOwn)
{
    // Two of the same kind at the same place see the same scene with different noise; the first
    // one sees what it sees alone.
    const std::string one = "[sensor a]\nmodel = VLP-16\n";
    const std::string two = one + "[sensor b]\nmodel = VLP-16\n";
    const std::vector<SimulatedScan> alone = simulateFrame(scenarioOf(one), 1).scans;
    const std::vector<SimulatedScan> both = simulateFrame(scenarioOf(two), 1).scans;
    ASSERT_EQ(both.size(), 2U);
    const auto rangeOf = [](const SimulatedScan& scan)
    { return scan.firings.at(100).returns.at(0).range; };
    EXPECT_EQ(rangeOf(alone.at(0)), rangeOf(both.at(0)));
    EXPECT_NE(rangeOf(both.at(0)), rangeOf(both.at(1)));
    EXPECT_NEAR(rangeOf(both.at(0)), rangeOf(both.at(1)), 0.3);
}

TEST(Sensors, WhatTheyCannotDoIsSaidWithPlaceAndKey)
{
    EXPECT_THAT(errorOf("[sensor]\nmodel = VLP-16\nrate_hz = 25\n"),
                HasSubstr("small.ini:3: sensor.rate_hz = '25': the sensor scans at most 20 "));
    EXPECT_THAT(errorOf("[sensor]\nmodel = VLP-16\nresolution_deg = 1\n"),
                HasSubstr("small.ini:3: sensor.resolution_deg = '1': only line scanners"));
    EXPECT_THAT(errorOf("[sensor a]\nmodel = LMS-291\nfield_of_view_deg = 190\n"),
                HasSubstr("small.ini:3: sensor a.field_of_view_deg = '190': the sensor has 180 "));
    EXPECT_THAT(errorOf("[sensor a]\nmodel = LMS-291\nfield_of_view_deg = 0.1\n"),
                HasSubstr("small.ini:3, small.ini: sensor a.field_of_view_deg: is smaller than"));
    EXPECT_THAT(errorOf("[sensor]\n[sensor velodyne]\n"),
                HasSubstr("the label 'velodyne' is taken already"));
    EXPECT_THAT(errorOf("[sensor ins]\n"), HasSubstr("the label 'ins' is taken already"));
    EXPECT_THAT(errorOf("[sensor a]\ndelay_s = 0.1\n"),
                HasSubstr("small.ini:2: sensor a.delay_s = '0.1': the first sensor's scans"));
    EXPECT_THAT(errorOf("[sensor a]\nmodle = VLP-16\n"), HasSubstr("unknown key sensor a.modle"));
    EXPECT_THAT(errorOf("[ins]\ngap_every_s = 2\ngap_length_s = 2\n"),
                HasSubstr("small.ini:3, small.ini:2: ins.gap_length_s = 2 must be below "));
    EXPECT_THAT(errorOf("[output]\npose_source = actions\n"),
                HasSubstr("small.ini:2, small.ini: output.pose_source: actions need "));
}

TEST(Sensors, OnASlopeTheTruthHasHeights)
{
    const Scenario scenario = scenarioOf(
        "[terrain]\nslope_percent = 10\n[platform]\nx_m = 50\n[object up]\nclass = car\nx_m = "
        "70\n");
    const TruthRow row = simulateFrame(scenario, 0).truth.at(0);
    EXPECT_NEAR(row.z, 2.0, 1e-9);  // over the platform's first pose
    EXPECT_NEAR(row.box.x, 20.0, 1e-9);
    EXPECT_GT(row.points, 40);
}
}  // namespace
}  // namespace vdamf
