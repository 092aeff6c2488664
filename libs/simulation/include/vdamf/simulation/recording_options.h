// SPDX-License-Identifier: BSD-3-Clause
// In which classes a simulated drive is recorded.
#pragma once

#include <utility>
#include <vector>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class ScanClass
{
    Native,       ///< packets of spinning sensors, rays of line scanners
    PointCloud,   ///< coordinates and intensities, no times
    RotatingScan  ///< a range image
};

template <>
struct EnumNames<ScanClass>
{
    static std::vector<std::pair<ScanClass, const char*>> names()
    {
        return {{ScanClass::Native, "native"},
                {ScanClass::PointCloud, "point_cloud"},
                {ScanClass::RotatingScan, "rotating_scan"}};
    }
};

enum class PoseSource
{
    RobotPose,
    Inspvas,   ///< GPS with attitude
    Gga,       ///< GPS positions alone
    GgaImu,    ///< GPS positions, attitude of an IMU
    Odometry,  ///< of the wheels: planar
    Actions    ///< planar steps, chained
};

template <>
struct EnumNames<PoseSource>
{
    static std::vector<std::pair<PoseSource, const char*>> names()
    {
        return {{PoseSource::RobotPose, "robot_pose"},
                {PoseSource::Inspvas, "inspvas"},
                {PoseSource::Gga, "gga"},
                {PoseSource::GgaImu, "gga_imu"},
                {PoseSource::Odometry, "odometry"},
                {PoseSource::Actions, "actions"}};
    }
};

/// Section [output].
struct RecordingOptions
{
    ScanClass scanClass = ScanClass::Native;
    PoseSource poseSource = PoseSource::RobotPose;
    bool sensoryFrames = false;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.scanClass, "scan_class", "observations that hold the scans");
        field(self.poseSource, "pose_source", "observations that hold the poses");
        field(self.sensoryFrames, "sensory_frames",
              "pairs of actions and sensory frames, not single observations");
    }
};

}  // namespace vdamf
