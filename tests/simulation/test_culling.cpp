// SPDX-License-Identifier: BSD-3-Clause
// The ray caster against all objects for every ray: leaving objects out changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/small_scenes.h"

namespace vdamf
{
namespace
{
/// Range of the first surface of any object or the ground, without any culling; 0 for none.
double nearestOfAll(const Scene& scene, const Ray& ray, double time)
{
    RandomStream random(1, 0);
    double nearest = ray.direction.z() < 0.0 ? -ray.origin.z() / ray.direction.z() : 1e9;
    for (const SceneObject& object : scene.objects)
    {
        const OrientedBox box = boxAt(object, time);
        const Eigen::Vector2d origin = toBoxFrame(box, ray.origin.head<2>());
        const Eigen::Vector2d direction = rotation(-box.heading) * ray.direction.head<2>();
        const Ray inBody{{origin.x(), origin.y(), ray.origin.z()},
                         {direction.x(), direction.y(), ray.direction.z()}};
        const auto hit = firstHit(object.body, inBody, random);
        if (hit) nearest = std::min(nearest, hit->range);
    }
    return nearest < 100.0 ? nearest : 0.0;
}

TEST(Culling, ChangesNothing)
{
    Scene scene;
    scene.platform = Trajectory({2.0, -1.0, 0.3, 12.0, 0.0}, {{5.0, 0.0, 0.05}});
    scene.objects = {objectAt(ObjectClass::Wall, {20.0, 3.0, 1.9, 0, 0}, {25.0, 0.3, 2.0}),
                     objectAt(ObjectClass::Car, {2.0, -6.0, 1.0, 0, 0}, {4.5, 1.8, 1.5}, 9.0),
                     objectAt(ObjectClass::Truck, {-9.0, 5.0, 2.0, 0, 0}, {9.0, 2.5, 3.3}, -7.0),
                     objectAt(ObjectClass::Pole, {1.0, 9.0, 0.0, 0, 0}, {0.1, 0.1, 6.0}),
                     objectAt(ObjectClass::Wall, {-5.0, -20.0, 0.1, 0, 0}, {40.0, 0.3, 9.0})};
    LadarMount mount = idealMount();
    mount.heading = -0.6;
    mount.instantaneous = false;
    const double start = 0.7;
    const std::vector<LadarFiring> revolution = cast(scene, mount, start);
    const double step = 2.0 * kPi / static_cast<double>(revolution.size());
    for (const LadarFiring& firing : revolution)
    {
        const MotionState platform = scene.platform.at(firing.time);
        const Eigen::Vector2d place = Eigen::Vector2d(platform.x, platform.y) +
                                      rotation(platform.heading) * mount.position.head<2>();
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const double e = mount.ladar.elevations[laser];
            const double delay = mount.ladar.laserDelays[laser] / mount.ladar.firingPeriod;
            const double a = platform.heading + mount.heading - firing.azimuth - step * delay;
            const Ray ray{{place.x(), place.y(), mount.position.z()},
                          {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)}};
            const double expected = nearestOfAll(scene, ray, firing.time);
            // A ray along an edge may hit or miss by rounding; none does in this scene.
            ASSERT_NEAR(firing.returns[laser].range, expected < 1.0 ? 0.0 : expected, 1e-6)
                << "azimuth " << firing.azimuth << ", laser " << laser;
        }
    }
}

TEST(Culling, KeepsWhatOnlyTheLaterLasersOfAFiringMeet)
{
    // The wall reaches from bearing 0 to the right, at a right angle to the sight line, so that
    // its end is also the outermost point of its bounding circle.
    Scene scene;
    scene.objects = {
        objectAt(ObjectClass::Wall, {10.0, -10.0, 0.5 * kPi, 0, 0}, {20.0, 0.01, 8.0})};
    LadarMount mount = idealMount();
    mount.position = {0.0, 0.0, 2.0};
    const double step = 2.0 * kPi / mount.ladar.firingsPerRevolution(mount.rate);
    mount.heading = 0.4 * step;
    const LadarFiring firing = cast(scene, mount).front();
    for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
    {
        if (mount.ladar.elevations[laser] < -0.17) continue;  // meets the ground before the wall
        const bool isBeyondTheEnd = mount.ladar.laserDelays[laser] > 0.4 * mount.ladar.firingPeriod;
        EXPECT_EQ(firing.returns[laser].object == 0, isBeyondTheEnd) << laser;
    }
}
}  // namespace
}  // namespace vdamf
