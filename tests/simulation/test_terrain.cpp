// SPDX-License-Identifier: BSD-3-Clause
// The ground: heights by the formula, ray hits against a fine search along the ray.
#include "vdamf/simulation/terrain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/simulation/random_stream.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
/// The first step at which the ray is below the ground, refined by halving; 0 for none.
double searched(const Terrain& terrain, const Ray& ray, double maxRange)
{
    const auto above = [&](double range)
    {
        const Eigen::Vector3d p = ray.origin + range * ray.direction;
        return p.z() - terrain.height(p.head<2>());
    };
    const double step = 0.005;
    for (double range = step; range < maxRange; range += step)
    {
        if (above(range) > 0.0) continue;
        double low = range - step;
        double high = range;
        for (int i = 0; i < 40; ++i)
        {
            const double middle = 0.5 * (low + high);
            (above(middle) > 0.0 ? low : high) = middle;
        }
        return high;
    }
    return 0.0;
}

Ray randomRay(const Terrain& terrain, RandomStream& random)
{
    const Eigen::Vector2d place(20.0 * random.uniform() - 10.0, 6.0 * random.uniform() - 3.0);
    const double azimuth = 2.0 * kPi * random.uniform();
    const double elevation = -0.5 * random.uniform() + 0.05;
    return {{place.x(), place.y(), terrain.height(place) + 1.9},
            {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
             std::sin(elevation)}};
}

TerrainOptions hilly()
{
    TerrainOptions options;
    options.slope = 6.0;
    options.slopeDirection = 0.7;
    options.bumpAmplitude = 0.4;
    options.bumpWavelength = 15.0;
    return options;
}

TEST(Terrain, FlatGroundIsHitWhereTheFormulaSays)
{
    const Terrain flat;
    EXPECT_TRUE(flat.isFlat());
    EXPECT_EQ(flat.height({3.0, 4.0}), 0.0);
    const auto hit = flat.firstHit({{1.0, 2.0, 2.0}, {0.6, 0.0, -0.8}}, 100.0);
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->range, 2.5);
    EXPECT_DOUBLE_EQ(hit->cosIncidence, 0.8);
    EXPECT_FALSE(flat.firstHit({{1.0, 2.0, 2.0}, {0.6, 0.0, -0.8}}, 2.4));
    EXPECT_FALSE(flat.firstHit({{1.0, 2.0, 2.0}, {1.0, 0.0, 0.0}}, 100.0));
}

TEST(Terrain, HeightIsSlopeWavesAndKerb)
{
    TerrainOptions options = hilly();
    options.kerbHeight = 0.12;
    options.roadWidth = 8.0;
    options.roadY = 1.0;
    const Terrain terrain(options);
    const Eigen::Vector2d onRoad(3.0, 2.0);
    const double k = 2.0 * kPi / 15.0;
    const double expected = 0.06 * (3.0 * std::cos(0.7) + 2.0 * std::sin(0.7)) +
                            0.2 * (std::sin(k * 3.0) + std::sin(k * 2.0));
    EXPECT_NEAR(terrain.height(onRoad), expected, 1e-12);
    EXPECT_NEAR(terrain.height({3.0, 5.001}) - terrain.height({3.0, 4.999}), 0.12, 1e-3);
    EXPECT_NEAR(terrain.height({3.0, -3.001}) - terrain.height({3.0, -2.999}), 0.12, 1e-3);
}

class Grounds : public testing::TestWithParam<TerrainOptions>
{
};

TEST_P(Grounds, RaysMeetTheGroundWhereASearchFindsIt)
{
    const Terrain terrain(GetParam());
    RandomStream random(11, 0);
    int hits = 0;
    for (int i = 0; i < 400; ++i)
    {
        const Ray ray = randomRay(terrain, random);
        const double expected = searched(terrain, ray, 60.0);
        const auto hit = terrain.firstHit(ray, 60.0);
        EXPECT_EQ(hit.has_value(), expected > 0.0) << i;
        if (!hit || expected == 0.0) continue;
        ++hits;
        EXPECT_NEAR(hit->range, expected, 1e-5) << i;
        EXPECT_GE(hit->cosIncidence, 0.0);
        EXPECT_LE(hit->cosIncidence, 1.0);
    }
    EXPECT_GT(hits, 250);
}

TerrainOptions sloping()
{
    TerrainOptions options;
    options.slope = 12.0;
    options.slopeDirection = -2.0;
    return options;
}

TerrainOptions kerbed()
{
    TerrainOptions options;
    options.kerbHeight = 0.15;
    options.roadHeading = 0.3;
    options.roadWidth = 9.0;
    return options;
}

TerrainOptions everything()
{
    TerrainOptions options = hilly();
    options.kerbHeight = 0.2;
    options.roadWidth = 9.0;
    return options;
}

INSTANTIATE_TEST_SUITE_P(All, Grounds, testing::Values(sloping(), hilly(), kerbed(), everything()));

TEST(Terrain, AKerbIsAnUprightFaceFromTheRoadAndNoneFromBeside)
{
    TerrainOptions options;
    options.kerbHeight = 0.2;
    options.roadWidth = 8.0;
    const Terrain terrain(options);
    const auto face = terrain.firstHit({{0.0, 0.0, 0.1}, {0.0, 1.0, 0.0}}, 50.0);
    ASSERT_TRUE(face);
    EXPECT_NEAR(face->range, 4.0, 1e-12);
    EXPECT_EQ(face->material, Material::Concrete);
    EXPECT_NEAR(face->cosIncidence, 1.0, 1e-12);
    // From beside the road, high enough over this kerb: into the far one.
    const auto across = terrain.firstHit({{0.0, -6.0, 0.3}, {0.0, 0.9998, -0.019997}}, 50.0);
    ASSERT_TRUE(across);
    EXPECT_NEAR(across->range, 10.0 / 0.9998, 1e-6);
}

TEST(Terrain, RaysFromBelowTheGroundMeetNothing)
{
    const Terrain terrain(hilly());
    EXPECT_FALSE(terrain.firstHit({{0.0, 0.0, -5.0}, {1.0, 0.0, 0.0}}, 1.0));
}
}  // namespace
}  // namespace vdamf
