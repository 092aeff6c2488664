// SPDX-License-Identifier: BSD-3-Clause
// Profiles of the bodies: inside their box, and touching it where they are widest.
#include "vdamf/simulation/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
/// Hits of level rays at a height from all around towards the body's axis.
std::vector<Eigen::Vector3d> outline(const Body& body, double z, int rays, double aside = 0.0)
{
    RandomStream random(1, 0);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < rays; ++i)
    {
        const double angle = 2.0 * kPi * i / rays;
        const Eigen::Vector3d away(std::cos(angle), std::sin(angle), 0.0);
        const Eigen::Vector3d across(-away.y(), away.x(), 0.0);
        const Ray ray{50.0 * away + aside * across + z * Eigen::Vector3d::UnitZ(), -away};
        const auto hit = firstHit(body, ray, random);
        if (hit) points.push_back(ray.origin + hit->range * ray.direction);
    }
    return points;
}

std::string nameOfParam(const testing::TestParamInfo<ObjectClass>& info)
{
    return nameOf(info.param);
}

std::vector<ObjectClass> allClasses()
{
    std::vector<ObjectClass> classes;
    for (const auto& [objectClass, name] : EnumNames<ObjectClass>::names())
    {
        classes.push_back(objectClass);
    }
    return classes;
}

class AllBodies : public testing::TestWithParam<ObjectClass>
{
};

TEST_P(AllBodies, AreInsideTheirBoxFromAllDirections)
{
    const BodySize usual = typicalSize(GetParam());
    RandomStream random(4, 0);
    for (const double scale : {1.0, 1.3})
    {
        const BodySize size{scale * usual.length, usual.width, scale * usual.height};
        const Body body = makeBody(GetParam(), size);
        int hits = 0;
        for (int i = 0; i < 4000; ++i)
        {
            const Eigen::Vector3d target((random.uniform() - 0.5) * size.length,
                                         (random.uniform() - 0.5) * size.width,
                                         random.uniform() * size.height);
            const double angle = 2.0 * kPi * random.uniform();
            const Eigen::Vector3d origin(40.0 * std::cos(angle), 40.0 * std::sin(angle),
                                         12.0 * random.uniform());
            const Ray ray{origin, (target - origin).normalized()};
            const auto hit = firstHit(body, ray, random);
            if (!hit) continue;
            ++hits;
            const Eigen::Vector3d p = origin + hit->range * ray.direction;
            ASSERT_LE(std::abs(p.x()), 0.5 * size.length + 1e-9) << p.transpose();
            ASSERT_LE(std::abs(p.y()), 0.5 * size.width + 1e-9) << p.transpose();
            ASSERT_LE(p.z(), size.height + 1e-9) << p.transpose();
        }
        EXPECT_GT(hits, 200);
    }
}

TEST_P(AllBodies, HaveATruthClassWhereTheyAreRoadUsers)
{
    const ObjectClass objectClass = GetParam();
    EXPECT_EQ(isVehicle(objectClass), objectClass <= ObjectClass::Tram);
    EXPECT_EQ(truthClass(objectClass).has_value(), objectClass <= ObjectClass::Pedestrian);
    if (!truthClass(objectClass)) return;
    const std::vector<std::string>& known = truthClasses();
    EXPECT_NE(std::find(known.begin(), known.end(), *truthClass(objectClass)), known.end());
}

INSTANTIATE_TEST_SUITE_P(Classes, AllBodies, testing::ValuesIn(allClasses()), nameOfParam);

class Vehicles : public testing::TestWithParam<ObjectClass>
{
};

