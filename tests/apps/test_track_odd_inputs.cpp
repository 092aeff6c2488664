// SPDX-License-Identifier: BSD-3-Clause
// What a newcomer may give to vdamf-track: files of other kinds, scans without hits, times that
// stand still. Each is told what it is and what to do.
#include <gmock/gmock.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <limits>

#include "apps/track_fixture.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class OddInputs : public TrackProgram
{
protected:
    static std::string pose(double time, double x)
    {
        mrpt::obs::CObservationRobotPose pose;
        pose.sensorLabel = "ins";
        pose.timestamp = mrpt::Clock::fromDouble(1.7e9 + time);
        pose.pose.mean = mrpt::poses::CPose3D(x, 0.0, 0.0, 0.0, 0.0, 0.0);
        return serialized(pose);
    }

    /// Of a rear 10 m ahead, or of one point many times.
    static std::string scan(double time, std::optional<mrpt::math::TPoint3Df> same = {})
    {
        mrpt::obs::CObservationPointCloud scan;
        scan.sensorLabel = "lidar";
        scan.timestamp = mrpt::Clock::fromDouble(1.7e9 + time);
        auto points = mrpt::maps::CSimplePointsMap::Create();
        for (int i = 0; i < 200; ++i)
        {
            const auto column = static_cast<float>(i % 40);
            const auto row = static_cast<float>(i / 40);
            if (same)
                points->insertPointFast(same->x, same->y, same->z);
            else
                points->insertPointFast(10.0F, 0.04F * column - 0.8F, 0.5F + 0.2F * row);
        }
        scan.pointcloud = points;
        return serialized(scan);
    }

    /// Scans and poses, `step` seconds apart.
    static std::string drive(int scans, double step, std::optional<mrpt::math::TPoint3Df> same = {})
    {
        std::string bytes;
        for (int i = 0; i < scans; ++i) bytes += pose(i * step, 0.5 * i) + scan(i * step, same);
        return bytes;
    }

    Outcome trackOf(const std::string& bytes) const
    {
        make("in.rawlog", bytes);
        return track(in("in.rawlog") + " --overwrite --tracks " + path("t.csv"));
    }
};

TEST_F(OddInputs, FilesOfOtherKindsAreToldWhatReadsThem)
{
    struct Kind
    {
        std::string bytes;
        const char* advice;
    };
    for (const Kind& kind :
         {Kind{"\xd4\xc3\xb2\xa1 and more", "vdamf-import velodyne-pcap"},
          Kind{"\x0a\x0d\x0d\x0a and more", "vdamf-import velodyne-pcap"},
          Kind{"# .PCD v0.7\nVERSION 0.7\n", "vdamf-import clouds"},
          Kind{"ply\nformat ascii 1.0\n", "vdamf-import clouds"}, Kind{"#ROSBAG V2.0\n", "ROS bag"},
          Kind{"SQLite format 3", "ROS bag"}, Kind{"just text\n", "expected MRPT observations"},
          Kind{"", "the file is empty"}, Kind{"\x1f\x8b\x08", "gz stream ends early"}})
    {
        const Outcome run = trackOf(kind.bytes);
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_THAT(run.output,
                    AllOf(HasSubstr("in.rawlog: not a rawlog"), HasSubstr(kind.advice)));
    }
}

TEST_F(OddInputs, TheNameOfAFileSaysNothing)
{
    make("drive.txt", drive(5, 0.1));
    EXPECT_EQ(track(in("drive.txt") + " --tracks " + path("t.csv")).exitCode, 0);
}

TEST_F(OddInputs, ScansWithoutHitsAreCounted)
{
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kFar = std::numeric_limits<float>::infinity();
    for (const mrpt::math::TPoint3Df& point :
         {mrpt::math::TPoint3Df(kNone, 0.0F, 0.0F), mrpt::math::TPoint3Df(0.0F, kFar, 0.0F),
          mrpt::math::TPoint3Df(0.0F, 0.0F, 0.0F)})
    {
        const Outcome run = trackOf(drive(6, 0.1, point));
        EXPECT_EQ(run.exitCode, 0) << run.output;
        EXPECT_THAT(run.output, AllOf(HasSubstr("6 scans without a hit"),
                                      HasSubstr("frames             6 of 6 scans")));
    }
    EXPECT_THAT(trackOf(drive(6, 0.1)).output, Not(HasSubstr("without a hit")));
}

TEST_F(OddInputs, ASingleScanIsAFrame)
{
    const Outcome run = trackOf(drive(1, 0.1));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             1 of 1 scans"));
}

