// SPDX-License-Identifier: BSD-3-Clause
// Revolutions through small scenes: occlusion, outlines, noise, losses, motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulation/small_scenes.h"

namespace vdamf
{
namespace
{
struct Hit
{
    Eigen::Vector3d point;  ///< scene frame
    double time;
    int object;
};

/// The returns as points, by the formula of the header; the platform stands at the origin.
std::vector<Hit> hitsOf(const std::vector<LadarFiring>& revolution, const LadarMount& mount)
{
    const double step = 2.0 * kPi / static_cast<double>(revolution.size());
    std::vector<Hit> hits;
    for (const LadarFiring& firing : revolution)
    {
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const LadarReturn& one = firing.returns[laser];
            if (one.range == 0.0) continue;
            const double e = mount.ladar.elevations[laser];
            const double a = firing.azimuth +
                             step * mount.ladar.laserDelays[laser] / mount.ladar.firingPeriod -
                             mount.heading;
            const Eigen::Vector3d d(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a),
                                    std::sin(e));
            hits.push_back({mount.position + one.range * d, firing.time, one.object});
        }
    }
    return hits;
}

TEST(RayCaster, AnObjectBehindAWallHasNoHits)
{
    Scene scene;
    scene.objects = {objectAt(ObjectClass::Car, {20.0, 0.0, 0.3, 0, 0}, {4.5, 1.8, 1.5}),
                     objectAt(ObjectClass::Wall, {12.0, 0.0, 0.5 * kPi, 0, 0}, {20.0, 0.3, 3.0})};
    std::vector<int> hits = countHits(cast(scene, idealMount()), 2);
    EXPECT_EQ(hits[0], 0);
    EXPECT_GT(hits[1], 1000);

    scene.objects.pop_back();
    EXPECT_GT(countHits(cast(scene, idealMount()), 1)[0], 100);
}

TEST(RayCaster, HitsAreOnTheGroundOrOnTheirObjectsOutline)
{
    Scene scene;
    const OrientedBox pose{9.0, 4.0, 0.7, 0, 0};
    scene.objects = {objectAt(ObjectClass::Box, pose, {4.0, 1.6, 1.4})};
    const OrientedBox box = boxAt(scene.objects[0], 0.0);
    LadarMount mount = idealMount();
    mount.heading = 0.4;
    int onObject = 0;
    for (const Hit& hit : hitsOf(cast(scene, mount), mount))
    {
        const Eigen::Vector2d p = toBoxFrame(box, hit.point.head<2>());
        const double aside = std::max(std::abs(p.x()) - 2.0, std::abs(p.y()) - 0.8);
        if (hit.object == LadarReturn::kGround)
        {
            EXPECT_NEAR(hit.point.z(), 0.0, 1e-9);
            EXPECT_GT(aside, -1e-9);
            continue;
        }
        ++onObject;
        EXPECT_NEAR(std::max(aside, hit.point.z() - 1.4), 0.0, 1e-9);
    }
    EXPECT_GT(onObject, 300);
}

TEST(RayCaster, TheTruthBoxHoldsAllHitsOfAVehicle)
{
    Scene scene;
    for (int i = 0; i < 8; ++i)
    {
        const double angle = 0.25 * kPi * i;
        const OrientedBox pose{11.0 * std::cos(angle), 11.0 * std::sin(angle), 1.1 * i, 0, 0};
        const ObjectClass objectClass = i % 2 == 0 ? ObjectClass::Car : ObjectClass::Van;
        scene.objects.push_back(objectAt(objectClass, pose, typicalSize(objectClass)));
    }
    const LadarMount mount = idealMount();
    std::vector<int> inside(8, 0);
    for (const Hit& hit : hitsOf(cast(scene, mount), mount))
    {
        if (hit.object < 0) continue;
        const std::size_t index = static_cast<std::size_t>(hit.object);
        const OrientedBox box = boxAt(scene.objects[index], 0.0);
        const Eigen::Vector2d p = toBoxFrame(box, hit.point.head<2>());
        EXPECT_LE(std::abs(p.x()), 0.5 * box.length + 1e-9);
        EXPECT_LE(std::abs(p.y()), 0.5 * box.width + 1e-9);
        EXPECT_LE(hit.point.z(), scene.objects[index].size.height + 1e-9);
        ++inside[index];
    }
    for (const int count : inside) EXPECT_GT(count, 200);
}

