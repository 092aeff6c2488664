// SPDX-License-Identifier: BSD-3-Clause
// The conventional tracker that ours is compared with does what its sources say.
#include <gtest/gtest.h>

#include "conventional/bicycle_filter.h"
#include "conventional/car_size.h"
#include "conventional/conventional_tracker.h"

namespace vdamf
{
namespace
{
TEST(BicycleFilter, JacobianIsTheDerivative)
{
    constexpr double kDt = 0.1, kRearAxle = 1.2, kStep = 1e-6;
    BicycleFilter::State state;
    state << 3.0, -2.0, 0.7, 8.0, 0.2;
    const BicycleFilter::Covariance f = BicycleFilter::jacobian(state, kDt, kRearAxle);
    for (int column = 0; column < 5; ++column)
    {
        BicycleFilter::State above = state, below = state;
        above(column) += kStep;
        below(column) -= kStep;
        const BicycleFilter::State slope = (BicycleFilter::next(above, kDt, kRearAxle) -
                                            BicycleFilter::next(below, kDt, kRearAxle)) /
                                           (2.0 * kStep);
        EXPECT_LT((f.col(column) - slope).cwiseAbs().maxCoeff(), 1e-7) << column;
    }
}

TEST(BicycleFilter, FindsTheSpeedOfACarThatTurns)
{
    constexpr double kDt = 0.1, kSpeed = 6.0, kYawRate = 0.2;
    const auto pose = [](double t)
    {
        const double heading = 0.3 + kYawRate * t;
        const double radius = kSpeed / kYawRate;
        return OrientedBox{radius * std::sin(heading), -radius * std::cos(heading), heading, 4.4,
                           1.8};
    };
    BicycleFilter filter(pose(0.0));
    for (int k = 1; k <= 80; ++k)
    {
        filter.predict(kDt);
        const OrientedBox seen = pose(k * kDt);
        // The axis has no direction.
        filter.update(seen.centre(), wrapAngle(seen.heading + (k % 2 == 0 ? kPi : 0.0)));
    }
    EXPECT_NEAR(filter.state()(3), kSpeed, 0.1);
    EXPECT_NEAR(filter.yawRate(), kYawRate, 0.05);
    EXPECT_NEAR(wrapAngle(filter.state()(2) - pose(8.0).heading), 0.0, 0.1);
}

TEST(BicycleFilter, TurnsRoundWhatSeemsToReverseFast)
{
    BicycleFilter filter({0.0, 0.0, kPi, 4.4, 1.8});
    for (int k = 1; k <= 20; ++k)
    {
        filter.predict(0.1);
        filter.update({0.8 * k, 0.0}, 0.0);
    }
    EXPECT_NEAR(filter.state()(3), 8.0, 0.3);
    EXPECT_NEAR(wrapAngle(filter.state()(2)), 0.0, 0.05);
}

TEST(CarSize, AnEndGrowsAwayFromTheSensor)
{
    const OrientedBox box = completedToACar({10.0, 0.0, 0.5 * kPi, 1.8, 0.3}, {0.0, 0.0});
    EXPECT_NEAR(std::remainder(box.heading, kPi), 0.0, 1e-12);
    EXPECT_NEAR(box.length, 4.4, 1e-12);
    EXPECT_NEAR(box.width, 1.8, 1e-12);
    EXPECT_NEAR(box.x - 0.5 * box.length, 9.85, 1e-12);  // the face seen stays
    EXPECT_NEAR(box.y, 0.0, 1e-12);
}

TEST(CarSize, ASideGrowsAwayFromTheSensor)
{
    const OrientedBox box = completedToACar({0.0, -5.0, 0.0, 4.0, 0.2}, {0.0, 0.0});
    EXPECT_NEAR(box.length, 4.0, 1e-12);
    EXPECT_NEAR(box.width, 1.85, 1e-12);
    EXPECT_NEAR(box.y + 0.5 * box.width, -4.9, 1e-12);
}

TEST(CarSize, WhatIsWholeOrNoCarStays)
{
    for (const OrientedBox& whole :
         {OrientedBox{8.0, 6.0, 0.1, 4.6, 1.9}, OrientedBox{8.0, 6.0, 0.1, 11.0, 2.6},
          OrientedBox{8.0, 6.0, 0.1, 0.5, 0.4}})
    {
        const OrientedBox box = completedToACar(whole, {0.0, 0.0});
        EXPECT_EQ(box.length, whole.length);
        EXPECT_EQ(box.width, whole.width);
        EXPECT_EQ(box.x, whole.x);
    }
}

// Hits on the rear and on the right side of a box, as a line scanner at the origin sees them.
LadarFrame frameOf(const OrientedBox& car, double time)
{
    LadarFrame frame;
    frame.time = time;
    frame.planar = true;
    const auto add = [&](double along, double across)
    {
        const Eigen::Vector2d p =
            car.centre() + rotation(car.heading) * Eigen::Vector2d(along, across);
        frame.points.x.push_back(static_cast<float>(p.x()));
        frame.points.y.push_back(static_cast<float>(p.y()));
        frame.points.z.push_back(0.0F);
    };
    for (double y = -0.5 * car.width; y < 0.5 * car.width; y += 0.05) add(-0.5 * car.length, y);
    for (double x = -0.5 * car.length; x < 0.5 * car.length; x += 0.1) add(x, -0.5 * car.width);
    return frame;
}

TEST(ConventionalTracker, FollowsACarAsOne)
{
    ConventionalTracker tracker({});
    FrameResult result;
    const auto carAt = [](double t) { return OrientedBox{8.0 + 7.0 * t, 4.0, 0.0, 4.4, 1.8}; };
    for (int k = 0; k <= 30; ++k) result = tracker.process(frameOf(carAt(0.1 * k), 0.1 * k));
    ASSERT_EQ(result.tracks.size(), 1U);
    const TrackReport& track = result.tracks.front();
    EXPECT_EQ(track.id, 1U);
    EXPECT_EQ(track.status, TrackStatus::Confirmed);
    EXPECT_NEAR(track.speed, 7.0, 0.2);
    EXPECT_NEAR(track.box.x, carAt(3.0).x, 0.1);
    EXPECT_NEAR(track.box.y, 4.0, 0.1);

    LadarFrame empty;
    empty.planar = true;
    for (const double after : {0.5, 1.0})
    {
        empty.time = 3.0 + after;
        result = tracker.process(empty);
        ASSERT_EQ(result.tracks.size(), 1U);
        EXPECT_EQ(result.tracks.front().status,
                  after < 1.0 ? TrackStatus::Coasting : TrackStatus::Ended);
    }
}

}  // namespace
}  // namespace vdamf
