// SPDX-License-Identifier: BSD-3-Clause
// Outlines and depths as the sensor sees them: sheet metal, windscreens, leaves, posts.
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "discrimination/silhouette.h"

namespace vdamf
{
namespace
{
// Hits every 10 cm of a surface 4 m long and 1.5 m high, straight ahead of the sensor; its depth
// and whether there is a hit are functions of the place along it and of the height.
CanonicalHits surface(const std::function<float(float, float)>& depth,
                      const std::function<bool(float, float)>& isThere)
{
    CanonicalHits hits;
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k < 15; ++k)
        {
            const float along = 0.1F * static_cast<float>(i) + 0.05F;
            const float height = 0.1F * static_cast<float>(k) + 0.05F;
            if (!isThere(along, height)) continue;
            hits.x.push_back(along);
            hits.y.push_back(depth(along, height));
            hits.z.push_back(height);
        }
    hits.count = hits.size();
    hits.sensor = {2.0, -1e4};
    return hits;
}

bool always(float, float)
{
    return true;
}

float flat(float, float)
{
    return 0.0F;
}

TEST(Silhouette, OfAWallIsClosedThinAndStraight)
{
    const Silhouette s = silhouetteOf(surface(flat, always), false);
    EXPECT_NEAR(s.breadth, 3.9, 0.01);
    EXPECT_EQ(s.coverage, 1.0);
    EXPECT_NEAR(s.thickness.value(), 0.0, 1e-3);
    EXPECT_NEAR(s.bend.value(), 0.0, 1e-3);
    EXPECT_NEAR(s.slope.value(), 0.0, 1e-3);
    EXPECT_NEAR(s.ragged.value(), 0.0, 1e-3);
}

TEST(Silhouette, OfAWindscreenLeansAway)
{
    const auto leaning = [](float, float height) { return 0.8F * height; };
    const Silhouette s = silhouetteOf(surface(leaning, always), false);
    EXPECT_NEAR(s.slope.value(), 0.8 * 0.25, 0.02);
    EXPECT_NEAR(s.bend.value(), 0.0, 1e-3);
    const auto overhanging = [](float, float height) { return -0.8F * height; };
    EXPECT_LT(silhouetteOf(surface(overhanging, always), false).slope.value(), -0.15);
}

TEST(Silhouette, OfARoundFrontBends)
{
    const auto round = [](float along, float) { return 0.5F * (along - 2.0F) * (along - 2.0F); };
    const Silhouette s = silhouetteOf(surface(round, always), false);
    EXPECT_GT(s.bend.value(), 0.15);
    EXPECT_NEAR(s.slope.value(), 0.0, 1e-3);
}

TEST(Silhouette, OfLeavesIsThickAndRagged)
{
    std::mt19937 random(5);
    std::normal_distribution<float> scatter(0.0F, 0.3F);
    std::bernoulli_distribution isLeaf(0.15);
    const auto leaf = [&](float, float) { return scatter(random); };
    const auto isThere = [&](float, float height) { return height < 0.8F || isLeaf(random); };
    const Silhouette s = silhouetteOf(surface(leaf, isThere), false);
    EXPECT_GT(s.thickness.value(), 0.2);
    EXPECT_GT(s.ragged.value(), 0.05);
}

TEST(Silhouette, OfPostsHasGaps)
{
    const auto isPost = [](float along, float) { return along < 0.2F || along > 3.8F; };
    const Silhouette s = silhouetteOf(surface(flat, isPost), false);
    EXPECT_NEAR(s.breadth, 3.9, 0.01);
    EXPECT_LT(s.coverage, 0.2);
}

TEST(Silhouette, OfALineScannerKnowsNoHeights)
{
    const Silhouette s = silhouetteOf(surface(flat, always), true);
    EXPECT_TRUE(s.thickness && s.bend);
    EXPECT_FALSE(s.slope || s.ragged);
}

TEST(Silhouette, OfOneHitTellsNothingThatNeedsMore)
{
    CanonicalHits hits;
    hits.x = hits.y = hits.z = {1.0F};
    hits.count = 1;
    for (const Eigen::Vector2d& sensor : {Eigen::Vector2d(-9.0, 1.0), Eigen::Vector2d(0.0, 0.0)})
    {
        hits.sensor = sensor;
        const Silhouette s = silhouetteOf(hits, false);
        EXPECT_EQ(s.breadth, 0.0);
        EXPECT_EQ(s.coverage, 1.0);
        EXPECT_FALSE(s.thickness || s.bend || s.slope || s.ragged);
    }
}
}  // namespace
}  // namespace vdamf
