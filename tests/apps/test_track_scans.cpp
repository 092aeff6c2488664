// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: kinds of scans, and several sensors on one vehicle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class TrackScans : public TrackProgram
{
protected:
    void simulate(const std::string& sensors) const
    {
        std::ofstream(at("scene.ini"))
            << "[scenario]\nduration_s = 3\nstart_time_s = 1700000000\n"
            << sensors
            << "[platform]\nspeed_mps = 8\n"
               "[object ahead]\nclass = car\nx_m = 16\nspeed_mps = 8\n"
               "[object parked]\nclass = car\nx_m = 20\ny_m = 4\nheading_deg = 180\n"
               "[object parked_on]\nclass = car\nx_m = 30\ny_m = 4\nheading_deg = 180\n";
        const Outcome run = runApp("vdamf-simulate", path("scene.ini") + out("a.rawlog"));
        ASSERT_EQ(run.exitCode, 0) << run.output;
    }

    Outcome trackWith(const std::string& options) const
    {
        return track(in("a.rawlog") + " --tracks " + path("t.csv") + " --overwrite " + options);
    }

    std::set<double> frameTimes() const
    {
        std::set<double> times;
        for (const TrackRow& row : readTracks(at("t.csv"))) times.insert(row.time);
        return times;
    }
};

const std::string kBumper =
    "[sensor bumper]\nmodel = LMS-511\nx_m = 3.6\nz_m = 0.55\nrate_hz = 25\n";
const std::string kRoof = "[sensor roof]\nmodel = VLP-16\nx_m = 1.6\nz_m = 1.8\n";
const std::string kSides =
    "[sensor left]\nmodel = VLP-16\nx_m = 1.6\ny_m = 0.7\nz_m = 1.7\nheading_deg = 60\n"
    "field_of_view_deg = 240\ninstantaneous = false\n"
    "[sensor right]\nmodel = VLP-16\nx_m = 1.6\ny_m = -0.7\nz_m = 1.7\nheading_deg = -60\n"
    "field_of_view_deg = 240\ndelay_s = 0.05\ninstantaneous = false\n";

TEST_F(TrackScans, OfALineScannerShowNoGroundButCars)
{
    simulate(kBumper);
    const Outcome run = trackWith("");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             75 of 75 scans"));
    std::map<std::uint64_t, TrackRow> last;
    for (const TrackRow& row : readTracks(at("t.csv")))
        if (row.report.status == TrackStatus::Confirmed) last[row.report.id] = row;
    bool follows = false;
    for (const auto& [id, row] : last)
    {
        EXPECT_GT(row.report.box.x, 10.0) << "nothing but the cars is there";
        // After 3 s, with the last frame at 2.96 s.
        const bool isAhead = std::abs(row.report.box.y) < 0.5 && std::abs(row.report.speed) > 4.0;
        if (!isAhead) continue;
        follows = true;
        EXPECT_NEAR(std::abs(row.report.speed), 8.0, 0.3);
        EXPECT_NEAR(row.report.box.x, 16.0 + 8.0 * 2.96, 2.5);
    }
    EXPECT_TRUE(follows);
    EXPECT_GE(last.size(), 3U);
    EXPECT_LE(last.size(), 4U);
}

TEST_F(TrackScans, OfALineScannerBesideAnotherSensorAreLeftOut)
{
    simulate(kBumper + kRoof);
    Outcome run = trackWith("");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             30 of 30 scans"));
    run = trackWith("--set scan.label=bumper");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             75 of 75 scans"));
}

TEST_F(TrackScans, OfSeveralSensorsAreFramesOfTheirOwnOrOne)
{
    simulate(kSides);
    Outcome run = trackWith("");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("frames             60 of 60 scans"), Not(HasSubstr("merged"))));
    EXPECT_GT(frameTimes().size(), 50U);
    run = trackWith("--set scan.merge_s=0.06 -o " + path("b.rawlog"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             30 of 60 scans, 30 merged"));
    EXPECT_GT(frameTimes().size(), 25U);
    EXPECT_LE(frameTimes().size(), 30U);
    run = trackWith("--set scan.merge_s=0.06 --frames 10:15");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             5 of 10 scans, 5 merged"));
    EXPECT_NEAR(*frameTimes().begin(), 1700000001.0, 1e-3);
    // Scans that begin later than that stay frames of their own.
    run = trackWith("--set scan.merge_s=0.04");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             60 of 60 scans"));
    run = trackWith("--set scan.merge_s=0.3");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("merge_s"));
}

}  // namespace
}  // namespace vdamf
