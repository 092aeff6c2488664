// SPDX-License-Identifier: BSD-3-Clause
// Ray intersections against a march along the ray with an inside test.
#include "vdamf/simulation/shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
namespace
{
constexpr double kFar = 12.0;

using Inside = std::function<bool(const Eigen::Vector3d&)>;

/// The first point of the ray inside, to 1e-9 m; negative where a march of 2 mm steps finds none.
double marched(const Ray& ray, const Inside& inside)
{
    const double step = 0.002;
    for (double range = step; range < kFar; range += step)
    {
        if (!inside(ray.origin + range * ray.direction)) continue;
        double low = range - step;
        double high = range;
        while (high - low > 1e-10)
        {
            const double middle = 0.5 * (low + high);
            (inside(ray.origin + middle * ray.direction) ? high : low) = middle;
        }
        return high;
    }
    return -1.0;
}

Ray randomRay(RandomStream& random)
{
    Eigen::Vector3d origin;
    Eigen::Vector3d target;
    for (int i = 0; i < 3; ++i)
    {
        origin[i] = 8.0 * random.uniform() - 4.0;
        target[i] = 2.4 * random.uniform() - 1.2;
    }
    return {origin, (target - origin).normalized()};
}

/// Compares `cast` (range, negative for none) with the march on random rays from outside.
void expectSame(const Inside& inside, const std::function<double(const Ray&)>& cast)
{
    RandomStream random(11, 0);
    int hits = 0;
    int misses = 0;
    for (int i = 0; i < 600; ++i)
    {
        const Ray ray = randomRay(random);
        if (inside(ray.origin)) continue;
        const double expected = marched(ray, inside);
        const double range = cast(ray);
        // The march steps over corners that the ray cuts by less than a step.
        if (expected < 0.0 && range >= 0.0)
        {
            EXPECT_FALSE(inside(ray.origin + (range + 0.004) * ray.direction)) << "ray " << i;
            continue;
        }
        ASSERT_NEAR(range, expected, expected < 0.0 ? 0.0 : 1e-7) << "ray " << i;
        ++(expected < 0.0 ? misses : hits);
    }
    EXPECT_GT(hits, 150);
    EXPECT_GT(misses, 20);
}

ConvexSolid slantedSolid()
{
    ConvexSolid solid;
    const Eigen::Vector3d normals[] = {{1, 0, 0.4}, {-1, 0.2, 0.1}, {0, 1, 0.3}, {0.1, -1, 0},
                                       {0, 0, 1},   {0, 0, -1},     {1, 1, 0}};
    const double offsets[] = {0.9, 0.8, 0.7, 0.9, 0.6, 0.5, 0.8};
    for (int i = 0; i < 7; ++i) solid.faces.push_back({normals[i].normalized(), offsets[i]});
    return solid;
}

TEST(Shapes, ConvexSolidAgreesWithMarch)
{
    const ConvexSolid solid = slantedSolid();
    const auto inside = [&](const Eigen::Vector3d& p)
    {
        for (const SolidFace& face : solid.faces)
        {
            if (face.normal.dot(p) > face.offset) return false;
        }
        return true;
    };
    expectSame(inside,
               [&](const Ray& ray)
               {
                   const auto hit = intersect(solid, ray);
                   return hit ? hit->range : -1.0;
               });
}

TEST(Shapes, CylinderAgreesWithMarch)
{
    const UprightCylinder cylinder{{0.2, -0.1}, 0.7, -0.5, 0.8, Material::Metal};
    const auto inside = [&](const Eigen::Vector3d& p)
    {
        return (p.head<2>() - cylinder.centre).norm() <= cylinder.radius &&
               p.z() >= cylinder.bottom && p.z() <= cylinder.top;
    };
    expectSame(inside,
               [&](const Ray& ray)
               {
                   const auto hit = intersect(cylinder, ray);
                   return hit ? hit->range : -1.0;
               });
}

TEST(Shapes, WheelAgreesWithMarch)
{
    const Wheel wheel{{0.2, -0.1, 0.3}, 0.8, 0.9, Material::Rubber};
    const auto inside = [&](const Eigen::Vector3d& p)
    {
        const Eigen::Vector3d d = p - wheel.centre;
        return std::hypot(d.x(), d.z()) <= wheel.radius && std::abs(d.y()) <= 0.5 * wheel.width;
    };
    expectSame(inside,
               [&](const Ray& ray)
               {
                   const auto hit = intersect(wheel, ray);
                   return hit ? hit->range : -1.0;
               });
}

TEST(Shapes, EllipsoidAgreesWithMarch)
{
    const Ellipsoid ellipsoid{{0.1, 0.2, -0.1}, {1.0, 0.5, 0.7}};
    const auto inside = [&](const Eigen::Vector3d& p)
    { return (p - ellipsoid.centre).cwiseQuotient(ellipsoid.radii).norm() <= 1.0; };
    expectSame(inside,
               [&](const Ray& ray)
               {
                   const auto chord = passage(ellipsoid, ray);
                   return chord ? chord->enter : -1.0;
               });
}

TEST(Shapes, PassageLeavesWhereTheReversedRayEnters)
{
    const Ellipsoid ellipsoid{{1.0, 0.0, 0.5}, {2.0, 1.0, 0.5}};
    const Ray ray{{-5.0, 0.3, 0.4}, Eigen::Vector3d(1.0, 0.02, 0.03).normalized()};
    const auto chord = passage(ellipsoid, ray);
    ASSERT_TRUE(chord);
    const Ray back{ray.origin + 20.0 * ray.direction, -ray.direction};
    EXPECT_NEAR(passage(ellipsoid, back)->enter, 20.0 - chord->leave, 1e-9);
    const Ray within{ray.origin + 0.5 * (chord->enter + chord->leave) * ray.direction,
                     ray.direction};
    EXPECT_EQ(passage(ellipsoid, within)->enter, 0.0);
}

TEST(Shapes, IncidenceIsTheAngleToTheNormal)
{
    const Eigen::Vector3d direction = Eigen::Vector3d(-1.0, 0.5, 0.0).normalized();
    const Ray ray{{5.0, -2.0, 0.0}, direction};
    ConvexSolid slab;
    slab.faces = {{Eigen::Vector3d::UnitX(), 1.0, Material::Glass},
                  {-Eigen::Vector3d::UnitX(), 1.0, Material::Paint}};
    const auto onSlab = intersect(slab, ray);
    ASSERT_TRUE(onSlab);
    EXPECT_NEAR(onSlab->cosIncidence, -direction.x(), 1e-12);
    EXPECT_EQ(onSlab->material, Material::Glass);
    const Ray central{{5.0, 0.0, 0.0}, -Eigen::Vector3d::UnitX()};
    EXPECT_NEAR(intersect(UprightCylinder{{0, 0}, 1.0, -1.0, 1.0}, central)->cosIncidence, 1.0,
                1e-12);
}

TEST(Shapes, RayFromInsideHitsNothing)
{
    const Ray ray{{0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX()};
    EXPECT_FALSE(intersect(slantedSolid(), ray));
    EXPECT_FALSE(intersect(UprightCylinder{{0, 0}, 1.0, -1.0, 1.0}, ray));
    const Ray steep{{0.0, 0.0, 0.0}, Eigen::Vector3d(0.1, 0.0, -1.0).normalized()};
    EXPECT_FALSE(intersect(UprightCylinder{{0, 0}, 1.0, -1.0, 1.0}, steep));
}
}  // namespace
}  // namespace vdamf
