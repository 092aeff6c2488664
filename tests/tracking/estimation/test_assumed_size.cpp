// SPDX-License-Identifier: BSD-3-Clause
// What is assumed of a length that is not seen, and how it follows what becomes known.
#include "vdamf/tracking/estimation/assumed_size.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracking/estimation/measured_vehicles.h"
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

// Of a normal distribution about 9.5 m, 2 m wide, without what is shorter than `seen`.
AssumedSize byQuadrature(double seen)
{
    constexpr double kStep = 1e-3;  // m
    double share = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (double length = seen + 0.5 * kStep; length < 30.0; length += kStep)
    {
        const double density = std::exp(-0.5 * std::pow((length - 9.5) / 2.0, 2));
        share += density;
        sum += density * length;
        squares += density * length * length;
    }
    const double mean = sum / share;
    return {mean, std::sqrt(squares / share - mean * mean)};
}

TEST(AssumedSize, TrucksGoOnOutOfSightAsFarAsThoseDoThatAreLonger)
{
    for (const double seen : {6.6, 8.0, 9.5, 12.0, 16.0})
    {
        const auto whole = lengthOfMoreThan(seen, 2.8);
        ASSERT_TRUE(whole) << seen;
        const AssumedSize expected = byQuadrature(seen);
        EXPECT_NEAR(whole->metres, expected.metres, 1e-4) << seen;
        EXPECT_NEAR(whole->sigma, expected.sigma, 1e-3) << seen;
    }
    const auto tram = lengthOfMoreThan(25.0, 2.8);
    ASSERT_TRUE(tram);
    EXPECT_GE(tram->metres, 25.0);
    EXPECT_LT(tram->metres, 26.0);
    EXPECT_GT(tram->sigma, 0.1);
    EXPECT_FALSE(lengthOfMoreThan(6.0, 2.2)) << "a van";
    EXPECT_FALSE(lengthOfMoreThan(8.0, 1.5)) << "two cars";
}

TEST(AssumedSize, TrucksBeyondAllLengthsAreNoLessCertain)
{
    double before = lengthOfMoreThan(17.0, 3.0)->sigma;
    for (double seen = 17.1; seen < 30.0; seen += 0.1)
    {
        const AssumedSize size = *lengthOfMoreThan(seen, 3.0);
        EXPECT_LE(size.sigma, 1.02 * before) << seen;
        EXPECT_GE(size.metres, seen) << seen;
        before = size.sigma;
    }
}

TEST(GoingOnOutOfSight, TheEndSeenStaysAndTheOtherOneGoesOn)
{
    Measurement m = measured({16.0, 5.0, 0.0, 8.0, 2.5}, faces({Face::Right}));
    m.hiddenEnds.add(Face::Back);
    const VehicleState before = known(m.box, 0.5);
    const AssumedSize whole = lengthOfMoreThan(8.0, 2.8).value();
    const VehicleState after = goingOnOutOfSight(before, m, whole);
    EXPECT_NEAR(after.mean(kLength), whole.metres, 1e-9);
    EXPECT_NEAR(after.mean(kX) + 0.5 * after.mean(kLength), 20.0, 1e-9);
    EXPECT_NEAR(after.covariance(kLength, kLength), whole.sigma * whole.sigma, 1e-9);
    // What is not hidden at either end, or at both, tells its length or nothing at all.
    m.hiddenEnds.add(Face::Front);
    EXPECT_EQ(goingOnOutOfSight(before, m, whole).mean, before.mean);
    m.hiddenEnds = {};
    EXPECT_EQ(goingOnOutOfSight(before, m, whole).mean, before.mean);
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
