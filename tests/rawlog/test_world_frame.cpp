// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/world_frame.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kDriveStart = 1.5e9;
constexpr double kDriveSpeed = 20.0;             // m/s
constexpr double kTurning = 30.0 * kPi / 180.0;  // rad/s
const Eigen::Vector3d kPole(30.0, 15.0, 1.0);
const Eigen::Vector3d kSensor(1.0, 0.0, 2.0);

/// Drives a circle.
VehiclePose truePose(double t)
{
    const double radius = kDriveSpeed / kTurning;
    const double heading = kTurning * t;
    VehiclePose pose;
    pose.time = kDriveStart + t;
    pose.position = {radius * std::sin(heading), radius * (1.0 - std::cos(heading)), 0.0};
    pose.attitude = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ());
    return pose;
}

/// Poses at 50 Hz over the times.
InsTrajectory drive(double from, double to, const InsOptions& options = {})
{
    InsTrajectory ins(options);
    for (int i = 0; from + 0.02 * i < to + 1e-6; ++i)
    {
        const VehiclePose pose = truePose(from + 0.02 * i);
        mrpt::obs::CObservationRobotPose observation;
        observation.timestamp = mrpt::Clock::fromDouble(pose.time);
        observation.sensorLabel = "ins";
        observation.pose.mean = mrpt::poses::CPose3D(pose.position.x(), pose.position.y(), 0.0,
                                                     kTurning * (from + 0.02 * i), 0.0, 0.0);
        ins.insert(observation);
    }
    return ins;
}

/// The pole, seen at many times from `begin` to `end` relative to the scan's time `t`.
Scan scanOfPole(double t, double begin, double end)
{
    constexpr int kHits = 500;
    Scan scan;
    scan.time = kDriveStart + t;
    scan.sensorInVehicle = kSensor;
    for (int i = 0; i < kHits; ++i)
    {
        const double since = begin + (end - begin) * i / (kHits - 1);
        const VehiclePose pose = truePose(t + since);
        const Eigen::Vector3f hit =
            (pose.attitude.conjugate() * (kPole - pose.position)).cast<float>();
        scan.points.x.push_back(hit.x());
        scan.points.y.push_back(hit.y());
        scan.points.z.push_back(hit.z());
        scan.points.time.push_back(static_cast<float>(since));
    }
    return scan;
}

double errorAt(const LadarFrame& frame, std::size_t i)
{
    const Eigen::Vector3d hit(frame.points.x[i], frame.points.y[i], frame.points.z[i]);
    return (frame.origin + hit - kPole).norm();
}

double largestError(const LadarFrame& frame)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
        largest = std::max(largest, errorAt(frame, i));
    return largest;
}

/// The world's origin is the first pose inserted: here the one at time 0.
TEST(WorldFrame, EachHitIsPlacedByThePoseAtItsTime)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    for (const double begin : {0.0, -0.05, -0.1})
    {
        const Scan scan = scanOfPole(0.413, begin, begin + 0.1);
        const VehiclePose pose = *ins.at(scan.time);
        const DeskewedFrame deskewed = toLadarFrame(scan, pose, ins);
        EXPECT_TRUE(deskewed.posesCoverScan);
        EXPECT_LT(largestError(deskewed.frame), 2.5e-3) << begin;
        EXPECT_EQ(deskewed.frame.points.time, scan.points.time);
        EXPECT_GT(largestError(toLadarFrame(scan, pose)), 0.9) << begin;
    }
}

TEST(WorldFrame, TimeAndSensorAreThoseOfTheScan)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    const Scan scan = scanOfPole(0.5, 0.0, 0.1);
    const LadarFrame frame = toLadarFrame(scan, *ins.at(scan.time), ins).frame;
    EXPECT_EQ(frame.time, scan.time);
    const VehiclePose pose = truePose(0.5);
    EXPECT_LT((frame.sensor - pose.position - pose.attitude * kSensor).norm(), 1e-3);
}

TEST(WorldFrame, ScansWithoutTimesArePlacedByOnePose)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    Scan scan = scanOfPole(0.5, 0.0, 0.1);
    scan.points.time.clear();
    const DeskewedFrame deskewed = toLadarFrame(scan, *ins.at(scan.time), ins);
    const LadarFrame plain = toLadarFrame(scan, *ins.at(scan.time));
    EXPECT_TRUE(deskewed.posesCoverScan);
    EXPECT_EQ(deskewed.frame.points.x, plain.points.x);
    EXPECT_EQ(deskewed.frame.points.y, plain.points.y);
    EXPECT_TRUE(deskewed.frame.points.time.empty());
}

