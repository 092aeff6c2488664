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
    const auto onGround = scene.terrain.firstHit(ray, 1e3);
    double nearest = onGround ? onGround->range : 1e9;
    for (const SceneObject& object : scene.objects)
    {
        const GroundPose pose = objectPoseAt(scene, object, time);
        const Eigen::Matrix3d toBody = pose.attitude().transpose();
        const Ray inBody{toBody * (ray.origin - pose.position), toBody * ray.direction};
        const auto hit = firstHit(object.body, inBody, random);
        if (hit) nearest = std::min(nearest, hit->range);
    }
    return nearest < 100.0 ? nearest : 0.0;
}

Ray rayOf(const Scene& scene, const LadarMount& mount, const LadarFiring& firing, std::size_t laser)
{
    const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
    const double e = mount.ladar.elevations[laser];
    const double a =
        firing.azimuth + sweep.azimuthStep * mount.ladar.laserDelays[laser] / sweep.period;
    const Eigen::Vector3d inSensor(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a),
                                   std::sin(e));
    const GroundPose platform = platformPoseAt(scene, firing.time);
    return {platform.position + platform.attitude() * mount.position,
            platform.attitude() * (attitudeOf(mount.heading, mount.pitch, mount.roll) * inSensor)};
}

Scene crowdedScene()
{
    Scene scene;
    scene.platform = Trajectory({2.0, -1.0, 0.3, 12.0, 0.0}, {{5.0, 0.0, 0.05, {}}});
    scene.objects = {objectAt(ObjectClass::Wall, {20.0, 3.0, 1.9, 0, 0}, {25.0, 0.3, 2.0}),
                     objectAt(ObjectClass::Car, {2.0, -6.0, 1.0, 0, 0}, {4.5, 1.8, 1.5}, 9.0),
                     objectAt(ObjectClass::Truck, {-9.0, 5.0, 2.0, 0, 0}, {9.0, 2.5, 3.3}, -7.0),
                     objectAt(ObjectClass::Pole, {1.0, 9.0, 0.0, 0, 0}, {0.1, 0.1, 6.0}),
                     objectAt(ObjectClass::Wall, {-5.0, -20.0, 0.1, 0, 0}, {40.0, 0.3, 9.0})};
    return scene;
}

void expectNothingLeftOut(const Scene& scene, const LadarMount& mount)
{
    for (const LadarFiring& firing : cast(scene, mount, 0.7))
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const Ray ray = rayOf(scene, mount, firing, laser);
            const double expected = nearestOfAll(scene, ray, firing.time);
            // A ray along an edge may hit or miss by rounding; none does in these scenes.
            ASSERT_NEAR(firing.returns[laser].range, expected < 1.0 ? 0.0 : expected, 1e-6)
                << "azimuth " << firing.azimuth << ", laser " << laser;
        }
    }
}

TEST(Culling, ChangesNothing)
{
    LadarMount mount = idealMount();
    mount.heading = -0.6;
    mount.instantaneous = false;
    expectNothingLeftOut(crowdedScene(), mount);
}

TEST(Culling, ChangesNothingOnHillsWithATiltedSensor)
{
    Scene scene = crowdedScene();
    TerrainOptions hills;
    hills.slope = 15.0;
    hills.slopeDirection = 2.0;
    hills.bumpAmplitude = 0.8;
    hills.kerbHeight = 0.1;
    scene.terrain = Terrain(hills);
    LadarMount mount = idealMount();
    mount.heading = 0.9;
    mount.pitch = 0.3;
    mount.roll = -0.4;
    mount.instantaneous = false;
    expectNothingLeftOut(scene, mount);
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
