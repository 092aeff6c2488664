// SPDX-License-Identifier: BSD-3-Clause
// Objects where they are at one instant.
#include "placed_objects.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
PlacedObject placed(const Scene& scene, const SceneObject& object, double time)
{
    const GroundPose pose = objectPoseAt(scene, object, time);
    PlacedObject result{existsAt(object, time) ? &object.body : nullptr,
                        pose.position,
                        Eigen::Matrix3d::Identity(),
                        object.body.radius,
                        pose.position.z(),
                        pose.position.z() + object.body.height};
    if (pose.pitch == 0.0 && pose.roll == 0.0)
    {
        result.toBody.topLeftCorner<2, 2>() = rotation(-pose.heading);
        return result;
    }
    result.toBody = pose.attitude().transpose();
    const double sinTilt = std::sqrt(std::max(0.0, 1.0 - std::pow(result.toBody(2, 2), 2)));
    result.radius += object.body.height * sinTilt;
    result.bottom -= object.body.radius * sinTilt;
    result.top += object.body.radius * sinTilt;
    return result;
}
}  // namespace

std::vector<PlacedObject> placedAt(const Scene& scene, double time)
{
    std::vector<PlacedObject> objects;
    objects.reserve(scene.objects.size());
    for (const SceneObject& object : scene.objects) objects.push_back(placed(scene, object, time));
    return objects;
}

Fan fanOf(const std::vector<PlacedObject>& objects, const Eigen::Vector2d& sensor, double heading,
          double width)
{
    constexpr double kWide = 1.0;  // rad; the bound below holds for thin wedges only
    const Eigen::Vector2d axis(std::cos(heading), std::sin(heading));
    Fan fan;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        if (objects[i].body == nullptr) continue;
        const Eigen::Vector2d to = objects[i].origin.head<2>() - sensor;
        const double along = axis.dot(to);
        const double radius = objects[i].radius;
        const double aside = std::abs(axis.x() * to.y() - axis.y() * to.x());
        // The wedge's edge is away from its axis by at most its angle times the distance.
        const bool isInside = along > -radius && aside <= radius + width * (to.norm() + radius);
        if (isInside || width > kWide) fan.objects.push_back(static_cast<int>(i));
    }
    return fan;
}

bool mayHit(const PlacedObject& object, const Ray& ray)
{
    const double horizontal = ray.direction.head<2>().norm();
    if (horizontal < 1e-6) return true;
    const double distance = (object.origin.head<2>() - ray.origin.head<2>()).norm();
    const double slope = ray.direction.z() / horizontal;
    const double atNear = ray.origin.z() + slope * std::max(0.0, distance - object.radius);
    const double atFar = ray.origin.z() + slope * (distance + object.radius);
    return std::min(atNear, atFar) <= object.top && std::max(atNear, atFar) >= object.bottom;
}

Ray inBodyFrame(const PlacedObject& object, const Ray& ray)
{
    return {object.toBody * (ray.origin - object.origin), object.toBody * ray.direction};
}

}  // namespace vdamf
