// SPDX-License-Identifier: BSD-3-Clause
#include "scan_path.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr float kLongestScan = 1.0F;  // s to either side of the scan's time
constexpr float kStepsPerSecond = 1e4F;
constexpr double kPosesPerSecond = 1e3;

int floorDivided(int a, int b)
{
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Poses beside that at the scan's time, in their order away from it; where the INS has none, the
// one before stands in.
struct Poses
{
    std::vector<VehicleInFrame> values;
    bool complete = true;
};

Poses posesAlong(int count, int direction, const VehiclePose& pose, const InsTrajectory& ins,
                 const Eigen::Vector3d& origin)
{
    Poses poses;
    VehicleInFrame last = vehicleInFrame(pose, origin);
    for (int i = 1; i <= count; ++i)
    {
        const auto there = ins.at(pose.time + direction * i / kPosesPerSecond);
        if (there)
            last = vehicleInFrame(*there, origin);
        else
            poses.complete = false;
        poses.values.push_back(last);
    }
    return poses;
}
}  // namespace

Eigen::Vector3d onGrid(const Eigen::Vector3d& position)
{
    constexpr double kPerMetre = 65536.0;
    return (kPerMetre * position.array()).round() / kPerMetre;
}

VehicleInFrame vehicleInFrame(const VehiclePose& pose, const Eigen::Vector3d& origin)
{
    return {pose.attitude.toRotationMatrix().cast<float>(),
            (onGrid(pose.position) - origin).cast<float>()};
}

bool ScanPath::isPlausible(float time)
{
    return std::abs(time) <= kLongestScan;
}

int ScanPath::stepOf(float time)
{
    constexpr int kOffset = static_cast<int>(kLongestScan * kStepsPerSecond) + 1;
    if (!isPlausible(time)) return 0;
    // Truncation of what is positive rounds, and is one instruction.
    return static_cast<int>(time * kStepsPerSecond + (static_cast<float>(kOffset) + 0.5F)) -
           kOffset;
}

ScanPath::ScanPath(const std::vector<float>& times, const VehiclePose& pose,
                   const InsTrajectory& ins, const Eigen::Vector3d& origin)
{
    int lowest = 0;
    int highest = 0;
    for (const float time : times)
    {
        complete_ = complete_ && isPlausible(time);
        const int step = stepOf(time);
        lowest = std::min(lowest, step);
        highest = std::max(highest, step);
    }
    const int before = -floorDivided(lowest, kStepsPerPose);
    const int after = floorDivided(highest, kStepsPerPose) + 1;
    const Poses past = posesAlong(before, -1, pose, ins, origin);
    const Poses future = posesAlong(highest > 0 ? after : 0, 1, pose, ins, origin);
    complete_ = complete_ && past.complete && future.complete;
    firstStep_ = -before * kStepsPerPose;
    std::vector<VehicleInFrame> poses(past.values.rbegin(), past.values.rend());
    poses.push_back(vehicleInFrame(pose, origin));
    poses.insert(poses.end(), future.values.begin(), future.values.end());
    interpolate(poses);
}

void ScanPath::interpolate(const std::vector<VehicleInFrame>& poses)
{
    for (std::size_t i = 0; i + 1 < poses.size(); ++i)
    {
        for (int step = 0; step < kStepsPerPose; ++step)
        {
            const float share = static_cast<float>(step) / kStepsPerPose;
            const VehicleInFrame& a = poses[i];
            const VehicleInFrame& b = poses[i + 1];
            steps_.push_back({a.rotation + share * (b.rotation - a.rotation),
                              a.translation + share * (b.translation - a.translation)});
        }
    }
    steps_.push_back(poses.back());
}

}  // namespace vdamf
