// SPDX-License-Identifier: BSD-3-Clause
// Vehicles on slopes, waves and kerbs.
#include "vdamf/simulation/ground_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulation/small_scenes.h"

namespace vdamf
{
namespace
{
Terrain slope(double percent, double direction)
{
    TerrainOptions options;
    options.slope = percent;
    options.slopeDirection = direction;
    return Terrain(options);
}

constexpr Contacts kCar{1.4, 1.3, 0.8};

TEST(GroundPose, UphillTheFrontIsHigherAndAcrossTheLeftOrRightSide)
{
    const Terrain east = slope(10.0, 0.0);
    const GroundPose up = standOn(east, {20.0, 3.0}, 0.0, kCar);
    EXPECT_NEAR(up.pitch, -std::atan(0.1), 1e-12);
    EXPECT_NEAR(up.roll, 0.0, 1e-12);
    EXPECT_NEAR(up.position.z(), 2.0, 1e-12);
    // Driving north, the slope rises to the right.
    const GroundPose across = standOn(east, {20.0, 3.0}, 0.5 * kPi, kCar);
    EXPECT_NEAR(across.pitch, 0.0, 1e-12);
    EXPECT_NEAR(across.roll, -std::atan(0.1), 1e-12);
}

TEST(GroundPose, AllContactsAreOnASlopeOfAnyDirection)
{
    for (const double heading : {0.3, 2.0, -1.1})
    {
        const Terrain terrain = slope(15.0, 0.9);
        const GroundPose pose = standOn(terrain, {-4.0, 7.0}, heading, kCar);
        for (const double x : {kCar.front, -kCar.rear})
        {
            for (const double y : {kCar.half, -kCar.half})
            {
                const Eigen::Vector3d p =
                    pose.position + pose.attitude() * Eigen::Vector3d(x, y, 0.0);
                EXPECT_NEAR(p.z(), terrain.height(p.head<2>()), 1e-9);
            }
        }
        const Eigen::Vector3d forward = pose.attitude().col(0);
        EXPECT_NEAR(wrapAngle(std::atan2(forward.y(), forward.x()) - heading), 0.0, 1e-12);
    }
}

TEST(GroundPose, WithTwoWheelsOnAKerbItLeansToTheRoad)
{
    TerrainOptions options;
    options.kerbHeight = 0.16;
    options.roadWidth = 8.0;
    const GroundPose pose = standOn(Terrain(options), {0.0, 4.0}, 0.0, kCar);
    EXPECT_NEAR(pose.roll, std::atan(0.1), 1e-12);  // the left side is on the kerb
    EXPECT_NEAR(pose.position.z(), 0.08, 1e-12);
}

TEST(GroundPose, PolesStandUprightAndWallsFollowTheGround)
{
    Scene scene;
    scene.terrain = slope(20.0, 0.0);
    scene.objects = {objectAt(ObjectClass::Pole, {10.0, 0.0, 0.0, 0, 0}, {0.2, 0.2, 5.0}),
                     objectAt(ObjectClass::Wall, {10.0, 0.0, 0.0, 0, 0}, {20.0, 0.3, 2.0})};
    const GroundPose pole = objectPoseAt(scene, scene.objects[0], 0.0);
    EXPECT_EQ(pole.pitch, 0.0);
    EXPECT_NEAR(pole.position.z(), 2.0, 1e-12);
    EXPECT_NEAR(objectPoseAt(scene, scene.objects[1], 0.0).pitch, -std::atan(0.2), 1e-12);
}

/// Where a return of the scan is in the scene, for a sensor that stands still.
Eigen::Vector3d pointOf(const Scene& scene, const LadarMount& mount, const LadarFiring& firing,
                        std::size_t laser)
{
    const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
    const double e = mount.ladar.elevations[laser];
    const double a =
        firing.azimuth + mount.ladar.laserDelays[laser] / sweep.period * sweep.azimuthStep;
    const GroundPose platform = platformPoseAt(scene, 0.0);
    const Eigen::Vector3d inSensor(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a),
                                   std::sin(e));
    const Eigen::Vector3d inVehicle =
        mount.position + firing.returns[laser].range *
                             (attitudeOf(mount.heading, mount.pitch, mount.roll) * inSensor);
    return platform.position + platform.attitude() * inVehicle;
}

TEST(GroundPose, ReturnsOnATiltedBoxAndTheGroundAreWhereTheyBelong)
{
    Scene scene;
    TerrainOptions options;
    options.slope = 8.0;
    options.slopeDirection = 1.0;
    options.bumpAmplitude = 0.3;
    scene.terrain = Terrain(options);
    scene.platform = Trajectory({3.0, -2.0, 0.4, 0.0, 0.0}, {});
    const BodySize size{4.0, 1.8, 1.5};
    scene.objects = {objectAt(ObjectClass::Box, {14.0, 4.0, 0.9, 0, 0}, size)};
    LadarMount mount = idealMount();
    mount.pitch = 0.05;
    mount.roll = -0.08;
    const GroundPose box = objectPoseAt(scene, scene.objects[0], 0.0);
    EXPECT_GT(std::abs(box.pitch) + std::abs(box.roll), 0.03);
    int onBox = 0;
    for (const LadarFiring& firing : cast(scene, mount))
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            if (firing.returns[laser].range == 0.0) continue;
            const Eigen::Vector3d p = pointOf(scene, mount, firing, laser);
            if (firing.returns[laser].object == LadarReturn::kGround)
            {
                ASSERT_NEAR(p.z(), scene.terrain.height(p.head<2>()), 1e-5);
                continue;
            }
            const Eigen::Vector3d q = box.attitude().transpose() * (p - box.position);
            const double outside =
                std::max({std::abs(q.x()) - 2.0, std::abs(q.y()) - 0.9, q.z() - 1.5, -q.z()});
            ASSERT_NEAR(outside, 0.0, 1e-9);
            ++onBox;
        }
    }
    EXPECT_GT(onBox, 200);
}
}  // namespace
}  // namespace vdamf
