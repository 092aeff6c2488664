// SPDX-License-Identifier: BSD-3-Clause
// Scenario files: what they mean, and what is said where they are wrong.
#include "vdamf/simulation/scenario.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/scenario_text.h"
#include "vdamf/simulation/segments.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

const char* const kSmall = R"([scenario]
duration_s = 1
rate_hz = 10
start_time_s = 1700000000
seed = 4
[sensor]
model = VLP-16
z_m = 1.8
[platform]
x_m = 100
y_m = 50
heading_deg = 90
speed_mps = 5
[object ahead]
class = van
x_m = 100
y_m = 65
heading_deg = 90
speed_mps = 6
segments = 0.5 2 0, 1 0 0.05
[object hedge]
class = bush
x_m = 104
y_m = 60
)";

bool operator==(const LadarReturn& a, const LadarReturn& b)
{
    return a.range == b.range && a.intensity == b.intensity && a.object == b.object;
}

bool sameReturns(const SimulatedFrame& a, const SimulatedFrame& b)
{
    const std::vector<LadarFiring>& first = a.scans.at(0).firings;
    const std::vector<LadarFiring>& second = b.scans.at(0).firings;
    if (first.size() != second.size()) return false;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        const auto& x = first[i].returns;
        const auto& y = second[i].returns;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            if (!(x[k] == y[k])) return false;
        }
    }
    return true;
}

TEST(Scenario, KeysAreRead)
{
    const Scenario scenario = scenarioOf(kSmall);
    EXPECT_EQ(scenario.frames(), 10);
    EXPECT_EQ(scenario.sensors.at(0).mount.ladar.elevations.size(), 16U);
    EXPECT_EQ(scenario.sensors.at(0).mount.position.z(), 1.8);
    EXPECT_TRUE(scenario.sensors.at(0).mount.instantaneous);
    ASSERT_EQ(scenario.scene.objects.size(), 2U);
    EXPECT_EQ(scenario.scene.objects[0].name, "ahead");
    EXPECT_EQ(scenario.scene.objects[1].objectClass, ObjectClass::Bush);
    const MotionState platform = scenario.scene.platform.at(1.0);
    EXPECT_NEAR(platform.x, 100.0, 1e-9);
    EXPECT_NEAR(platform.y, 55.0, 1e-9);
}

TEST(Scenario, SensorKeysReachTheMount)
{
    const LadarMount mount = scenarioOf(
                                 "[scenario]\nrate_hz = 5\n[sensor]\nmodel = HDL-64E\nx_m = 1\n"
                                 "y_m = -2\nz_m = 3\nheading_deg = 90\nfield_of_view_deg = 180\n"
                                 "range_noise_m = 0.05\nmax_range_m = 40\nglass_loss = 0.5\n"
                                 "half_loss_strength = 0.01\ninstantaneous = false\n")
                                 .sensors.at(0)
                                 .mount;
    EXPECT_EQ(mount.ladar.elevations.size(), 64U);
    EXPECT_EQ(mount.position, Eigen::Vector3d(1, -2, 3));
    EXPECT_NEAR(mount.heading, 0.5 * kPi, 1e-12);
    EXPECT_NEAR(mount.fieldOfView, kPi, 1e-12);
    EXPECT_EQ(mount.rate, 5.0);
    EXPECT_EQ(mount.ladar.rangeNoise, 0.05);
    EXPECT_EQ(mount.ladar.maxRange, 40.0);
    EXPECT_EQ(mount.glassLoss, 0.5);
    EXPECT_EQ(mount.halfLossStrength, 0.01);
    EXPECT_FALSE(mount.instantaneous);
    EXPECT_EQ(scenarioOf("[sensor]\nmodel = VLP-16\n").sensors.at(0).mount.ladar.maxRange, 100.0);
}

TEST(Scenario, FramesBeginInsideTheDuration)
{
    Scenario scenario;
    scenario.run.duration = 1.1;  // 1.1 * 10 is a rounding error above 11
    EXPECT_EQ(scenario.frames(), 11);
    scenario.run.duration = 1.12;
    EXPECT_EQ(scenario.frames(), 12);
}

TEST(Scenario, TruthListsVehiclesInTheFrameOfTheFirstPose)
{
    const Scenario scenario = scenarioOf(kSmall);
    const SimulatedFrame first = simulateFrame(scenario, 0);
    ASSERT_EQ(first.truth.size(), 1U);
    const TruthRow& start = first.truth[0];
    EXPECT_EQ(start.time, 1700000000.0);
    EXPECT_EQ(start.objectId, "ahead");
    EXPECT_EQ(start.objectClass, "Van");
    EXPECT_NEAR(start.box.x, 0.0, 1e-9);
    EXPECT_NEAR(start.box.y, 15.0, 1e-9);
    EXPECT_NEAR(start.box.heading, 0.5 * kPi, 1e-12);
    EXPECT_EQ(start.box.length, 5.4);
    EXPECT_EQ(start.height, 2.1);
    EXPECT_EQ(start.z, 0.0);
    EXPECT_EQ(start.speed, 6.0);
    EXPECT_GT(start.points, 50);

    const TruthRow later = simulateFrame(scenario, 8).truth[0];
    EXPECT_NEAR(later.time, 1700000000.8, 1e-6);
    EXPECT_NEAR(later.speed, 7.0, 1e-9);
    EXPECT_NEAR(later.box.heading, 0.5 * kPi + 0.05 * 7.0 * 0.3, 1e-9);
}

