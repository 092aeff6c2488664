// SPDX-License-Identifier: BSD-3-Clause
// vdamf-simulate through its command line, and its scans through the decoder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
namespace fs = std::filesystem;

const char* const kScenario = R"([scenario]
duration_s = 0.5
start_time_s = 1700000000
[sensor]
model = @
half_loss_strength = 0
[platform]
x_m = 20
y_m = -7
heading_deg = 30
speed_mps = 6
[object ahead]
class = car
x_m = 30
y_m = 0
heading_deg = 30
speed_mps = 5
segments = 1 0 0.05
[object pole]
class = pole
x_m = 25
y_m = 5
)";

class Simulate : public TemporaryFolder
{
protected:
    void SetUp() override { writeScenario("VLP-16"); }

    fs::path path(const std::string& name) const { return at(name); }

    void writeScenario(const std::string& model)
    {
        std::string text = kScenario;
        text.replace(text.find('@'), 1, model);
        std::ofstream(path("scene.ini")) << text;
    }

    /// Runs the program in the folder; its exit code. Output: out.txt, errors: err.txt.
    int run(const std::string& arguments) const
    {
        return runShell("cd '" + at("").string() + "' && '" VDAMF_APPS_DIR "/vdamf-simulate' " +
                        arguments + " >out.txt 2>err.txt")
            .exitCode;
    }
};

TEST_F(Simulate, WritesScansPosesAndTruth)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --truth a.csv"), 0) << contentOf("err.txt");
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("frames      5"));
    RawlogReader reader(path("a.rawlog"));
    int scans = 0;
    int poses = 0;
    double lastTime = 0.0;
    while (const auto entry = reader.next())
    {
        const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object);
        ASSERT_TRUE(observation);
        const double time = mrpt::Clock::toDouble(observation->timestamp);
        EXPECT_GE(time, lastTime - 1e-6);
        lastTime = time;
        if (std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(observation)) ++scans;
        if (std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(observation)) ++poses;
    }
    EXPECT_EQ(scans, 5);
    EXPECT_GE(poses, 26);
    EXPECT_GE(lastTime, 1700000000.5 - 1e-6);
    const std::vector<TruthRow> truth = readTruth(path("a.csv"));
    ASSERT_EQ(truth.size(), 5U);
    EXPECT_NEAR(truth[0].box.x, 10.0, 1e-3);
    EXPECT_NEAR(truth[0].box.y, 7.0, 1e-3);
    EXPECT_NEAR(truth[4].time, 1700000000.4, 1e-6);
}

TEST_F(Simulate, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --truth a.csv"), 0);
    ASSERT_EQ(run("scene.ini -o b.rawlog --truth b.csv"), 0);
    ASSERT_EQ(run("scene.ini -o c.rawlog --seed 2"), 0);
    EXPECT_EQ(contentOf("a.rawlog"), contentOf("b.rawlog"));
    EXPECT_EQ(contentOf("a.csv"), contentOf("b.csv"));
    EXPECT_NE(contentOf("a.rawlog"), contentOf("c.rawlog"));
}

/// The returns of a revolution in the sensor's frame, exact, in the order of the packets.
std::vector<Eigen::Vector3d> pointsOf(const SimulatedFrame& frame, const SpinningLadar& ladar)
{
    const double step = 2.0 * kPi / static_cast<double>(frame.firings.size());
    std::vector<Eigen::Vector3d> points;
    for (const LadarFiring& firing : frame.firings)
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const double range = firing.returns[laser].range;
            if (range == 0.0) continue;
            const double e = ladar.elevations[laser];
            const double a = firing.azimuth + step * ladar.laserDelays[laser] / ladar.firingPeriod;
            points.emplace_back(range * std::cos(e) * std::cos(a),
                                -range * std::cos(e) * std::sin(a), range * std::sin(e));
        }
    }
    return points;
}

