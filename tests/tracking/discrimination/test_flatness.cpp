// SPDX-License-Identifier: BSD-3-Clause
// How flat faces are, and where the hits lie at several heights.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "discrimination/flatness.h"
#include "discrimination/height_profile.h"

namespace vdamf
{
namespace
{
// Hits every 10 cm of a side 4 m long and 1.8 m high that leans inwards by `lean` metres a metre.
CanonicalHits sideOf(float lean, float noise = 0.0F)
{
    std::mt19937 random(7);
    std::normal_distribution<float> scatter(0.0F, 1.0F);
    CanonicalHits hits;
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k < 18; ++k)
        {
            const float height = 0.1F * static_cast<float>(k) + 0.05F;
            hits.x.push_back(0.1F * static_cast<float>(i) + 0.05F);
            hits.y.push_back(lean * height + noise * scatter(random));
            hits.z.push_back(height);
        }
    hits.count = hits.size();
    hits.sensor = {2.0, -12.0};
    return hits;
}

TEST(Flatness, OfAWallIsFlatAndUpright)
{
    const Flatness wall = flatnessOf(sideOf(0.0F));
    EXPECT_EQ(wall.side.share, 1.0);
    EXPECT_NEAR(wall.side.scatter.value(), 0.0, 2e-3);
    EXPECT_NEAR(wall.side.tilt.value(), 0.0, 1e-3);
    EXPECT_NEAR(wall.least, 0.0, 2e-3);
    EXPECT_NEAR(wall.middle, 1.8 / std::sqrt(12.0), 0.01);
    EXPECT_NEAR(wall.greatest, 4.0 / std::sqrt(12.0), 0.01);
    // Of its hits those within half a metre of the corner lie near the end.
    EXPECT_NEAR(wall.end.share, 0.125, 1e-6);
}

TEST(Flatness, OfASideThatLeansIsTilted)
{
    const Flatness leaning = flatnessOf(sideOf(0.2F));
    EXPECT_NEAR(leaning.side.scatter.value(), 0.0, 2e-3);
    EXPECT_NEAR(leaning.side.tilt.value(), std::sin(std::atan(0.2)), 1e-3);
}

TEST(Flatness, OfLeavesScatters)
{
    EXPECT_NEAR(flatnessOf(sideOf(0.0F, 0.1F)).side.scatter.value(), 0.1, 0.01);
}

TEST(Flatness, OfAFewHitsTellsNoPlane)
{
    CanonicalHits hits;
    hits.x = hits.y = hits.z = {0.1F, 0.2F, 0.4F};
    hits.count = 3;
    const Flatness flatness = flatnessOf(hits);
    EXPECT_EQ(flatness.side.share, 1.0);
    EXPECT_FALSE(flatness.side.scatter || flatness.side.tilt);
    EXPECT_FALSE(flatness.end.scatter || flatness.end.tilt);
    EXPECT_NEAR(flatness.middle, 0.0, 1e-3);
}

TEST(Flatness, OfOneHitIsZero)
{
    CanonicalHits hits;
    hits.x = hits.y = hits.z = {2.0F};
    hits.count = 1;
    const Flatness flatness = flatnessOf(hits);
    EXPECT_EQ(flatness.side.share, 0.0);
    EXPECT_EQ(flatness.greatest, 0.0);
}

TEST(HeightProfile, TellsWhereTheSideIsAtEachHeight)
{
    const HeightProfile profile = heightProfileOf(sideOf(0.2F));
    ASSERT_TRUE(profile[0] && profile[1] && profile[2]);
    for (const auto& band : profile)
    {
        EXPECT_NEAR(band->x, 2.0, 1e-3);
        EXPECT_NEAR(band->xScatter, 4.0 / std::sqrt(12.0), 0.01);
    }
    EXPECT_NEAR(profile[0]->y, 0.2 * 0.25, 1e-3);
    EXPECT_NEAR(profile[1]->y, 0.2 * 1.2, 0.02);
    EXPECT_NEAR(profile[2]->y, 0.2 * 1.6, 0.02);
    EXPECT_LT(profile[1]->yScatter, 0.04);
}

TEST(HeightProfile, KnowsNoBandsOfFewHits)
{
    CanonicalHits hits;
    hits.x = hits.y = {0.1F, 0.2F, 0.4F, 0.4F};
    hits.z = {0.2F, 0.3F, 0.4F, 1.2F};
    hits.count = 4;
    const HeightProfile profile = heightProfileOf(hits);
    EXPECT_TRUE(profile[0]);
    EXPECT_FALSE(profile[1] || profile[2]);
}
}  // namespace
}  // namespace vdamf