TEST(Scenario, ABoxesCentreLiesAheadOfItsRearAxleInABend)
{
    const Scenario scenario =
        scenarioOf("[object a]\nclass = car\nspeed_mps = 5\nlength_m = 4\nsegments = 9 0 0.1\n");
    const SceneObject& car = scenario.scene.objects.at(0);
    EXPECT_NEAR(boxAt(car, 0.0).x, 0.0, 1e-12);
    for (const double time : {0.5, 1.3})
    {
        const OrientedBox box = boxAt(car, time);
        const MotionState axle = car.trajectory.at(time);
        EXPECT_NEAR(box.x - axle.x, 0.28 * 4.0 * std::cos(axle.heading), 1e-12);
        EXPECT_NEAR(box.y - axle.y, 0.28 * 4.0 * std::sin(axle.heading), 1e-12);
        EXPECT_NEAR(axle.yawRate, 0.5, 1e-12);
    }
}

TEST(Scenario, AFrameDependsOnItsSeedAndNumberAlone)
{
    Scenario scenario = scenarioOf(kSmall);
    const SimulatedFrame frame = simulateFrame(scenario, 3);
    simulateFrame(scenario, 5);
    EXPECT_TRUE(sameReturns(frame, simulateFrame(scenario, 3)));
    scenario.run.seed = 5;
    EXPECT_FALSE(sameReturns(frame, simulateFrame(scenario, 3)));
}

TEST(Scenario, AllProblemsAreListedWithLineAndNearestKey)
{
    const std::string error = errorOf(
        "[sensor]\nmodel = VLP-17\nheigth_m = 2\n[objekt a]\nclass = car\n"
        "[object b]\nclass = cat\nspeed_mps = fast\n");
    EXPECT_THAT(error, HasSubstr("small.ini:2: sensor.model"));
    EXPECT_THAT(error, HasSubstr("VLP-16"));
    EXPECT_THAT(error, HasSubstr("small.ini:3: unknown key sensor.heigth_m"));
    EXPECT_THAT(error, HasSubstr("small.ini:4: unknown section [objekt a]"));
    EXPECT_THAT(error, HasSubstr("small.ini:7: object b.class"));
    EXPECT_THAT(error, HasSubstr("small.ini:8: object b.speed_mps"));
}

TEST(Scenario, BadSegmentsAndSizesAreNamed)
{
    const std::string error = errorOf(
        "[platform]\nspeed_mps = 3\nsegments = 1 0 0, 2 0\n"
        "[object tiny]\nclass = car\nlength_m = 1\n[object a,b]\nclass = pole\n");
    EXPECT_THAT(error, HasSubstr("small.ini:3: platform.segments: segment 2 is '2 0'"));
    EXPECT_THAT(error, HasSubstr("small.ini:6: object tiny.length_m: a car is at least"));
    EXPECT_THAT(error, HasSubstr("small.ini:8: object a,b"));
}

TEST(Scenario, NamesThatOtherFilesCannotHoldAreRefused)
{
    for (const std::string name : {"\"ab", "a\"b", " a", "a,b"})
        EXPECT_THAT(errorOf("[object " + name + "]\nclass = car\n"),
                    HasSubstr("the object's name must be a text without comma, quotation mark"))
            << name;
}

TEST(Scenario, LabelsThatNoIniFileCanHoldAreRefused)
{
    IniDocument document;
    document.set("sensor front #1.z_m=2");
    EXPECT_THAT([&] { readScenario(document); },
                testing::ThrowsMessage<IniError>(
                    HasSubstr("[sensor front #1]: the name must be a text without line break")));
}

TEST(Segments, AreThreeNumbersEach)
{
    EXPECT_TRUE(parseSegments("  ").empty());
    const auto segments = parseSegments("1 -2.5 0.1 ,\t3 0 -0.2");
    ASSERT_EQ(segments.size(), 2U);
    EXPECT_EQ(segments[0].acceleration, -2.5);
    EXPECT_EQ(segments[1].duration, 3.0);
    EXPECT_EQ(segments[1].curvature, -0.2);
    for (const char* bad :
         {"1 2", "1 2 3 4", "1 2 0,", "0 1 0", "-1 1 0", "1 1 0.1x", "1 99 0", "1 0 2"})
    {
        EXPECT_THROW(parseSegments(bad), std::runtime_error) << bad;
    }
}
}  // namespace
}  // namespace vdamf
