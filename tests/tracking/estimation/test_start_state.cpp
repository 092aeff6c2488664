// SPDX-License-Identifier: BSD-3-Clause
// What is known of a vehicle that was seen once, and what its speed says of its path.
#include "vdamf/tracking/estimation/start_state.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
// Seems to turn with 0.05 1/m; its heading errs along with that.
VehicleState seenTwice(double speed)
{
    VehicleState state;
    state.mean << 0.0, 0.0, 3.1, speed, 0.05, 1.2, 4.5;
    state.covariance.diagonal() << 0.01, 0.01, 4e-4, 0.25, 2.5e-3, 0.2, 0.05;
    state.covariance(kHeading, kCurvature) = state.covariance(kCurvature, kHeading) = -5e-4;
    return state;
}

TEST(StartState, WhatIsFastHardlyTurns)
{
    const VehicleState before = seenTwice(20.0);
    const VehicleState state = withUsualCurvature(before);
    // 2 m/s^2 over 400 m^2/s^2, and no surer of it than that.
    EXPECT_LT(std::abs(state.mean(kCurvature)), 0.001);
    EXPECT_NEAR(std::sqrt(state.covariance(kCurvature, kCurvature)), 0.005, 1e-4);
    // What went with it follows.
    EXPECT_GT(state.mean(kHeading), 3.105);
    EXPECT_LT(state.covariance(kHeading, kHeading), before.covariance(kHeading, kHeading));
    EXPECT_DOUBLE_EQ(state.mean(kSpeed), 20.0);
}

TEST(StartState, WhatIsSlowMayTurn)
{
    const VehicleState state = withUsualCurvature(seenTwice(6.0));
    EXPECT_DOUBLE_EQ(state.mean(kCurvature), 0.05);
    VehicleState free = seenTwice(20.0);
    free.steering = Steering::Independent;
    EXPECT_EQ(withUsualCurvature(free).mean, free.mean);
}

Measurement rearOf(double width)
{
    Measurement m;
    m.box = {20.0, 0.0, 0.0, 1.0, width};
    m.covariance = (Vector5d() << 1e-4, 1e-4, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
    m.facesSeen.add(Face::Back);
    m.hits = 60;
    return m;
}

double lengthBehind(double width, double height)
{
    return startState(rearOf(width), height, {0.0, 0.0}, {}, {}, {}).mean(kLength);
}

TEST(StartState, WhatIsHigherThanAnyCarIsATruckThoughItSeemsNarrow)
{
    EXPECT_NEAR(lengthBehind(2.2, 1.6), VisibilityOptions().carLength, 0.2);
    EXPECT_GT(lengthBehind(2.2, 3.0), 7.0);
    EXPECT_GT(lengthBehind(2.45, 2.2), 7.0);
    EXPECT_LT(lengthBehind(1.9, 3.0), 6.0) << "a van";
}

// Half of a car's rear shows beside what hides the rest of it; where it was first seen, hardly any.
TEST(GrownToAVehicle, WhatHidesAPartOfAnEndHidesAWholeCar)
{
    const VisibilityOptions o;
    Measurement piece = rearOf(1.2);
    piece.hiddenEnds.add(Face::Left);
    VehicleState small;
    small.mean << 20.0, 0.0, 0.0, 0.0, 0.0, 0.4, 0.9;
    small.width = 0.9;
    const VehicleState grown = grownToAVehicle(small, piece, 1.5, SizesTold(), o);
    EXPECT_DOUBLE_EQ(grown.mean(kLength), o.carLength);
    EXPECT_DOUBLE_EQ(grown.width, o.carWidth);
    // Rear and right side stay.
    EXPECT_NEAR(grown.mean(kX) - 0.5 * grown.mean(kLength), 20.0 - 0.45, 1e-9);
    EXPECT_NEAR(grown.mean(kY) - 0.5 * grown.width, -0.45, 1e-9);

    // A part of the side beside it tells no length either.
    piece.facesSeen.add(Face::Right);
    piece.hiddenEnds.add(Face::Front);
    EXPECT_EQ(grownToAVehicle(small, piece, 1.5, SizesTold(), o).mean, grown.mean);
    // Of what is too wide for a car all of an end has to have been seen: hits beyond it make no
    // truck.
    piece.box.width = small.width = 2.4;
    EXPECT_EQ(grownToAVehicle(small, piece, 3.0, SizesTold(), o).mean, small.mean);
    EXPECT_GT(grownToAVehicle(small, piece, 3.0, {false, true}, o).mean(kLength), 7.0);
    small.width = 0.9;
    // All of an end as narrow is none of a car.
    EXPECT_EQ(grownToAVehicle(small, rearOf(1.2), 1.5, SizesTold(), o).mean, small.mean);
}

// The first bit of a car behind another one is no larger than a motorcycle.
TEST(GrownAsJudged, WhatIsKnownToBeAVehicleIsNoSmallerThanACar)
{
    const VisibilityOptions o;
    VehicleState small;
    small.mean << 20.0, 0.0, 0.0, 0.0, 0.0, 0.4, 1.6;
    small.width = 0.9;
    Measurement bit = rearOf(0.9);
    bit.hiddenEnds.add(Face::Left);
    const VehicleState grown = grownAsJudged(small, bit, 1.5, SizesTold(), o);
    EXPECT_NEAR(grown.mean(kLength), o.carLength, 0.1);
    EXPECT_DOUBLE_EQ(grown.width, o.carWidth);
    // Rear and right side stay.
    EXPECT_NEAR(grown.mean(kX) - 0.5 * grown.mean(kLength), 20.0 - 0.8, 1e-9);
    EXPECT_NEAR(grown.mean(kY) - 0.5 * grown.width, -0.45, 1e-9);

    EXPECT_EQ(grownAsJudged(small, bit, 1.5, {true, true}, o).mean, small.mean);
    VehicleState truck = small;
    truck.width = 3.0;
    EXPECT_GT(grownAsJudged(truck, rearOf(3.0), 3.0, {false, true}, o).mean(kLength), 7.0);
    bit.facesSeen = FaceSet();
    EXPECT_EQ(grownAsJudged(small, bit, 1.5, SizesTold(), o).mean, small.mean);
}

// A slice of something between two others: it may go on behind them.
TEST(StartState, OfASliceTheLengthIsAsOpenAsAVehicles)
{
    Measurement slice = rearOf(0.6);
    slice.hiddenEnds.add(Face::Left);
    slice.hiddenEnds.add(Face::Right);
    const VehicleState state = startState(slice, 1.5, {0.0, 0.0}, {}, {}, {});
    EXPECT_GT(std::sqrt(state.covariance(kLength, kLength)), 1.2);
    EXPECT_LT(std::sqrt(state.widthVariance), 0.8);
    // The place of the end that is seen is known all the same.
    StateVector rear = StateVector::Zero();
    rear(kX) = 1.0;
    rear(kLength) = -0.5;
    EXPECT_LT(rear.dot(state.covariance * rear), 0.1 * 0.1);
}

}  // namespace
}  // namespace vdamf
