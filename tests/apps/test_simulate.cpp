// SPDX-License-Identifier: BSD-3-Clause
// vdamf-simulate through its command line, and its scans through the decoder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "apps/simulate_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/rawlog_reader.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
namespace fs = std::filesystem;

class Simulate : public SimulateFixture
{
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

TEST_F(Simulate, WholeNumbersAreDecimal)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --seed 10 --gz-level 1"), 0);
    ASSERT_EQ(run("scene.ini -o b.rawlog --seed 010 --gz-level 01"), 0);
    EXPECT_EQ(contentOf("a.rawlog"), contentOf("b.rawlog"));
    for (const std::string bad : {"0x10", "1e1", "1.0", "0b1", "1 ", "a"})
    {
        EXPECT_EQ(run("scene.ini -o c.rawlog --seed '" + bad + "'"), 2);
        EXPECT_THAT(contentOf("err.txt"),
                    HasSubstr("--seed: '" + bad + "': expected a whole number"));
    }
    for (const auto& [app, option] : std::vector<std::pair<std::string, std::string>>{
             {"vdamf-evaluate", "--min-points"},
             {"vdamf-import", "kitti-raw drive --gz-level"},
             {"vdamf-report", "--hits-per-frame"},
             {"vdamf-train", "classifier list.ini --folds"},
             {"vdamf-train", "filter list.ini --global"}})
    {
        const Outcome refused = runApp(app, option + " 0x4");
        EXPECT_EQ(refused.exitCode, 2) << app;
        EXPECT_THAT(refused.output, HasSubstr(": '0x4': expected a whole number")) << app;
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
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("vdamf-simulate: a: is named for two outputs"));
    EXPECT_EQ(run("scene.ini -o a --truth a.partial"), 2);
    EXPECT_EQ(run("scene.ini -o a.rawlog --unknown"), 2);
    EXPECT_THAT(contentOf("err.txt"), testing::StartsWith("vdamf-simulate: "));
    EXPECT_EQ(run("scene.ini -o a.rawlog --set platform.sped_mps=1"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("speed_mps"));
    EXPECT_EQ(run("scene.ini -o a.rawlog --set speed"), 2);
    EXPECT_EQ(run("scene.ini -o a.rawlog --set sensor.rate_hz=30"), 2);
    EXPECT_THAT(contentOf("err.txt"),
                HasSubstr("--set: sensor.rate_hz = '30': the sensor scans at most 20 times"));
    EXPECT_EQ(run("missing.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("missing.ini"));
    std::ofstream(path("bad.ini")) << "[platform]\nsped_mps = 3\n";
    EXPECT_EQ(run("bad.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("bad.ini:2: unknown key platform.sped_mps"));
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("speed_mps"));
    std::ofstream(path("own.ini")) << "[sensor vdamf_tracks]\n";
    EXPECT_EQ(run("own.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"),
                HasSubstr("own.ini: [sensor vdamf_tracks]: the label 'vdamf_tracks' begins with"));
    EXPECT_FALSE(fs::exists(path("a.rawlog")));
    EXPECT_EQ(run("--help"), 0);
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("Example"));
}

TEST_F(Simulate, SaysWhatIsWrongWithATableOfTraffic)
{
    const std::string scene = contentOf("scene.ini") + "\n[traffic]\ntable = traffic.csv\n";
    std::ofstream(path("traffic.ini")) << scene;
    EXPECT_EQ(run("traffic.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("traffic.csv: cannot read"));
    std::ofstream(path("traffic.csv")) << "x,y\n1,2\n";
    EXPECT_EQ(run("traffic.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("traffic.csv:1: the column 'time_s' is missing"));
    std::ofstream(path("traffic.csv")) << truthHeader();
    EXPECT_EQ(run("traffic.ini -o a.rawlog"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("traffic.csv: holds no object"));
    EXPECT_EQ(run("scene.ini -o a.rawlog --set traffic.smoothing_s=1"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("--set: traffic.table: is missing"));
    EXPECT_FALSE(fs::exists(path("a.rawlog")));
}

TEST_F(Simulate, SaysWhichTrafficItLeavesOut)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --truth a.csv --set scenario.duration_s=0.3"), 0);
    std::ofstream(path("again.ini")) << "[traffic]\ntable = a.csv\n[sensor]\nmodel = VLP-16\n";
    ASSERT_EQ(run("again.ini -q -o b.rawlog --truth b.csv"), 0);
    EXPECT_EQ(contentOf("err.txt"),
              "a.csv: 1 of its 1 objects have fewer than 5 labels and are left out: 'ahead'\n");
    EXPECT_EQ(contentOf("b.csv"), truthHeader());
}

TEST_F(Simulate, NeverWritesOverItsScenario)
{
    const std::string before = contentOf("scene.ini");
    EXPECT_EQ(run("scene.ini -o scene.ini --overwrite"), 2);
    EXPECT_THAT(contentOf("err.txt"), HasSubstr("is the scenario"));
    EXPECT_EQ(run("scene.ini -o a.rawlog --truth ./scene.ini --overwrite"), 2);
    fs::copy(path("scene.ini"), path("b.rawlog.partial"));
    EXPECT_EQ(run("b.rawlog.partial -o b.rawlog --overwrite"), 2);
    EXPECT_EQ(contentOf("scene.ini"), before);
    EXPECT_EQ(contentOf("b.rawlog.partial"), before);
}

TEST_F(Simulate, SetGoesOverTheScenario)
{
    ASSERT_EQ(run("scene.ini -o a.rawlog --truth a.csv --set platform.speed_mps=0 "
                  "--set 'object ahead.speed_mps=12'"),
              0)
        << contentOf("err.txt");
    const std::vector<TruthRow> truth = readTruth(path("a.csv"));
    EXPECT_NEAR(truth.at(0).speed, 12.0, 1e-6);
    EXPECT_NEAR(truth.at(0).sensor->x, truth.at(4).sensor->x, 1e-6);
    EXPECT_EQ(run("--version"), 0);
    EXPECT_THAT(contentOf("out.txt"), testing::MatchesRegex("vdamf-simulate [0-9.]+\\s*"));
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