TEST_F(OddInputs, TimesThatGoBackAreSorted)
{
    const Outcome run = trackOf(drive(9, -0.1));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             9 of 9 scans"));
}

TEST_F(OddInputs, TimesThatStandStillAreTold)
{
    const Outcome run = trackOf(drive(9, 0.0));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("8 scans skipped: at the time of the frame before"));
}

TEST_F(OddInputs, SensorsOfOneLabelAreSuspected)
{
    std::string bytes;
    for (int i = 0; i < 6; ++i) bytes += pose(0.1 * i, 0.0) + scan(0.1 * i) + scan(0.1 * i);
    const Outcome run = trackOf(bytes);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, AllOf(HasSubstr("6 scans skipped"), HasSubstr("label 'lidar'"),
                                  HasSubstr("give each its own")));
}

TEST_F(OddInputs, PosesThatStandTooFarBehindAreTold)
{
    const auto late = [&](double delay)
    {
        std::string bytes;
        const int behind = static_cast<int>(std::lround(10.0 * delay));
        for (int i = 0; i < 40; ++i)
        {
            bytes += scan(0.1 * i);
            if (i >= behind) bytes += pose(0.1 * (i - behind), 0.0);
        }
        for (int i = 40 - behind; i < 40; ++i) bytes += pose(0.1 * i, 0.0);
        return trackOf(bytes);
    };
    EXPECT_THAT(late(0.8).output, HasSubstr("frames             40 of 40 scans"));
    const Outcome run = late(2.0);
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, AllOf(HasSubstr("30 scans skipped: no INS pose at their time"),
                                  HasSubstr("30 of them have one later in the rawlog")));
    std::string behindAll;
    for (int i = 0; i < 40; ++i) behindAll += scan(0.1 * i);
    behindAll += scan(9.0) + scan(9.1) + pose(0.0, 0.0) + pose(0.1, 0.0);
    EXPECT_THAT(trackOf(behindAll).output,
                HasSubstr("but for 3 of them more than a second behind"));
    // One that is nowhere.
    const Outcome gap = trackOf(drive(9, 0.1) + scan(50.0) + pose(99.0, 0.0));
    EXPECT_THAT(gap.output, AllOf(HasSubstr("1 scans skipped: no INS pose at their time"),
                                  Not(HasSubstr("later in the rawlog"))));
}

TEST_F(OddInputs, PosesThatCannotBeAreNone)
{
    for (const double x : {std::numeric_limits<double>::quiet_NaN(), 1e300, 1e9})
    {
        const Outcome run = trackOf(pose(0.0, x) + scan(0.05) + pose(0.1, x));
        EXPECT_EQ(run.exitCode, 1);
        EXPECT_THAT(run.output, HasSubstr("no INS pose at the time of any scan (1 scans; poses: "
                                          "none, 2 impossible ones left out); see"));
    }
    make("in.rawlog", pose(0.0, 1e9) + scan(0.05) + pose(0.1, 1e9));
    EXPECT_THAT(
        track(in("in.rawlog") + " --tracks " + path("t.csv") + " --set ins.source=robot_pose")
            .output,
        HasSubstr("poses: none with source = robot_pose, 2 impossible ones left out); see"));
}

TEST_F(OddInputs, LabelsThatAreThereAreToldWhereNoneFits)
{
    make("in.rawlog", drive(3, 0.1));
    const std::string run = in("in.rawlog") + " --tracks " + path("t.csv");
    EXPECT_THAT(
        track(run + " --set scan.label=nosuch").output,
        HasSubstr("no scans labelled 'nosuch' ([scan] label) among its 6 objects, but those "
                  "labelled 'lidar'"));
    EXPECT_THAT(track(run + " --set ins.label=nosuch").output,
                HasSubstr("poses: none labelled 'nosuch' ([ins] label), but those labelled 'ins'"));
    EXPECT_THAT(track(run + " --set ins.label=ins --set ins.source=gps").output,
                HasSubstr("poses: none with source = gps labelled 'ins' ([ins] label)); see"));
}

TEST_F(OddInputs, ClocksThatDifferAreSuspected)
{
    const Outcome run = trackOf(pose(1e6, 0.0) + pose(1e6 + 0.1, 0.0) + scan(0.0) + scan(0.1));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("whether scans and poses have one clock"));
}

TEST_F(OddInputs, ADeviceTakesAllOutputs)
{
    make("in.rawlog", drive(3, 0.1));
    EXPECT_EQ(track(in("in.rawlog") + " -o /dev/null --tracks /dev/null").exitCode, 0);
}

}  // namespace
}  // namespace vdamf
