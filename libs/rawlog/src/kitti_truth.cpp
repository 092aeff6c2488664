// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/kitti_truth.h"

#include <algorithm>
#include <optional>
#include <string>

#include "heading_of.h"

namespace vdamf
{
namespace
{
struct FramePose
{
    Eigen::Isometry3d velodyne;  // in the world
    PlanePose sensor;            // where it is, and which way the vehicle heads
};
using PoseOfFrame = std::vector<std::optional<FramePose>>;

PoseOfFrame posesOf(const KittiDrive& drive, const InsTrajectory& trajectory)
{
    PoseOfFrame poses;
    for (const KittiFile& scan : drive.scans)
    {
        const std::optional<VehiclePose> vehicle = trajectory.at(mrpt::Clock::toDouble(scan.time));
        if (!vehicle)
        {
            poses.emplace_back();
            continue;
        }
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = vehicle->attitude.toRotationMatrix();
        pose.translation() = vehicle->position;
        const Eigen::Isometry3d velodyne = pose * drive.velodyneInVehicle;
        const Eigen::Vector3d at = velodyne.translation();
        poses.push_back(FramePose{
            velodyne, {at.x(), at.y(), headingOf(pose.linear() * Eigen::Vector3d::UnitX())}});
    }
    return poses;
}

TruthRow truthOf(const KittiTracklet& tracklet, const KittiTrackletPose& pose,
                 const FramePose& frame)
{
    const Eigen::Vector3d bottom = frame.velodyne * Eigen::Vector3d(pose.x, pose.y, pose.z);
    const Eigen::Vector3d front =
        frame.velodyne.linear() *
        Eigen::Vector3d(std::cos(pose.heading), std::sin(pose.heading), 0.0);
    TruthRow row;
    row.objectClass = tracklet.objectClass;
    row.box = {bottom.x(), bottom.y(), headingOf(front), tracklet.length, tracklet.width};
    row.z = bottom.z();
    row.height = tracklet.height;
    row.sensor = frame.sensor;
    return row;
}

// Slope of the straight line through the positions around label `i`, along its heading. Labels
// of parked cars scatter by centimetres: the difference of two neighbours would give them
// 0.4 m/s, this gives 0.17 m/s.
double speedAt(const std::vector<KittiLabel>& labels, std::size_t i)
{
    constexpr std::size_t kFramesEachSide = 3;
    const std::size_t first = i - std::min(i, kFramesEachSide);
    const std::size_t last = std::min(i + kFramesEachSide, labels.size() - 1);
    const TruthRow& row = labels[i].truth;
    const auto count = static_cast<double>(last - first + 1);
    double meanTime = 0.0;  // relative to the label's, like all times here
    for (std::size_t j = first; j <= last; ++j) meanTime += labels[j].truth.time - row.time;
    meanTime /= count;
    double squares = 0.0;
    Eigen::Vector2d moments = Eigen::Vector2d::Zero();
    for (std::size_t j = first; j <= last; ++j)
    {
        const double time = labels[j].truth.time - row.time - meanTime;
        squares += time * time;
        moments += time * (labels[j].truth.box.centre() - row.box.centre());
    }
    const Eigen::Vector2d ahead(std::cos(row.box.heading), std::sin(row.box.heading));
    return squares > 0.0 ? moments.dot(ahead) / squares : 0.0;
}

// Labels of one object by rising frame; frames without a pose are left out.
std::vector<KittiLabel> labelsOf(const KittiDrive& drive, const KittiTracklet& tracklet,
                                 const std::string& id, const PoseOfFrame& poses)
{
    std::vector<KittiLabel> labels;
    for (std::size_t i = 0; i < tracklet.poses.size(); ++i)
    {
        const std::size_t frame = tracklet.firstFrame + i;
        if (!poses.at(frame)) continue;
        KittiLabel label = {frame, tracklet.poses[i],
                            truthOf(tracklet, tracklet.poses[i], *poses[frame])};
        label.truth.time = mrpt::Clock::toDouble(drive.scans[frame].time);
        label.truth.objectId = id;
        labels.push_back(label);
    }
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i].truth.speed = speedAt(labels, i);
    return labels;
}
}  // namespace

std::vector<KittiLabel> kittiLabels(const KittiDrive& drive,
                                    const std::vector<KittiTracklet>& tracklets,
                                    const InsTrajectory& trajectory)
{
    const PoseOfFrame poses = posesOf(drive, trajectory);
    std::vector<KittiLabel> all;
    for (std::size_t i = 0; i < tracklets.size(); ++i)
    {
        const auto labels = labelsOf(drive, tracklets[i], std::to_string(i), poses);
        all.insert(all.end(), labels.begin(), labels.end());
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const KittiLabel& a, const KittiLabel& b) { return a.frame < b.frame; });
    return all;
}

int pointsInside(const KittiLabel& label, const PointCloud& scan)
{
    const KittiTrackletPose& pose = label.inVelodyne;
    const TruthRow& truth = label.truth;
    const OrientedBox box = {pose.x, pose.y, pose.heading, truth.box.length, truth.box.width};
    const double reach = 0.5 * std::hypot(box.length, box.width);
    const double c = std::cos(box.heading);
    const double s = std::sin(box.heading);
    int count = 0;
    for (std::size_t i = 0; i < scan.size(); ++i)
    {
        const double x = scan.x[i] - box.x;
        const double y = scan.y[i] - box.y;
        const double z = scan.z[i] - pose.z;
        if (std::abs(x) > reach || std::abs(y) > reach || z < 0.0 || z > truth.height) continue;
        const bool inside = std::abs(c * x + s * y) <= 0.5 * box.length &&
                            std::abs(c * y - s * x) <= 0.5 * box.width;
        count += inside ? 1 : 0;
    }
    return count;
}

}  // namespace vdamf
