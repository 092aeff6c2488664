// SPDX-License-Identifier: BSD-3-Clause
// The pose of the vehicle at any time, from INS observations.
#pragma once

#include <mrpt/serialization/CSerializable.h>

#include <Eigen/Geometry>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class InsSource
{
    Auto,       ///< the first of robot_pose, gps that has a pose for the first scan
    RobotPose,  ///< CObservationRobotPose
    Gps         ///< CObservationGPS: INSPVAS, else position with the course as heading
};

template <>
struct EnumNames<InsSource>
{
    static std::vector<std::pair<InsSource, const char*>> names()
    {
        return {{InsSource::Auto, "auto"}, {InsSource::RobotPose, "robot_pose"}, {InsSource::Gps, "gps"}};
    }
};

struct InsOptions
{
    InsSource source = InsSource::Auto;
    std::string label;              ///< sensorLabel of the pose observations; empty: any
    double maxGap = 0.5;            ///< s
    double maxExtrapolation = 0.15;  ///< s
    double minCourseDistance = 0.5;  ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.source, "source", "observations that give the pose of the vehicle");
        field(self.label, "label", "sensorLabel of these observations; empty: any");
        field(self.maxGap, "max_gap_s", 0.01, 10.0, "longest time between two poses that is bridged");
        field(self.maxExtrapolation, "max_extrapolation_s", 0.0, 1.0,
              "longest time before the first or after the last pose");
        field(self.minCourseDistance, "min_course_distance_m", 0.05, 10.0,
              "distance driven from which a course is taken as heading (GPS without attitude)");
    }
};

/// Pose of the vehicle in the world: x east, y north, z up, origin at the first INS pose.
struct VehiclePose
{
    double time = 0.0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
    Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
};

/// Sorted pose samples with interpolation (position: linear in the interval, or cubic Hermite
/// where that is better; attitude: slerp). Memory is bounded by forgetBefore().
class InsTrajectory
{
public:
    explicit InsTrajectory(InsOptions options);

    /// Takes pose samples from an observation; ignores all other objects. Duplicate times are
    /// dropped, samples out of order are sorted in.
    void insert(const mrpt::serialization::CSerializable& object);

    /// Pose at a time; nothing before the first sample, after the last one (beyond the allowed
    /// extrapolation) or inside a gap.
    std::optional<VehiclePose> at(double time) const;

    /// True when a sample at or after `time` has been inserted, so that waiting brings nothing.
    bool covers(double time) const;

    void forgetBefore(double time);

    /// What gives the poses, for the report: "CObservationRobotPose 'ins'"; empty if none yet.
    std::string sourceName() const;
    /// World origin: the first pose as the source gives it (m; or latitude, longitude in deg and
    /// height in m for GPS), as text for the annotation.
    std::string originText() const;
    std::size_t samplesTaken() const;
    std::size_t samplesDropped() const;

private:
    struct Source
    {
        InsSource kind = InsSource::Auto;
        std::deque<VehiclePose> samples;
    };
    InsOptions options_;
    // Implementation may replace the private part.
};

}  // namespace vdamf