TEST_F(Simulate, DecodedScansHaveTheSimulatedPoints)
{
    for (const char* model : {"VLP-16", "HDL-32E", "HDL-64E"})
    {
        writeScenario(model);
        ASSERT_EQ(run("scene.ini -o a.rawlog --overwrite"), 0) << contentOf("err.txt");
        const Scenario scenario = readScenario(IniDocument::load(path("scene.ini")));
        RawlogReader reader(path("a.rawlog"));
        mrpt::obs::CObservationVelodyneScan::Ptr scan;
        while (!scan)
        {
            const auto entry = reader.next();
            ASSERT_TRUE(entry);
            scan = std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entry->object);
        }
        EXPECT_NEAR(scan->sensorPose.z(), 2.0, 1e-9);
        const PointCloud cloud = decodeVelodyne(*scan);
        const std::vector<Eigen::Vector3d> expected =
            pointsOf(simulateFrame(scenario, 0), scenario.mount.ladar);
        ASSERT_EQ(cloud.size(), expected.size()) << model;
        ASSERT_GT(cloud.size(), 10000U);
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
            const Eigen::Vector3d point(cloud.x[i], cloud.y[i], cloud.z[i]);
            // Packets hold 2 mm of range and 0.01 degrees of azimuth.
            const double allowed = 0.0015 + 1e-4 * expected[i].norm();
            ASSERT_LT((point - expected[i]).norm(), allowed) << model << ", return " << i;
        }
    }
}

TEST(SimulatedSensors, HaveTheBeamsOfTheDecoder)
{
    const std::pair<LadarModel, VelodyneModel> models[] = {
        {LadarModel::VLP16, VelodyneModel::VLP16},
        {LadarModel::HDL32E, VelodyneModel::HDL32E},
        {LadarModel::HDL64E, VelodyneModel::HDL64E}};
    for (const auto& [simulated, decoded] : models)
    {
        const std::vector<double> beams = ladarOf(simulated).elevations;
        const std::vector<double>& expected = laserElevations(decoded);
        ASSERT_EQ(beams.size(), expected.size());
        for (std::size_t i = 0; i < beams.size(); ++i) EXPECT_NEAR(beams[i], expected[i], 1e-12);
    }
}

TEST_F(Simulate, FrozenRevolutionsHaveOneTime)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog"), 0);
    RawlogReader reader(path("a.rawlog"));
    while (const auto entry = reader.next())
    {
        const auto scan =
            std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entry->object);
        if (!scan) continue;
        // Within the 1.3 ms of one packet, in which a car at 30 m/s moves 4 cm.
        for (const float time : decodeVelodyne(*scan).time) EXPECT_LT(time, 0.0014F);
    }
}

TEST_F(Simulate, RefusesToReplaceOutputsWithoutBeingTold)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --truth a.csv"), 0);
    EXPECT_EQ(run("scene.ini -o a.rawlog"), 1);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("--overwrite"));
    EXPECT_EQ(run("scene.ini -o new.rawlog --truth a.csv"), 1);
    EXPECT_FALSE(fs::exists(path("new.rawlog")));
    EXPECT_EQ(run("scene.ini -o a.rawlog --truth a.csv --overwrite"), 0);
}

TEST_F(Simulate, BadUseAndBadScenariosEndWithTwo)
{
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("scene.ini"), 2);
    EXPECT_EQ(run("scene.ini -o a.rawlog --gz-level 11"), 2);
    EXPECT_EQ(run("scene.ini -o a --truth a"), 2);
    EXPECT_EQ(run("missing.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("missing.ini"));
    std::ofstream(path("bad.ini")) << "[platform]\nsped_mps = 3\n";
    EXPECT_EQ(run("bad.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("bad.ini:2: unknown key platform.sped_mps"));
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("speed_mps"));
    EXPECT_FALSE(fs::exists(path("a.rawlog")));
    EXPECT_EQ(run("--help"), 0);
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("Example"));
}

TEST_F(Simulate, AFailedJobEndsWithOneAndLeavesNothing)
{
    EXPECT_EQ(run("scene.ini -o missing_folder/a.rawlog"), 1);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("missing_folder"));
    EXPECT_EQ(run("scene.ini -o a.rawlog --truth missing_folder/a.csv"), 1);
    EXPECT_FALSE(fs::exists(path("a.rawlog")));
    EXPECT_FALSE(fs::exists(path("a.rawlog.partial")));
}
}  // namespace
}  // namespace vdamf
