// SPDX-License-Identifier: BSD-3-Clause
#include "scaling/recorded_frames.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

LadarFrame inWorld(PointCloud points, const Eigen::Isometry3d& sensorPose)
{
    LadarFrame frame;
    frame.sensor = sensorPose.translation();
    frame.origin = frame.sensor.array().round();
    const Eigen::Matrix3f turn = sensorPose.linear().cast<float>();
    const Eigen::Vector3f shift = (frame.sensor - frame.origin).cast<float>();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Eigen::Vector3f p =
            turn * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]) + shift;
        points.x[i] = p.x();
        points.y[i] = p.y();
        points.z[i] = p.z();
    }
    frame.points = std::move(points);
    return frame;
}
}  // namespace

std::vector<fs::path> recordedDrives(const fs::path& folder)
{
    std::vector<fs::path> drives;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename() == "velodyne_points")
            drives.push_back(entry.path().parent_path());
    if (drives.empty())
    {
        throw std::runtime_error(folder.string() +
                                 ": no KITTI raw drive (a folder with velodyne_points) in it");
    }
    std::sort(drives.begin(), drives.end());
    return drives;
}

std::vector<LadarFrame> recordedFrames(const fs::path& folder)
{
    const KittiDrive drive = readKittiDrive(folder);
    // One INS sample a scan: close enough in time for a measurement of speed.
    const std::vector<Eigen::Isometry3d> poses = kittiPoses(drive.oxts);
    std::vector<LadarFrame> frames;
    for (std::size_t k = 0; k < std::min(poses.size(), drive.scans.size()); ++k)
    {
        frames.push_back(
            inWorld(readKittiScan(drive.scans[k].path), poses[k] * drive.velodyneInVehicle));
        frames.back().time = mrpt::Clock::toDouble(drive.scans[k].time);
    }
    return frames;
}

}  // namespace vdamf