TEST(RayCaster, RangeNoiseHasItsStandardDeviation)
{
    Scene scene;
    scene.objects = {objectAt(ObjectClass::Wall, {10.0, 0.0, 0.5 * kPi, 0, 0}, {30.0, 0.3, 8.0})};
    LadarMount mount = idealMount();
    const std::vector<LadarFiring> exact = cast(scene, mount);
    mount.ladar.rangeNoise = 0.03;
    const std::vector<LadarFiring> noisy = cast(scene, mount);
    double sum = 0.0;
    double square = 0.0;
    int n = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        for (std::size_t laser = 0; laser < 32; ++laser)
        {
            const LadarReturn& a = exact[i].returns[laser];
            const LadarReturn& b = noisy[i].returns[laser];
            if (a.object != 0 || b.object != 0) continue;
            sum += b.range - a.range;
            square += (b.range - a.range) * (b.range - a.range);
            ++n;
        }
    }
    ASSERT_GT(n, 5000);
    EXPECT_NEAR(sum / n, 0.0, 4.0 * 0.03 / std::sqrt(n));
    EXPECT_NEAR(std::sqrt(square / n), 0.03, 4.0 * 0.03 / std::sqrt(2.0 * n));
}

TEST(RayCaster, GroundReturnsFadeWithRangeAndEndAtTheMaximum)
{
    LadarMount mount = idealMount();
    mount.halfLossStrength = 0.01;
    mount.ladar.maxRange = 60.0;
    int near = 0;
    int far = 0;
    for (const LadarFiring& firing : cast({}, mount))
    {
        for (const LadarReturn& one : firing.returns)
        {
            EXPECT_LE(one.range, 60.0);
            if (one.range > 0.0 && one.range < 12.0) ++near;
            if (one.range > 40.0) ++far;
        }
    }
    // Beams from -30.67 to -10.67 degrees meet the ground within 12 m: 16 of them.
    EXPECT_GT(near, 16 * 2160 * 99 / 100);
    EXPECT_LT(far, 2160 / 4);
    EXPECT_GT(far, 0);
}

TEST(RayCaster, GlassLosesItsShare)
{
    Scene scene;
    scene.objects = {objectAt(ObjectClass::Car, {6.0, 4.0, 0.0, 0, 0}, {4.5, 1.8, 1.5})};
    LadarMount mount = idealMount();
    const auto glass = [&](double loss)
    {
        mount.glassLoss = loss;
        int count = 0;
        for (const LadarFiring& firing : cast(scene, mount))
        {
            for (const LadarReturn& one : firing.returns)
            {
                if (one.intensity == reflectivity(Material::Glass)) ++count;
            }
        }
        return count;
    };
    const int all = glass(0.0);
    EXPECT_GT(all, 100);
    EXPECT_NEAR(glass(0.8), 0.2 * all, 0.1 * all);
    EXPECT_EQ(glass(1.0), 0);
}

TEST(RayCaster, FieldOfViewCutsAzimuths)
{
    LadarMount mount = idealMount();
    EXPECT_EQ(hitsOf(cast({}, mount), mount).size() / 2160, 23U);  // beams below the horizon
    mount.fieldOfView = 0.5 * kPi;
    for (const Hit& hit : hitsOf(cast({}, mount), mount))
    {
        const Eigen::Vector3d p = hit.point - mount.position;
        EXPECT_LE(std::abs(std::atan2(p.y(), p.x())), 0.25 * kPi + 0.003);
    }
}

TEST(RayCaster, MotionDuringTheRevolutionShowsUnlessFrozen)
{
    Scene scene;
    scene.objects = {objectAt(ObjectClass::Box, {15.0, -3.0, 0.0, 0, 0}, {4.0, 1.6, 1.8}, 20.0)};
    LadarMount mount = idealMount();
    const double width = 0.8;
    for (const bool frozen : {true, false})
    {
        mount.instantaneous = frozen;
        int count = 0;
        for (const Hit& hit : hitsOf(cast(scene, mount, 0.5), mount))
        {
            if (hit.object != 0) continue;
            ++count;
            const OrientedBox box = boxAt(scene.objects[0], frozen ? 0.5 : hit.time);
            const Eigen::Vector2d p = toBoxFrame(box, hit.point.head<2>());
            EXPECT_NEAR(
                std::max({std::abs(p.x()) - 2.0, std::abs(p.y()) - width, hit.point.z() - 1.8}),
                0.0, 1e-9);
        }
        EXPECT_GT(count, 50);
    }
}

TEST(RayCaster, MovingPlatformSeesFromWhereItIs)
{
    Scene scene;
    scene.platform = Trajectory({0.0, 0.0, 0.5 * kPi, 10.0, 0.0}, {});
    scene.objects = {objectAt(ObjectClass::Pole, {0.0, 30.0, 0.0, 0, 0}, {0.2, 0.2, 5.0})};
    LadarMount mount = idealMount();
    mount.position = {0.0, 0.0, 2.0};
    for (const double time : {0.0, 1.0, 2.0})
    {
        double nearest = 1e9;
        for (const LadarFiring& firing : cast(scene, mount, time))
        {
            for (const LadarReturn& one : firing.returns)
            {
                if (one.object == 0) nearest = std::min(nearest, one.range);
            }
        }
        EXPECT_NEAR(nearest, 29.9 - 10.0 * time, 0.02) << time;
    }
}
}  // namespace
}  // namespace vdamf
