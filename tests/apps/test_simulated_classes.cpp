// SPDX-License-Identifier: BSD-3-Clause
// One scene written through every class of scans and every source of poses that can carry it: the
// tracks must agree within what the class can tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

using Tracks = std::map<double, std::vector<TrackReport>>;  // confirmed, by time

class SimulatedClasses : public Track
{
protected:
    /// The scene heads east, so that odometry's axes are those of the scene.
    void SetUp() override
    {
        std::ofstream(at("scene.ini"))
            << "[scenario]\nduration_s = 1.6\nstart_time_s = 1700000000\n"
               "[sensor]\nmodel = HDL-32E\nfield_of_view_deg = 140\nx_m = 1\ny_m = 0.2\nz_m = "
               "1.9\nheading_deg = 10\n"
               "[platform]\nspeed_mps = 8\nsegments = 1.6 0 0.02\n"
               "[object ahead]\nclass = car\nx_m = 16\nspeed_mps = 8\nsegments = 1.6 0 0.02\n"
               "[object parked]\nclass = car\nx_m = 14\ny_m = 5\nheading_deg = 180\n"
               "[object beside]\nclass = van\nx_m = 20\ny_m = -6\nheading_deg = 20\n";
    }

    Tracks tracksWith(const std::string& simulation, const std::string& tracking = "") const
    {
        Outcome run = runApp("vdamf-simulate",
                             path("scene.ini") + " --overwrite" + out("a.rawlog") + simulation);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        run = track(in("a.rawlog") + " --overwrite --tracks " + path("t.csv") + tracking);
        EXPECT_EQ(run.exitCode, 0) << run.output;
        summary_ = run.output;
        Tracks tracks;
        for (const TrackRow& row : readTracks(at("t.csv")))
            if (row.report.status == TrackStatus::Confirmed) tracks[row.time].push_back(row.report);
        return tracks;
    }

    mutable std::string summary_;
};

/// How far the boxes of a drive are from those of the reference, which has one near each of them.
struct Difference
{
    double position = 0.0;  // m, largest
    double heading = 0.0;   // rad, largest, either way round
    int compared = 0;
    int missing = 0;
};

Difference between(const Tracks& reference, const Tracks& tracks)
{
    constexpr double kSame = 1.5;     // m
    constexpr double kSettled = 1.0;  // s
    Difference result;
    const double begin = reference.empty() ? 0.0 : reference.begin()->first;
    for (const auto& [time, expected] : reference)
    {
        if (time < begin + kSettled) continue;
        const auto frame =
            std::find_if(tracks.begin(), tracks.end(),
                         [t = time](const auto& f) { return std::abs(f.first - t) < 1e-4; });
        for (const TrackReport& one : expected)
        {
            const TrackReport* nearest = nullptr;
            double least = kSame;
            for (const TrackReport& other :
                 frame == tracks.end() ? std::vector<TrackReport>{} : frame->second)
            {
                const double apart = std::hypot(one.box.x - other.box.x, one.box.y - other.box.y);
                if (apart > least) continue;
                least = apart;
                result.heading = std::max(result.heading,
                                          std::abs(std::sin(one.box.heading - other.box.heading)));
                nearest = &one;
            }
            ++result.compared;
            if (nearest == nullptr)
                ++result.missing;
            else
                result.position = std::max(result.position, least);
        }
    }
    return result;
}

void expectSame(const Tracks& reference, const Tracks& tracks, double position, double degrees)
{
    const Difference difference = between(reference, tracks);
    EXPECT_GE(difference.compared, 12);
    EXPECT_EQ(difference.missing, 0);
    EXPECT_LE(difference.position, position);
    EXPECT_LE(difference.heading * 180.0 / kPi, degrees);
}

TEST_F(SimulatedClasses, OfScansGiveTheSameTracks)
{
    // The hits of a packet keep times of up to 1.3 ms in a frozen world, in which the vehicle moves
    // 1 cm; those of a cloud have none.
    const Tracks frozen = tracksWith("");
    expectSame(frozen, tracksWith(" --set output.scan_class=point_cloud"), 0.015, 0.2);
    // Range images keep the azimuths that packets round to 0.01 degrees.
    const std::string moving = " --set sensor.instantaneous=false";
    const Tracks deskewed = tracksWith(moving);
    expectSame(deskewed, tracksWith(moving + " --set output.scan_class=rotating_scan"), 0.005,
               0.05);
}

TEST_F(SimulatedClasses, OfLineScansGiveTheSameTracks)
{
    const std::string line =
        " --set sensor.model=LMS-511 --set sensor.field_of_view_deg=0 --set sensor.z_m=0.6 --set "
        "sensor.heading_deg=0 --set "
        "sensor.instantaneous=true";
    const Tracks rays = tracksWith(line);
    expectSame(rays, tracksWith(line + " --set output.scan_class=rotating_scan"), 0.005, 0.05);
}

TEST_F(SimulatedClasses, OfPosesGiveTheSameTracks)
{
    const std::string moving = " --set sensor.instantaneous=false";
    const Tracks reference = tracksWith(moving);
    struct Source
    {
        const char* options;
        const char* name;
        double position;  // m
        double degrees;
    };
    // Positions alone have the course as heading, which is good to a few tenths of a degree in a
    // curve; the rest is exact.
    for (const Source& source :
         {Source{"inspvas", "CObservationGPS (INSPVAS) 'ins'", 0.005, 0.05},
          Source{"gga_imu", "CObservationGPS (GGA) 'gps' with CObservationIMU 'imu'", 0.005, 0.05},
          Source{"gga", "CObservationGPS (GGA) 'gps'", 0.25, 0.5},
          Source{"odometry", "CObservationOdometry 'wheels'", 0.005, 0.05},
          Source{"actions --set output.sensory_frames=true", "CActionCollection", 0.005, 0.05},
          Source{"robot_pose --set output.sensory_frames=true", "CObservationRobotPose 'ins'", 1e-9,
                 1e-9}})
    {
        SCOPED_TRACE(source.name);
        const Tracks tracks = tracksWith(moving + " --set output.pose_source=" + source.options);
        EXPECT_THAT(summary_, HasSubstr(std::string("INS poses          ") + source.name + ", "));
        expectSame(reference, tracks, source.position, source.degrees);
    }
}

TEST_F(SimulatedClasses, ActionsNeedSensoryFrames)
{
    const Outcome run = runApp("vdamf-simulate", path("scene.ini") + out("a.rawlog") +
                                                     " --set output.pose_source=actions");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("need output.sensory_frames = true"));
}

}  // namespace
}  // namespace vdamf
