// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/platform_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
constexpr double kFrameTime = 0.1;  // s
constexpr double kPointError = 0.03;
constexpr double kPointTurn = 0.02;
const std::vector<Eigen::Vector2d> kStandingAt{{8.0, -4.0}, {15.0, -4.0}, {22.0, -4.0},
                                               {12.0, 5.0}, {-9.0, 4.0},  {-20.0, -5.0}};
const PlaneMotion kCommon{0.004, {0.08, -0.05}};
const Eigen::Vector3d kAnyMotion(1.0, 1.0, 1.0);

// What is parked, seen after everything moved, with errors as large as the covariance says.
std::vector<StandingPoint> seenAfterMotion(const PlaneMotion& motion, std::mt19937& random)
{
    std::normal_distribution<double> gauss;
    std::vector<StandingPoint> points;
    for (const Eigen::Vector2d& place : kStandingAt)
    {
        StandingPoint point;
        point.at = motion.of(place);
        point.innovation.covariance =
            Eigen::Vector3d(kPointError * kPointError, kPointError * kPointError,
                            kPointTurn * kPointTurn)
                .asDiagonal();
        point.innovation.value.head<2>() =
            point.at - place + kPointError * Eigen::Vector2d(gauss(random), gauss(random));
        point.innovation.value(2) = motion.turn + kPointTurn * gauss(random);
        points.push_back(point);
    }
    return points;
}

Eigen::Vector3d errorOfMotion(const EstimatedMotion& found, const PlaneMotion& motion)
{
    Eigen::Vector3d error;
    error << found.motion.shift - motion.shift, found.motion.turn - motion.turn;
    return error;
}

TEST(CommonMotion, ErrsAsItsCovarianceSays)
{
    constexpr int kRuns = 2000;
    std::mt19937 random(3);
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d told = Eigen::Matrix3d::Zero();
    for (int run = 0; run < kRuns; ++run)
    {
        const EstimatedMotion found = commonMotion(seenAfterMotion(kCommon, random), kAnyMotion);
        const Eigen::Vector3d error = errorOfMotion(found, kCommon);
        scatter += error * error.transpose() / kRuns;
        told += found.covariance / kRuns;
    }
    for (Eigen::Index k = 0; k < 3; ++k)
        EXPECT_NEAR(std::sqrt(scatter(k, k)), std::sqrt(told(k, k)), 0.15 * std::sqrt(told(k, k)));
}

TEST(CommonMotion, LeavesOutWhatSetsOff)
{
    std::mt19937 random(4);
    std::vector<StandingPoint> points = seenAfterMotion(kCommon, random);
    const EstimatedMotion before = commonMotion(points, kAnyMotion);
    points[2].innovation.value.x() += 1.0;
    const EstimatedMotion after = commonMotion(points, kAnyMotion);
    EXPECT_LT((after.motion.shift - before.motion.shift).norm(), 0.02);
    EXPECT_NEAR(after.motion.turn, before.motion.turn, 0.002);
}

TEST(CommonMotion, StaysWithinWhatIsKnownBeforehand)
{
    std::mt19937 random(5);
    const Eigen::Vector3d sure(1e-8, 1e-8, 1e-10);
    const EstimatedMotion found = commonMotion(seenAfterMotion(kCommon, random), sure);
    EXPECT_LT(found.motion.shift.norm(), 0.001);
    EXPECT_LT(std::abs(found.motion.turn), 1e-4);
    const EstimatedMotion nothing = commonMotion({}, sure);
    EXPECT_EQ(nothing.motion.shift.norm(), 0.0);
    EXPECT_NEAR(nothing.covariance(0, 0), 1e-8, 1e-12);
}

TEST(PlatformErrors, OfAGoodInsAreNone)
{
    std::mt19937 random(6);
    PlatformErrors errors{AlignmentOptions()};
    for (int frame = 0; frame < 300; ++frame)
        ASSERT_FALSE(errors.after(seenAfterMotion({}, random), kFrameTime)) << frame;
}

