// SPDX-License-Identifier: BSD-3-Clause
// Profiles of the bodies: inside their box, and touching it where they are widest.
#include "vdamf/simulation/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

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

class Vehicles : public testing::TestWithParam<ObjectClass>
{
};

TEST_P(Vehicles, AreInsideTheirBoxAtEveryHeight)
{
    const BodySize size = typicalSize(GetParam());
    const Body body = makeBody(GetParam(), size);
    for (double z = 0.01; z < size.height + 0.3; z += 0.037)
    {
        for (const double aside : {0.0, 0.7, -1.4})
        {
            for (const Eigen::Vector3d& p : outline(body, z, 90, aside))
            {
                EXPECT_LE(std::abs(p.x()), 0.5 * size.length + 1e-9) << z;
                EXPECT_LE(std::abs(p.y()), 0.5 * size.width + 1e-9) << z;
                EXPECT_LE(p.z(), size.height + 1e-9);
            }
        }
    }
}

TEST_P(Vehicles, TouchAllFourSidesOfTheirBox)
{
    const BodySize size = typicalSize(GetParam());
    const double z = 0.4 * size.height;
    Eigen::Vector3d low(99, 99, 99);
    Eigen::Vector3d high = -low;
    for (const Eigen::Vector3d& p : outline(makeBody(GetParam(), size), z, 720))
    {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    EXPECT_NEAR(high.x(), 0.5 * size.length, 1e-9);
    EXPECT_NEAR(low.x(), -0.5 * size.length, 1e-9);
    EXPECT_NEAR(high.y(), 0.5 * size.width, 1e-9);
    EXPECT_NEAR(low.y(), -0.5 * size.width, 1e-9);
}

TEST_P(Vehicles, AreClosedFromSillToRoof)
{
    const BodySize size = typicalSize(GetParam());
    const Body body = makeBody(GetParam(), size);
    for (double z = 0.27; z < size.height - 0.02; z += 0.02)
    {
        EXPECT_EQ(outline(body, z, 36).size(), 36U) << z;
    }
    EXPECT_TRUE(outline(body, size.height + 0.01, 36).empty());
}

INSTANTIATE_TEST_SUITE_P(All, Vehicles,
                         testing::Values(ObjectClass::Car, ObjectClass::Van, ObjectClass::Truck));

TEST(Body, CabinOfACarIsShorterThanItsBodyAndAVansIsNot)
{
    const auto lengthAt = [](ObjectClass objectClass, double share)
    {
        const BodySize size = typicalSize(objectClass);
        const auto points = outline(makeBody(objectClass, size), share * size.height, 4);
        return (points.at(0).x() - points.at(2).x()) / size.length;
    };
    EXPECT_LT(lengthAt(ObjectClass::Car, 0.8), 0.7);
    EXPECT_GT(lengthAt(ObjectClass::Van, 0.8), 0.8);
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
    EXPECT_NO_THROW(makeBody(ObjectClass::Car, {2.0, 1.0, 1.0}));
}
}  // namespace
}  // namespace vdamf