TEST(WorldFrame, HitsBehindTheLastPoseArePlacedByIt)
{
    InsOptions options;
    options.maxExtrapolation = 0.0;
    const InsTrajectory ins = drive(0.0, 0.5, options);
    const Scan scan = scanOfPole(0.47, 0.0, 0.1);
    const DeskewedFrame deskewed = toLadarFrame(scan, *ins.at(scan.time), ins);
    EXPECT_FALSE(deskewed.posesCoverScan);
    EXPECT_LT(errorAt(deskewed.frame, 140), 2.5e-3) << "28 ms: before the last pose";
    EXPECT_GT(errorAt(deskewed.frame, 499), 0.5);
    const double withoutDeskew = errorAt(toLadarFrame(scan, *ins.at(scan.time)), 499);
    EXPECT_LT(errorAt(deskewed.frame, 499), 0.8 * withoutDeskew);
    // What may be extrapolated is no gap.
    options.maxExtrapolation = 0.15;
    const InsTrajectory longer = drive(0.0, 0.5, options);
    const DeskewedFrame covered = toLadarFrame(scan, *longer.at(scan.time), longer);
    EXPECT_TRUE(covered.posesCoverScan);
    EXPECT_LT(largestError(covered.frame), 0.05);
}

TEST(WorldFrame, ImpossibleTimesCountAsTheScans)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    Scan scan = scanOfPole(0.5, 0.0, 0.0);
    const float wild[] = {1e9F, -1e9F, std::nanf(""), std::numeric_limits<float>::infinity(),
                          -1.1F};
    for (std::size_t i = 0; i < 5; ++i) scan.points.time[i] = wild[i];
    const DeskewedFrame deskewed = toLadarFrame(scan, *ins.at(scan.time), ins);
    EXPECT_FALSE(deskewed.posesCoverScan);
    EXPECT_LT(largestError(deskewed.frame), 1e-3);
    const LadarFrame plain = toLadarFrame(scan, *ins.at(scan.time));
    for (const LadarFrame* frame : {&deskewed.frame, &plain})
        for (const std::size_t i : {0U, 1U, 4U}) EXPECT_EQ(frame->points.time[i], 0.0F) << i;
}

TEST(WorldFrame, MergesTheHitsOfTwoScans)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    Scan first = scanOfPole(0.5, 0.0, 0.1);
    Scan second = scanOfPole(0.55, 0.0, 0.1);
    first.points.intensity.assign(first.points.size(), 0.5F);
    second.points.time.clear();
    second.points.x.resize(1);
    second.points.y.resize(1);
    second.points.z.resize(1);
    const LadarFrame a = toLadarFrame(first, *ins.at(first.time), ins).frame;
    const LadarFrame b = toLadarFrame(second, *ins.at(second.time), ins).frame;
    ASSERT_NE(a.origin, b.origin);
    const LadarFrame both = merged(a, b);
    EXPECT_EQ(both.time, a.time);
    EXPECT_EQ(both.sensor, a.sensor);
    ASSERT_EQ(both.points.size(), 501U);
    EXPECT_LT(largestError(both), 2.5e-3);
    EXPECT_TRUE(both.points.intensity.empty()) << "only one has them";
    ASSERT_EQ(both.points.time.size(), 501U);
    EXPECT_FLOAT_EQ(both.points.time[499], 0.1F);
    EXPECT_NEAR(both.points.time[500], 0.05F, 1e-6F);
}

TEST(WorldFrame, IsPlanarWhereAllItsScansAre)
{
    const InsTrajectory ins = drive(0.0, 1.0);
    Scan line = scanOfPole(0.5, 0.0, 0.0);
    line.planar = true;
    const VehiclePose pose = *ins.at(line.time);
    const LadarFrame planar = toLadarFrame(line, pose, ins).frame;
    EXPECT_TRUE(planar.planar);
    EXPECT_TRUE(toLadarFrame(line, pose).planar);
    EXPECT_TRUE(merged(planar, planar).planar);
    line.planar = false;
    EXPECT_FALSE(merged(planar, toLadarFrame(line, pose)).planar);
}

TEST(WorldFrame, IsMovedIntoAnotherWorld)
{
    LadarFrame frame;
    frame.origin = {1000.0, 500.0, 3.0};
    frame.sensor = {1001.0, 500.0, 5.0};
    frame.points = {{4.0F}, {-2.0F}, {1.0F}, {}, {}};
    const PlaneMotion motion{0.01, {3.0, -20.0}};
    const LadarFrame moved = movedBy(frame, motion);
    const Eigen::Vector2d hit = motion.of(Eigen::Vector2d(1004.0, 498.0));
    EXPECT_EQ(moved.origin, frame.origin);
    EXPECT_NEAR(moved.points.x[0] + moved.origin.x(), hit.x(), 1e-4);
    EXPECT_NEAR(moved.points.y[0] + moved.origin.y(), hit.y(), 1e-4);
    EXPECT_EQ(moved.points.z[0], 1.0F);
    EXPECT_TRUE(moved.sensor.head<2>().isApprox(motion.of(Eigen::Vector2d(1001.0, 500.0)), 1e-12));
    EXPECT_EQ(moved.sensor.z(), 5.0);
}

}  // namespace
}  // namespace vdamf