TEST_P(Vehicles, TouchAllFourSidesOfTheirBox)
{
    const BodySize size = typicalSize(GetParam());
    const Body body = makeBody(GetParam(), size);
    Eigen::Vector3d low(99, 99, 99);
    Eigen::Vector3d high = -low;
    for (double z = 0.3; z < 0.6 * size.height; z += 0.05)
    {
        for (const Eigen::Vector3d& p : outline(body, z, 720))
        {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    }
    EXPECT_NEAR(high.x(), 0.5 * size.length, 0.01);
    EXPECT_NEAR(low.x(), -0.5 * size.length, 0.01);
    EXPECT_NEAR(high.y(), 0.5 * size.width, 0.01);
    EXPECT_NEAR(low.y(), -0.5 * size.width, 0.01);
}

TEST_P(Vehicles, AreClosedFromSillToRoof)
{
    const BodySize size = typicalSize(GetParam());
    const Body body = makeBody(GetParam(), size);
    for (double z = 0.42; z < size.height - 0.02; z += 0.02)
    {
        EXPECT_EQ(outline(body, z, 36).size(), 36U) << z;
    }
    EXPECT_TRUE(outline(body, size.height + 0.01, 36).empty());
}

TEST_P(Vehicles, StandOnTheGround)
{
    const BodySize size = typicalSize(GetParam());
    const Body body = makeBody(GetParam(), size);
    for (const Wheel& wheel : body.wheels) EXPECT_NEAR(wheel.centre.z(), wheel.radius, 1e-12);
    EXPECT_EQ(body.wheels.empty(), GetParam() == ObjectClass::Tram);
}

INSTANTIATE_TEST_SUITE_P(Classes, Vehicles,
                         testing::Values(ObjectClass::Car, ObjectClass::Hatchback, ObjectClass::Suv,
                                         ObjectClass::Van, ObjectClass::Truck, ObjectClass::Trailer,
                                         ObjectClass::Bus, ObjectClass::Tram),
                         nameOfParam);

TEST(Body, ABumperIsTheLongestPartOfACarAndItsCornersAreCutBack)
{
    const BodySize size = typicalSize(ObjectClass::Car);
    const Body car = makeBody(ObjectClass::Car, size);
    RandomStream random(1, 0);
    const auto frontAt = [&](double y, double z)
    {
        const Ray ray{{20.0, y, z}, -Eigen::Vector3d::UnitX()};
        return 0.5 * size.length - (20.0 - firstHit(car, ray, random)->range);
    };
    EXPECT_NEAR(frontAt(0.0, 0.46), 0.0, 0.01);
    EXPECT_NEAR(frontAt(0.0, 0.25), 0.15, 0.05);  // sill
    EXPECT_NEAR(frontAt(0.0, 0.80), 0.16, 0.06);  // upper edge of the nose
    EXPECT_GT(frontAt(0.0, 1.1), 1.0);            // windscreen
    EXPECT_NEAR(frontAt(0.75, 0.46), 0.12, 0.06);
    EXPECT_NEAR(frontAt(0.88, 0.46), 0.25, 0.08);
}

TEST(Body, RaysReachIntoWheelHouses)
{
    const BodySize size = typicalSize(ObjectClass::Car);
    const Body car = makeBody(ObjectClass::Car, size);
    RandomStream random(1, 0);
    const double axle = 0.30 * size.length;
    const auto depthAt = [&](double x, double z)
    {
        const Ray ray{{x, -20.0, z}, Eigen::Vector3d::UnitY()};
        return firstHit(car, ray, random)->range - 20.0 + 0.5 * size.width;
    };
    EXPECT_NEAR(depthAt(axle, 0.32), 0.03, 1e-9);        // the wheel
    EXPECT_NEAR(depthAt(axle + 0.36, 0.4), 0.30, 1e-9);  // beside it
    EXPECT_NEAR(depthAt(axle + 0.6, 0.46), 0.0, 0.02);   // ahead of it
}

TEST(Body, RidersAreThereWhereTheBodyIsAsHigh)
{
    RandomStream random(1, 0);
    const auto isHitAt = [&](double height, double z)
    {
        const Body body = makeBody(ObjectClass::Bicycle, {1.8, 0.6, height});
        return !outline(body, z, 90).empty();
    };
    EXPECT_TRUE(isHitAt(1.75, 1.4));
    EXPECT_FALSE(isHitAt(1.1, 1.11));
    EXPECT_TRUE(isHitAt(1.1, 0.9));
}

TEST(Body, AGuardRailIsOpenBelowItsBeamButForItsPosts)
{
    const Body rail = makeBody(ObjectClass::GuardRail, {20.0, 0.3, 0.75});
    RandomStream random(1, 0);
    int low = 0;
    for (double x = -9.99; x < 10.0; x += 0.02)
    {
        const auto cast = [&](double z) {
            return firstHit(rail, {{x, -5.0, z}, Eigen::Vector3d::UnitY()}, random).has_value();
        };
        EXPECT_TRUE(cast(0.6)) << x;
        low += cast(0.3) ? 1 : 0;
    }
    EXPECT_NEAR(low, 11 * 6, 12);  // eleven posts, 0.12 m thick
}

TEST(Body, CabinOfACarIsShorterThanItsBodyAndAVansIsNot)
{
    const auto lengthAt = [](ObjectClass objectClass, double share)
    {
        const BodySize size = typicalSize(objectClass);
        const auto points = outline(makeBody(objectClass, size), share * size.height, 4);
        return (points.at(0).x() - points.at(2).x()) / size.length;
    };
    EXPECT_LT(lengthAt(ObjectClass::Car, 0.8), 0.52);
    EXPECT_GT(lengthAt(ObjectClass::Van, 0.8), 0.72);
}

TEST(Body, RaysGoThroughFoliageAsFarAsAnExponentialSays)
{
    const BodySize size{4.0, 2.0, 2.0};
    const Body bush = makeBody(ObjectClass::Bush, size);
    const double chord = 4.0;  // through the ellipsoid's centre, at 40 % of the height
    const Ray ray{{-10.0, 0.0, 0.8}, Eigen::Vector3d::UnitX()};
    RandomStream random(5, 0);
    const int n = 20000;
    int through = 0;
    double depth = 0.0;
    for (int i = 0; i < n; ++i)
    {
        const auto hit = firstHit(bush, ray, random);
        if (!hit)
        {
            ++through;
            continue;
        }
        EXPECT_GE(hit->range, 8.0 - 1e-9);
        EXPECT_LE(hit->range, 8.0 + chord);
        depth += hit->range - 8.0;
    }
    EXPECT_LT(through, n / 1000);
    EXPECT_NEAR(depth / (n - through), 0.3, 0.01);
}

TEST(Body, PoleIsAsThickAsItsWidth)
{
    const auto points = outline(makeBody(ObjectClass::Pole, {0.3, 0.3, 4.0}), 2.0, 16);
    ASSERT_EQ(points.size(), 16U);
    for (const auto& p : points) EXPECT_NEAR(p.head<2>().norm(), 0.15, 1e-9);
}

TEST(Body, TooSmallVehiclesAndEmptySizesAreRefused)
{
    EXPECT_THROW(makeBody(ObjectClass::Car, {1.5, 1.6, 1.5}), std::runtime_error);
    EXPECT_THROW(makeBody(ObjectClass::Van, {5.0, 0.8, 2.0}), std::runtime_error);
    EXPECT_THROW(makeBody(ObjectClass::Wall, {5.0, 0.0, 2.0}), std::runtime_error);
    EXPECT_THROW(makeBody(ObjectClass::Tram, {3.0, 2.0, 3.0}), std::runtime_error);
    EXPECT_NO_THROW(makeBody(ObjectClass::Car, {2.0, 1.0, 1.0}));
}
}  // namespace
}  // namespace vdamf
