// SPDX-License-Identifier: BSD-3-Clause
// Objects where they are at one instant.
#include "placed_objects.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
std::vector<PlacedObject> placedAt(const Scene& scene, double time)
{
    std::vector<PlacedObject> placed;
    placed.reserve(scene.objects.size());
    for (const SceneObject& object : scene.objects)
    {
        const OrientedBox box = boxAt(object, time);
        placed.push_back(
            {&object.body, box.centre(), std::cos(box.heading), std::sin(box.heading)});
    }
    return placed;
}

Fan fanOf(const std::vector<PlacedObject>& objects, const Eigen::Vector2d& sensor, double heading,
          double width)
{
    const Eigen::Vector2d axis(std::cos(heading), std::sin(heading));
    Fan fan;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        const Eigen::Vector2d to = objects[i].centre - sensor;
        const double along = axis.dot(to);
        const double radius = objects[i].body->radius;
        const double aside = std::abs(axis.x() * to.y() - axis.y() * to.x());
        // The wedge's edge is away from its axis by at most its angle times the distance.
        const bool isInside = along > -radius && aside <= radius + width * (to.norm() + radius);
        if (isInside) fan.objects.push_back(static_cast<int>(i));
    }
    return fan;
}

bool mayHit(const PlacedObject& object, const Ray& ray)
{
    const double horizontal = ray.direction.head<2>().norm();
    if (horizontal < 1e-6) return true;
    const double distance = (object.centre - ray.origin.head<2>()).norm();
    const double slope = ray.direction.z() / horizontal;
    const double atNear = ray.origin.z() + slope * std::max(0.0, distance - object.body->radius);
    const double atFar = ray.origin.z() + slope * (distance + object.body->radius);
    return std::min(atNear, atFar) <= object.body->height && std::max(atNear, atFar) >= 0.0;
}

Ray inBodyFrame(const PlacedObject& object, const Ray& ray)
{
    const double c = object.cosHeading;
    const double s = object.sinHeading;
    const double x = ray.origin.x() - object.centre.x();
    const double y = ray.origin.y() - object.centre.y();
    const Eigen::Vector3d& d = ray.direction;
    return {{c * x + s * y, c * y - s * x, ray.origin.z()},
            {c * d.x() + s * d.y(), c * d.y() - s * d.x(), d.z()}};
}

}  // namespace vdamf
