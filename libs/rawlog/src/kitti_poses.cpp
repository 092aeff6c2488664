// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "vdamf/rawlog/kitti_drive.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kEarthRadius = 6378137.0;  // m

Eigen::Vector3d mercator(const KittiOxts& oxts, double scale)
{
    const double longitude = oxts.longitude * kPi / 180.0;
    const double latitude = oxts.latitude * kPi / 180.0;
    return {scale * kEarthRadius * longitude,
            scale * kEarthRadius * std::log(std::tan(0.25 * kPi + 0.5 * latitude)), oxts.altitude};
}
}  // namespace

std::vector<Eigen::Isometry3d> kittiPoses(const std::vector<KittiOxts>& oxts)
{
    std::vector<Eigen::Isometry3d> poses;
    if (oxts.empty()) return poses;
    const double scale = std::cos(oxts.front().latitude * kPi / 180.0);
    const Eigen::Vector3d origin = mercator(oxts.front(), scale);
    for (const KittiOxts& sample : oxts)
    {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.translation() = mercator(sample, scale) - origin;
        pose.linear() = (Eigen::AngleAxisd(sample.yaw, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(sample.pitch, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(sample.roll, Eigen::Vector3d::UnitX()))
                            .toRotationMatrix();
        poses.push_back(pose);
    }
    return poses;
}

}  // namespace vdamf
