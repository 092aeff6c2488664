// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/ground.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tracking/preprocessing/made_scan.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
namespace
{
using test::Block;
using test::Landscape;
using test::MadeScan;

constexpr double kNoCheck = std::numeric_limits<double>::infinity();

/// How well a made scan was told apart.
struct Outcome
{
    double groundRemoved = 0.0;  ///< share of the hits on the landscape
    double bodyKept = 0.0;       ///< share of the hits on blocks, 0.4 to 2.5 m over the landscape
    double worstHeight = 0.0;    ///< 95th percentile of the error of their height, m
};

Outcome judge(const MadeScan& scan, const AboveGround& above)
{
    std::vector<float> height(scan.frame.points.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t k = 0; k < above.index.size(); ++k) height[above.index[k]] = above.height[k];
    double ground = 0.0;
    double removed = 0.0;
    double body = 0.0;
    std::vector<double> errors;
    for (std::size_t i = 0; i < height.size(); ++i)
    {
        const bool kept = !std::isnan(height[i]);
        if (scan.block[i] < 0)
        {
            ground += 1.0;
            removed += kept ? 0.0 : 1.0;
        }
        else if (scan.height[i] > 0.4 && scan.height[i] < 2.5)
        {
            body += 1.0;
            if (kept) errors.push_back(std::abs(height[i] - scan.height[i]));
        }
    }
    std::sort(errors.begin(), errors.end());
    const double worst = errors.empty() ? kNoCheck : errors[errors.size() * 95 / 100];
    return {removed / ground, static_cast<double>(errors.size()) / body, worst};
}

void expectGood(const MadeScan& scan, double groundRemoved, double bodyKept, double worstHeight)
{
    const Outcome o = judge(scan, removeGround(scan.frame, {}));
    EXPECT_GT(o.groundRemoved, groundRemoved);
    EXPECT_GT(o.bodyKept, bodyKept);
    EXPECT_LT(o.worstHeight, worstHeight);
}

TEST(RemoveGround, TellsCarsFromFlatGroundWithAnySensorHeight)
{
    const Landscape flat{[](double, double) { return 0.0; }, test::parkedCars()};
    for (const double height : {0.6, 1.2, 1.73, 2.6, 3.8})
    {
        SCOPED_TRACE(height);
        expectGood(test::scan(flat, test::kHdl64e, height), 0.999, 0.99, 0.15);
    }
}

TEST(RemoveGround, WorksWithSparseSensors)
{
    const Landscape flat{[](double, double) { return 0.0; }, test::parkedCars()};
    expectGood(test::scan(flat, test::kHdl32e, 1.9), 0.999, 0.99, 0.15);
    expectGood(test::scan(flat, test::kVlp16, 1.6), 0.999, 0.97, 0.15);
}

TEST(RemoveGround, FollowsSlopes)
{
    for (const double direction : {0.0, 0.8, 2.5})
    {
        SCOPED_TRACE(direction);
        const auto slope = [direction](double x, double y)
        { return 0.15 * (std::cos(direction) * x + std::sin(direction) * y); };
        const Landscape scene{slope, test::parkedCars()};
        expectGood(test::scan(scene, test::kHdl64e, 1.73), 0.995, 0.97, 0.2);
        expectGood(test::scan(scene, test::kHdl32e, 1.73), 0.995, 0.97, 0.2);
    }
}

TEST(RemoveGround, KerbsVanish)
{
    const auto pavement = [](double, double y) { return std::abs(y) > 4.0 ? 0.15 : 0.0; };
    const Landscape street{pavement, {{{12.0, 3.0, 0.0, 4.5, 1.8}}, {{-9.0, -3.0, 0.0, 4.5, 1.8}}}};
    expectGood(test::scan(street, test::kHdl64e, 1.73), 0.998, 0.99, 0.2);
}

TEST(RemoveGround, FollowsAHumpAndAHollow)
{
    for (const double size : {0.8, -0.8})
    {
        SCOPED_TRACE(size);
        const auto hump = [size](double x, double)
        {
            return std::abs(x - 25.0) > 15.0
                       ? 0.0
                       : 0.5 * size * (1.0 + std::cos(kPi * (x - 25.0) / 15.0));
        };
        const Landscape scene{hump, {{{24.0, 4.0, 0.0, 4.5, 1.8}}, {{16.0, -5.0, 0.0, 4.5, 1.8}}}};
        expectGood(test::scan(scene, test::kHdl64e, 1.73), 0.98, 0.97, 0.2);
    }
}

TEST(RemoveGround, DropsWhatIsOverheadAndKeepsWhatIsBelowIt)
{
    Landscape scene;
    scene.blocks = {{{20.0, 0.0, 0.0, 10.0, 60.0}, 4.5, 6.0},  // a bridge
                    {{-15.0, 0.0, 0.0, 6.0, 6.0}, 3.3, 5.0},   // the crown of a tree
                    {{20.0, 3.0, 0.0, 4.5, 1.8}, 0.0, 1.5}};   // a car below the bridge
    const MadeScan scan = test::scan(scene, test::kHdl64e, 1.73);
    const AboveGround above = removeGround(scan.frame, {});
    std::vector<std::size_t> kept(3, 0);
    for (const std::uint32_t i : above.index)
        if (scan.block[i] >= 0) ++kept[static_cast<std::size_t>(scan.block[i])];
    EXPECT_EQ(kept[0], 0U);
    EXPECT_EQ(kept[1], 0U);
    EXPECT_GT(kept[2], 200U);
    EXPECT_GT(judge(scan, above).groundRemoved, 0.999);
}

TEST(RemoveGround, IsNotDrawnDownByHitsUnderTheGround)
{
    MadeScan scan =
        test::scan({[](double, double) { return 0.0; }, test::parkedCars()}, test::kHdl64e, 1.73);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> depth(0.5F, 3.0F);
    PointCloud& points = scan.frame.points;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; i += 40)
    {
        points.x.push_back(points.x[i]);
        points.y.push_back(points.y[i]);
        points.z.push_back(-1.0F - depth(random));
        scan.block.push_back(-1);
        scan.height.push_back(-1.0);
    }
    expectGood(scan, 0.998, 0.98, 0.2);
}

