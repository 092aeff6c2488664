// SPDX-License-Identifier: BSD-3-Clause
// What is assumed of a length that is not seen, and how it follows what becomes known.
#include "vdamf/tracking/estimation/assumed_size.h"

#include <gtest/gtest.h>

#include "vdamf/tracking/estimation/start_state.h"

namespace vdamf
{
namespace
{
const VisibilityOptions kVisibility;

TEST(AssumedSize, VansAreLongerAndLessCertainThanCars)
{
    const AssumedSize car = carLength(1.5, std::nullopt, kVisibility);
    const AssumedSize van = carLength(2.1, std::nullopt, kVisibility);
    EXPECT_DOUBLE_EQ(car.metres, kVisibility.carLength);
    EXPECT_NEAR(van.metres, 5.0, 0.15);
    EXPECT_GT(van.sigma, 1.2 * car.sigma);
    // A high car is none yet.
    EXPECT_NEAR(carLength(1.7, 1.85, kVisibility).metres, carLength(1.45, 1.85, kVisibility).metres,
                1e-9);
}

TEST(AssumedSize, WideCarsAreLongerThanNarrowOnes)
{
    const double narrow = carLength(1.5, 1.7, kVisibility).metres;
    const double wide = carLength(1.5, 2.0, kVisibility).metres;
    EXPECT_NEAR(wide - narrow, 0.27, 0.05);
    // What is seen of an end may be a part of it.
    EXPECT_GT(carLength(1.5, 1.0, kVisibility).metres, 3.8);
}

VehicleState carAhead(double lengthSigma)
{
    VehicleState state;
    state.mean << 20.0, 1.0, 0.0, 8.0, 0.0, 0.4, 4.3;
    state.covariance.diagonal().setConstant(0.01);
    state.covariance(kLength, kLength) = lengthSigma * lengthSigma;
    return state;
}

TEST(WithLengthAssumed, TheEndSeenStays)
{
    const VehicleState before = carAhead(0.45);
    const VehicleState after = withLengthAssumed(before, {4.3, 0.45}, {5.0, 0.6}, -1.0);
    EXPECT_NEAR(after.mean(kLength), 5.0, 1e-9);
    EXPECT_NEAR(after.mean(kX), 20.35, 1e-9);
    EXPECT_NEAR(after.covariance(kLength, kLength), 0.6 * 0.6, 1e-9);
    // The rear is known as well as before.
    StateVector rear = StateVector::Zero();
    rear(kX) = 1.0;
    rear(kLength) = -0.5;
    EXPECT_NEAR(rear.dot(after.covariance * rear), rear.dot(before.covariance * rear), 1e-9);
}

TEST(WithLengthAssumed, WhatIsKnownBetterHardlyMoves)
{
    const VehicleState after = withLengthAssumed(carAhead(0.1), {4.3, 0.45}, {5.0, 0.6}, -1.0);
    EXPECT_LT(after.mean(kLength), 4.35);
    EXPECT_LT(after.covariance(kLength, kLength), 0.011);
}

}  // namespace
}  // namespace vdamf