TEST(PlatformErrors, AreToldOnceTheyHaveShown)
{
    std::mt19937 random(7);
    std::normal_distribution<double> gauss;
    PlatformErrors errors{AlignmentOptions()};
    int told = 0;
    double square = 0.0;
    for (int frame = 0; frame < 100; ++frame)
    {
        const PlaneMotion motion{0.003 * gauss(random),
                                 0.1 * Eigen::Vector2d(gauss(random), gauss(random))};
        const auto found = errors.after(seenAfterMotion(motion, random), kFrameTime);
        if (!found) continue;
        ++told;
        square += squaredMahalanobis(errorOfMotion(*found, motion), found->covariance);
    }
    EXPECT_GT(told, 95);
    EXPECT_NEAR(square / (3.0 * told), 1.0, 0.3);
    EXPECT_NEAR(std::sqrt(errors.variances()(0)), 0.1, 0.03);
    EXPECT_NEAR(std::sqrt(errors.variances()(2)), 0.003, 0.0015);
}

// What stands would seem to drive until they are.
TEST(PlatformErrors, AreToldInTheFirstFrameThatShowsThem)
{
    std::mt19937 random(12);
    PlatformErrors errors{AlignmentOptions()};
    const PlaneMotion jump{0.0, {0.15, 0.1}};
    const auto found = errors.after(seenAfterMotion(jump, random), kFrameTime);
    ASSERT_TRUE(found);
    EXPECT_LT((found->motion.shift - jump.shift).norm(), 0.05);
}

TEST(PlatformErrors, AreForgottenWhileNothingTellsOfThem)
{
    std::mt19937 random(9);
    std::normal_distribution<double> gauss;
    PlatformErrors errors{AlignmentOptions()};
    const auto jitter = [&] {
        return PlaneMotion{0.0, 0.1 * Eigen::Vector2d(gauss(random), gauss(random))};
    };
    for (int frame = 0; frame < 10; ++frame)
        errors.after(seenAfterMotion(jitter(), random), kFrameTime);
    ASSERT_TRUE(errors.after({}, kFrameTime)) << "one frame without anything";
    for (int frame = 0; frame < 200; ++frame) errors.after({}, kFrameTime);
    EXPECT_FALSE(errors.after({}, kFrameTime));
    EXPECT_LT(errors.variances()(0), 0.02 * 0.02);
}

TEST(PlatformErrors, OfTheHeadingAloneAreToldToo)
{
    std::mt19937 random(8);
    std::normal_distribution<double> gauss;
    PlatformErrors errors{AlignmentOptions()};
    PlaneMotion turned;
    for (int frame = 0; frame < 10; ++frame)
    {
        turned.turn = 0.006 * gauss(random);
        errors.after(seenAfterMotion(turned, random), kFrameTime);
    }
    turned.turn = 0.006;
    const auto found = errors.after(seenAfterMotion(turned, random), kFrameTime);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->motion.turn, turned.turn, 0.003);
}

TEST(PlatformErrors, TakeMoreThanOneThingThatStands)
{
    std::mt19937 random(9);
    PlatformErrors errors{AlignmentOptions()};
    for (int frame = 0; frame < 50; ++frame)
    {
        std::vector<StandingPoint> one = seenAfterMotion({0.0, {0.3, 0.0}}, random);
        one.resize(1);
        ASSERT_FALSE(errors.after(one, kFrameTime));
    }
}

TEST(PlatformErrors, TakeMoreThanOneThingThatIsSeenWell)
{
    std::mt19937 random(10);
    PlatformErrors errors{AlignmentOptions()};
    for (int frame = 0; frame < 50; ++frame)
    {
        std::vector<StandingPoint> points = seenAfterMotion({0.0, {0.3, 0.0}}, random);
        for (std::size_t i = 1; i < points.size(); ++i) points[i].innovation.covariance *= 900.0;
        ASSERT_FALSE(errors.after(points, kFrameTime));
    }
}

}  // namespace
}  // namespace vdamf
