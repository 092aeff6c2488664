// SPDX-License-Identifier: BSD-3-Clause
// Real scans with labels, and the same frames simulated: vehicles of the labelled sizes stand at
// the labelled poses on flat ground.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/rawlog/kitti_drive.h"
#include "vdamf/rawlog/kitti_tracklets.h"
#include "vdamf/simulation/paint.h"
#include "vdamf/simulation/ray_caster.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
constexpr double kKittiMountHeight = 1.73;  ///< m

/// A label in one frame, velodyne frame.
struct KittiBox
{
    std::size_t tracklet = 0;
    std::string objectClass;
    OrientedBox box;
    double bottom = 0.0;  ///< z, m
    double height = 0.0;  ///< m
};

inline std::vector<KittiBox> boxesOf(const std::vector<KittiTracklet>& tracklets, std::size_t frame)
{
    std::vector<KittiBox> boxes;
    for (std::size_t i = 0; i < tracklets.size(); ++i)
    {
        const KittiTracklet& tracklet = tracklets[i];
        if (frame < tracklet.firstFrame) continue;
        const std::size_t index = frame - tracklet.firstFrame;
        if (index >= tracklet.poses.size()) continue;
        const KittiTrackletPose& pose = tracklet.poses[index];
        const OrientedBox box{pose.x, pose.y, pose.heading, tracklet.length, tracklet.width};
        boxes.push_back({i, tracklet.objectClass, box, pose.z, tracklet.height});
    }
    return boxes;
}

/// Points inside a box, from a height above its bottom on.
inline int pointsInside(const KittiBox& label, const PointCloud& scan, double above)
{
    int count = 0;
    for (std::size_t i = 0; i < scan.size(); ++i)
    {
        const double z = scan.z[i] - label.bottom;
        if (z < above || z > label.height) continue;
        const Eigen::Vector2d p = toBoxFrame(label.box, {scan.x[i], scan.y[i]});
        const bool inside =
            std::abs(p.x()) <= 0.5 * label.box.length && std::abs(p.y()) <= 0.5 * label.box.width;
        count += inside ? 1 : 0;
    }
    return count;
}

/// Points well in front of a box, between the sensor and its upper part.
inline int pointsInFront(const KittiBox& label, const PointCloud& scan)
{
    double nearest = std::numeric_limits<double>::max();
    double low = 0.0;
    double high = 0.0;
    const double middle = std::atan2(label.box.y, label.box.x);
    for (const Eigen::Vector2d& corner : corners(label.box))
    {
        nearest = std::min(nearest, corner.norm());
        const double bearing = wrapAngle(std::atan2(corner.y(), corner.x()) - middle);
        low = std::min(low, bearing);
        high = std::max(high, bearing);
    }
    int count = 0;
    for (std::size_t i = 0; i < scan.size(); ++i)
    {
        const Eigen::Vector2d p(scan.x[i], scan.y[i]);
        const double range = p.norm();
        const double bearing = wrapAngle(std::atan2(p.y(), p.x()) - middle);
        if (range > nearest - 0.7 || range < 3.0 || bearing < low || bearing > high) continue;
        // Where the ray arrives at the box's distance.
        const double z = scan.z[i] * label.box.centre().norm() / range;
        count += z > label.bottom + 0.3 && z < label.bottom + label.height ? 1 : 0;
    }
    return count;
}

inline ObjectClass simulatedClass(const KittiBox& label)
{
    if (label.objectClass == "Van") return ObjectClass::Van;
    if (label.objectClass == "Truck") return ObjectClass::Truck;
    if (label.objectClass == "Tram") return ObjectClass::Tram;
    if (label.objectClass == "Pedestrian") return ObjectClass::Pedestrian;
    if (label.objectClass == "Cyclist") return ObjectClass::Bicycle;
    // Labels do not tell cars by their shape: estates and hatchbacks are the higher ones for
    // their length.
    return label.height > 0.36 * label.box.length ? ObjectClass::Hatchback : ObjectClass::Car;
}

/// Objects in the order of the boxes, of random brightness: labels do not tell it.
inline Scene sceneOf(const std::vector<KittiBox>& boxes, RandomStream& random)
{
    Scene scene;
    for (const KittiBox& label : boxes)
    {
        SceneObject object;
        object.objectClass = simulatedClass(label);
        object.size = {label.box.length, label.box.width, label.height};
        const BodySize least = leastSizeOf(object.objectClass);
        object.size.length = std::max(object.size.length, least.length);
        object.size.width = std::max(object.size.width, least.width);
        object.size.height = std::max(object.size.height, least.height);
        object.body = makeBody(object.objectClass, object.size);
        object.trajectory = Trajectory(startOf(label.box, 0.0, 0.0), {});
        object.paint = paintReflectivity(random.uniform());
        scene.objects.push_back(std::move(object));
    }
    return scene;
}

/// KITTI's sensor, with the losses that scenario files have without saying so. It turns a little
/// slower than ten times a second.
inline LadarMount kittiMount()
{
    LadarMount mount;
    mount.ladar = ladarOf(LadarModel::HDL64E);
    mount.halfLossStrength = mount.ladar.halfLossStrength;
    mount.rate = 9.66;
    mount.position = {0.0, 0.0, kKittiMountHeight};
    mount.fieldOfView = 2.0;  // labels cover the camera's view
    mount.instantaneous = true;
    return mount;
}

/// Returns of a scan as points in the sensor's frame.
inline PointCloud cloudOf(const std::vector<LadarFiring>& scan, const LadarMount& mount)
{
    const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
    PointCloud cloud;
    for (const LadarFiring& firing : scan)
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const double range = firing.returns[laser].range;
            if (range == 0.0) continue;
            const double e = mount.ladar.elevations[laser];
            const double a =
                firing.azimuth + mount.ladar.laserDelays[laser] / sweep.period * sweep.azimuthStep;
            cloud.x.push_back(static_cast<float>(range * std::cos(e) * std::cos(a)));
            cloud.y.push_back(static_cast<float>(-range * std::cos(e) * std::sin(a)));
            cloud.z.push_back(static_cast<float>(range * std::sin(e)));
            cloud.intensity.push_back(static_cast<float>(firing.returns[laser].intensity));
        }
    }
    return cloud;
}

}  // namespace vdamf
