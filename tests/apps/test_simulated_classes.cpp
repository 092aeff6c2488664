// SPDX-License-Identifier: BSD-3-Clause
// One scene written through every class of scans and every source of poses that can carry it: the
// tracks must agree within what the class can tell.
#include "apps/simulated_classes.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

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
