// SPDX-License-Identifier: BSD-3-Clause
// The pose of the vehicle at any time, from INS observations.
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/rawlog/vehicle_movement.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class InsSource
{
    Auto,       ///< the first of the next four that has a pose for the first scan
    RobotPose,  ///< CObservationRobotPose
    Gps,        ///< CObservationGPS: INSPVAS, else position with a heading of GpsHeading
    Odometry,   ///< CObservationOdometry
    Actions,    ///< movements in CActionCollection
    Standing    ///< the vehicle stands still at the world's origin
};

template <>
struct EnumNames<InsSource>
{
    static std::vector<std::pair<InsSource, const char*>> names()
    {
        return {{InsSource::Auto, "auto"},       {InsSource::RobotPose, "robot_pose"},
                {InsSource::Gps, "gps"},         {InsSource::Odometry, "odometry"},
                {InsSource::Actions, "actions"}, {InsSource::Standing, "standing"}};
    }
};

/// Where the heading is from, for GPS positions without attitude.
enum class GpsHeading
{
    Auto,    ///< CObservationIMU where one says its yaw, else the course
    Course,  ///< the way that the positions go
    Imu
};

template <>
struct EnumNames<GpsHeading>
{
    static std::vector<std::pair<GpsHeading, const char*>> names()
    {
        return {
            {GpsHeading::Auto, "auto"}, {GpsHeading::Course, "course"}, {GpsHeading::Imu, "imu"}};
    }
};

struct InsOptions
{
    InsSource source = InsSource::Auto;
    std::string label;               ///< sensorLabel of the pose observations; empty: the first met
    double maxGap = 0.5;             ///< s
    double maxExtrapolation = 0.15;  ///< s
    double minCourseDistance = 0.5;  ///< m
    GpsHeading gpsHeading = GpsHeading::Auto;
    std::string imuLabel;
    double imuYawOffset = 0.0;  ///< rad

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.source, "source",
              "observations that give the pose of the vehicle; auto: the first of robot_pose, gps, "
              "odometry, actions that is there at the first scan; standing: it does not move");
        field(self.label, "label",
              "sensorLabel of these observations; empty: that of the first one");
        field(self.maxGap, "max_gap_s", 0.01, 10.0,
              "longest time between two poses that is bridged");
        field(self.maxExtrapolation, "max_extrapolation_s", 0.0, 1.0,
              "longest time before the first or after the last pose");
        field(self.minCourseDistance, "min_course_distance_m", 0.05, 10.0,
              "distance driven from which a course is taken as heading (GPS without attitude)");
        field(
            self.gpsHeading, "gps_heading",
            "heading of GPS without attitude; auto: of an IMU that tells its yaw, else the course");
        field(self.imuLabel, "imu_label",
              "sensorLabel of the IMU; empty: that of the first one with a yaw");
        field(self.imuYawOffset, "imu_yaw_offset_deg", -360.0, 360.0,
              "added to the yaw of the IMU to make it 0 to the east, counter-clockwise");
    }
};

/// Pose of the vehicle in the world: x east, y north, z up, origin at the first INS pose.
struct VehiclePose
{
    double time = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
};

/// What became of the pose samples of the source.
struct InsReport
{
    std::uint64_t taken = 0;
    std::uint64_t outOfOrder = 0;  ///< of these: sorted in before later ones
    std::uint64_t duplicates = 0;  ///< dropped: there was one of the same time
    std::uint64_t impossible = 0;  ///< dropped: without time, or with numbers that cannot be
    std::uint64_t timeJumps = 0;   ///< times that the clock went back by more than a second
    std::uint64_t gaps = 0;        ///< times without samples that are too long to bridge
    double longestGap = 0.0;       ///< s
    double firstGapAt = 0.0;       ///< begin of the first one, s (UNIX)
    /// Heading of the IMU less the course, mean over the way driven, rad; nothing if not compared.
    std::optional<double> imuLessCourse;
    std::vector<std::string> labels;  ///< of all poses from a source asked for, the first eight
};

/// The vehicle's path from its INS: cubic Hermite interpolation for the position (from the
/// positions before and after the interval, across a gap from as far as half of its length away),
/// spherical for the attitude. Memory is bounded by forgetBefore().
///
/// GPS positions without attitude take the course as heading: between the positions driven, at
/// least minCourseDistance away, before and after; kept at standstill. So they hold for a vehicle
/// that drives forwards, and roll and pitch are zero. With an IMU that tells its yaw, heading (and
/// roll and pitch, where it tells them) are the IMU's.
///
/// Movements of actions are chained from the world's origin on; so are errors.
class InsTrajectory
{
public:
    explicit InsTrajectory(InsOptions options);
    ~InsTrajectory();
    InsTrajectory(InsTrajectory&&) noexcept;
    InsTrajectory& operator=(InsTrajectory&&) noexcept;

    /// Takes pose samples from an observation or from those in a sensory frame; ignores all other
    /// objects. Samples without time or with impossible numbers and duplicate times are dropped,
    /// samples out of order are sorted in. Never throws on what is in an observation.
    void insert(const mrpt::serialization::CSerializable& object);
    void insert(const VehicleMovement& movement);

    /// Pose at a time; nothing before the first sample, after the last one or inside a gap (save
    /// the allowed extrapolation at either side, which takes the speed over half as long before),
    /// and nothing while the heading is unknown. The first call fixes the source.
    std::optional<VehiclePose> at(double time) const;

    /// True when a sample at or after `time` has been inserted, so that waiting brings nothing.
    bool covers(double time) const;

    void forgetBefore(double time);

    /// What gives the poses, for the report: "CObservationRobotPose 'ins'"; empty if none yet.
    std::string sourceName() const;
    /// World origin: the first pose as the source gives it (m; or latitude, longitude in deg and
    /// height in m for GPS), as text for the annotation; empty if none yet.
    std::string originText() const;
    std::size_t samplesTaken() const;
    std::size_t samplesDropped() const;
    InsReport report() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