TEST(RemoveGround, NoGroundInTheFrameKeepsAllHits)
{
    // A line scanner, level and tilted by 3 degrees: one circle, which lies in a plane as well.
    for (const double tilt : {0.0, 0.05})
    {
        LadarFrame frame;
        frame.sensor = {0.0, 0.0, 5.0};
        for (int i = 0; i < 360; ++i)
        {
            const double x = 20.0 * std::cos(i * kPi / 180.0);
            frame.points.x.push_back(static_cast<float>(x));
            frame.points.y.push_back(static_cast<float>(20.0 * std::sin(i * kPi / 180.0)));
            frame.points.z.push_back(static_cast<float>(5.0 + tilt * x));
        }
        const AboveGround above = removeGround(frame, {});
        ASSERT_EQ(above.index.size(), 360U) << tilt;
        EXPECT_NEAR(above.height[0], 1.7 + tilt * 20.0, 1e-3);
        EXPECT_NEAR(above.height[180], 1.7 - tilt * 20.0, 1e-3);
    }
}

TEST(RemoveGround, EmptyFrameAndSingleHit)
{
    LadarFrame frame;
    EXPECT_TRUE(removeGround(frame, {}).index.empty());
    frame.points.x = {10.0F};
    frame.points.y = {1.0F};
    frame.points.z = {-0.5F};
    const AboveGround above = removeGround(frame, {});
    EXPECT_THAT(above.index, testing::ElementsAre(0U));
    EXPECT_THAT(above.height, testing::ElementsAre(testing::FloatNear(1.2F, 1e-5F)));
}

TEST(RemoveGround, DropsHitsThatAreNotFiniteOrOutOfRange)
{
    MadeScan scan = test::scan({[](double, double) { return 0.0; }, {{{10.0, 0.0, 0.3, 4.0, 2.0}}}},
                               test::kHdl64e, 1.73);
    const AboveGround before = removeGround(scan.frame, {});
    PointCloud& points = scan.frame.points;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity, 3e38F, -3e38F})
        for (int axis = 0; axis < 3; ++axis)
        {
            points.x.push_back(axis == 0 ? bad : 10.0F);
            points.y.push_back(axis == 1 ? bad : 3.0F);
            points.z.push_back(axis == 2 ? bad : -0.5F);
        }
    points.x.insert(points.x.end(), {-3.0F + 0.5F, -3.0F + 90.0F});
    points.y.insert(points.y.end(), {2.0F, 2.0F});
    points.z.insert(points.z.end(), {0.0F, 0.0F});
    const AboveGround after = removeGround(scan.frame, {});
    EXPECT_EQ(after.index, before.index);
    EXPECT_EQ(after.height, before.height);
}

TEST(RemoveGround, DropsHitsWhoseTimesAreNotFinite)
{
    LadarFrame frame;
    frame.planar = true;
    frame.points.x = {5.0F, 5.0F, 5.0F, 5.0F};
    frame.points.y = {1.0F, 2.0F, 3.0F, 4.0F};
    frame.points.z = {0.0F, 0.0F, 0.0F, 0.0F};
    EXPECT_EQ(removeGround(frame, {}).index.size(), 4U);
    frame.points.time = {0.0F, std::numeric_limits<float>::quiet_NaN(), -0.05F,
                         std::numeric_limits<float>::infinity()};
    EXPECT_THAT(removeGround(frame, {}).index, testing::ElementsAre(0U, 2U));
}

TEST(RemoveGround, KeepsTheOrderOfTheFrame)
{
    const MadeScan scan =
        test::scan({[](double, double) { return 0.0; }, test::parkedCars()}, test::kVlp16, 1.7);
    const AboveGround above = removeGround(scan.frame, {});
    ASSERT_EQ(above.index.size(), above.height.size());
    EXPECT_GT(above.index.size(), 100U);
    EXPECT_EQ(std::adjacent_find(above.index.begin(), above.index.end(), std::greater_equal<>()),
              above.index.end());
    const GroundOptions defaults;
    for (const float height : above.height)
    {
        EXPECT_GE(height, static_cast<float>(defaults.minHeight));
        EXPECT_LE(height, static_cast<float>(defaults.maxHeight));
    }
}

TEST(GroundOptions, NamesWhatIsOutOfRange)
{
    EXPECT_TRUE(problemsOf(GroundOptions{}).empty());
    GroundOptions options;
    options.minHeight = -0.1;
    options.maxRange = 1e6;
    EXPECT_THAT(problemsOf(options),
                testing::ElementsAre(testing::HasSubstr("max_range_m = 1e+06"),
                                     testing::HasSubstr("min_height_m = -0.1")));
}

}  // namespace
}  // namespace vdamf
