// SPDX-License-Identifier: BSD-3-Clause
// What is known of a vehicle that was seen once, and what its speed says of its path.
#include "vdamf/tracking/estimation/start_state.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tracking/estimation/measured_vehicles.h"
#include "vdamf/tracking/estimation/visibility.h"

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

TEST(StartState, WhatTurnedUntilItsSpeedWasKnownGoesOnTurning)
{
    // By 0.06 rad in 0.1 s at 6 m/s: 0.1 1/m.
    VehicleState before = seenTwice(6.0);
    before.covariance(kSpeed, kSpeed) = 1e-10;
    const VehicleState sure = withTurnShown(before, {0.06, 1e-8, 0.1});
    EXPECT_NEAR(sure.mean(kCurvature), 0.1, 1e-4);
    EXPECT_NEAR(sure.yawRate(), 0.6, 1e-3);
    EXPECT_LT(sure.mean(kHeading), before.mean(kHeading)) << "it erred along with that";
    // As sure as the turn divided by the way: 0.03 rad over 0.6 m is what is known already.
    const VehicleState vague = withTurnShown(before, {0.06, 0.03 * 0.03, 0.1});
    EXPECT_NEAR(vague.mean(kCurvature), 0.075, 1e-9);
    EXPECT_NEAR(vague.covariance(kCurvature, kCurvature),
                0.5 * before.covariance(kCurvature, kCurvature), 1e-9);
    EXPECT_GT(vague.covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
    EXPECT_DOUBLE_EQ(vague.mean(kSpeed), 6.0);
    // A speed of 6 +- 3 m/s leaves half of the turn open, and a way back is the same path.
    before.covariance(kSpeed, kSpeed) = 9.0;
    EXPECT_NEAR(withTurnShown(before, {0.06, 1e-12, 0.1}).mean(kCurvature), 0.075, 1e-6);
    before.covariance(kSpeed, kSpeed) = 1e-10;
    before.mean(kSpeed) = -6.0;
    EXPECT_NEAR(withTurnShown(before, {-0.06, 1e-8, 0.1}).mean(kCurvature), 0.1, 1e-4);
}

TEST(StartState, TurnsTooSharpToBeTrueTellNothing)
{
    const VehicleState before = seenTwice(3.0);
    // 0.8 1/m, of which 0.05 +- 0.05 was known.
    EXPECT_EQ(withTurnShown(before, {0.25, 5e-5, 0.1}).mean, before.mean);
}

TEST(StartState, TurnsOfWhatStandsOrSteersFreelyTellNoCurvature)
{
    const VehicleState stands = seenTwice(0.0);
    EXPECT_EQ(withTurnShown(stands, {0.06, 1e-4, 0.1}).mean, stands.mean);
    VehicleState free = seenTwice(6.0);
    free.steering = Steering::Independent;
    EXPECT_EQ(withTurnShown(free, {0.06, 1e-4, 0.1}).mean, free.mean);
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

// Of a car between two others the first metres of its side show, and seem to be all of it.
TEST(GrownAsJudged, WhatIsAsWideAsACarIsNotShorterThanAny)
{
    const VisibilityOptions o;
    VehicleState piece;
    piece.mean << 20.0, 0.0, 0.0, 0.0, 0.0, 0.4, 1.8;
    piece.width = 1.7;
    const VehicleState grown = grownAsJudged(piece, rearOf(1.7), 1.5, {true, true}, o);
    EXPECT_NEAR(grown.mean(kLength), o.carLength, 0.1);
    EXPECT_GT(std::sqrt(grown.covariance(kLength, kLength)), 0.9 * o.carLengthSigma);
    EXPECT_NEAR(grown.mean(kX) - 0.5 * grown.mean(kLength), 20.0 - 0.9, 1e-9) << "the rear stays";

    piece.mean(kLength) = 2.6;
    EXPECT_EQ(grownAsJudged(piece, rearOf(1.7), 1.5, {true, true}, o).mean, piece.mean)
        << "of a city car";
    piece.mean(kLength) = 3.2;
    piece.covariance(kLength, kLength) = 0.6 * 0.6;
    EXPECT_NEAR(grownAsJudged(piece, rearOf(1.7), 1.5, {true, true}, o).mean(kLength), o.carLength,
                0.1)
        << "told vaguely";
    piece.covariance(kLength, kLength) = 0.2 * 0.2;
    EXPECT_EQ(grownAsJudged(piece, rearOf(1.7), 1.5, {true, true}, o).mean, piece.mean)
        << "of a small car, told well";
    piece.mean(kLength) = 2.0;
    piece.width = 0.8;
    EXPECT_EQ(grownAsJudged(piece, rearOf(0.8), 1.5, {true, true}, o).mean, piece.mean)
        << "of a motorcycle";
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

TEST(StartState, AssumesACarBehindACarsEnd)
{
    const MotionOptions motion;
    const VisibilityOptions options;
    const auto start =
        [&](double length, double width, const VisibilityOptions& o, double height = 1.5)
    {
        return startState(measured({10, 0, 0, length, width}, faces({Face::Back})), height, {0, 0},
                          {0.0, 8.0}, o, motion);
    };
    const VehicleState rear = start(1.0, 1.7, options);
    EXPECT_NEAR(rear.mean(kLength), options.carLength, 1e-3);
    EXPECT_NEAR(rear.mean(kX), 9.5 + 0.5 * options.carLength, 1e-3);
    // The centre is as uncertain as half the length.
    EXPECT_NEAR(rear.covariance(kX, kX), 0.25 * options.carLengthSigma * options.carLengthSigma,
                0.01);
    EXPECT_EQ(rear.covariance(kSpeed, kSpeed), 64.0);
    EXPECT_NEAR(start(0.9, 0.7, options).mean(kLength), 0.9, 1e-3);
    const VehicleState van = start(1.0, 2.0, options, 2.3);
    EXPECT_GT(van.mean(kLength), rear.mean(kLength) + 0.4);
    EXPECT_GT(van.covariance(kLength, kLength), rear.covariance(kLength, kLength));
    const VehicleState flat = start(1.0, 1.7, options, 0.6);
    EXPECT_EQ(flat.mean(kLength), rear.mean(kLength)) << "no lower than a car: a part of it";
    VisibilityOptions plain;
    plain.assumeVehicleSize = false;
    EXPECT_NEAR(start(1.0, 1.7, plain).mean(kLength), 1.0, 1e-3);
}

// A minute of an end alone tells nothing of the length.
TEST(GrownToAVehicle, LengthFollowsTheWidthOfTheEndAndTheRearStays)
{
    const VisibilityOptions o;
    VehicleState half;
    half.mean << 20.0, 0.0, 0.0, 8.0, 0.0, 0.4, 1.2;
    half.covariance.diagonal().setConstant(0.01);
    half.width = 1.7;
    const Measurement rear = measured({20.0, 0.0, 0.0, 1.2, 1.75}, faces({Face::Back}));
    const VehicleState grown = grownToAVehicle(half, rear, 1.5, SizesTold(), o);
    const double length = carLength(1.5, 1.7, o).metres;
    EXPECT_NEAR(grown.mean(kLength), length, 1e-9);
    EXPECT_NEAR(grown.mean(kX) - 0.5 * grown.mean(kLength), 20.0 - 0.6, 1e-9);
    EXPECT_NEAR(grown.mean(kAxis) - half.mean(kAxis), 0.5 * (length - 1.2), 1e-9);
    EXPECT_EQ(grown.mean(kSpeed), 8.0);
    EXPECT_GT(grown.covariance(kLength, kLength), 0.9 * o.carLengthSigma * o.carLengthSigma);

    EXPECT_EQ(grownToAVehicle(half, rear, 1.5, {true, true}, o).mean, half.mean)
        << "length is known";
    half.width = 2.5;
    const Measurement truck = measured({20.0, 0.0, 0.0, 1.2, 2.5}, faces({Face::Back}));
    EXPECT_GT(grownToAVehicle(half, truck, 3.0, SizesTold(), o).mean(kLength), 6.0);
    EXPECT_EQ(grownToAVehicle(half, truck, 1.5, SizesTold(), o).mean, half.mean) << "no truck";
    half.width = 0.6;
    const Measurement person = measured({20.0, 0.0, 0.0, 1.2, 0.6}, faces({Face::Back}));
    EXPECT_EQ(grownToAVehicle(half, person, 1.5, SizesTold(), o).mean, half.mean);
}

// A car whose end was seen through a gap, so that it seemed as narrow as that.
TEST(GrownToAVehicle, WidthFollowsTheLengthOfTheSideAndTheSideStays)
{
    const VisibilityOptions o;
    VehicleState slice;
    slice.mean << 20.0, 3.0, 0.0, 0.0, 0.0, 1.2, 4.2;
    slice.covariance.diagonal().setConstant(0.01);
    slice.width = 0.9;
    const Measurement side = measured({20.0, 3.0, 0.0, 4.2, 0.9}, faces({Face::Right}));
    for (const SizesTold& told : {SizesTold(), SizesTold{true, true}})
    {
        const VehicleState grown = grownToAVehicle(slice, side, 1.5, told, o);
        EXPECT_NEAR(grown.width, o.carWidth, 1e-9);
        EXPECT_NEAR(grown.mean(kY) - 0.5 * grown.width, 3.0 - 0.45, 1e-9);
        EXPECT_EQ(grown.mean(kLength), 4.2);
        EXPECT_NEAR(grown.widthVariance, o.carWidthSigma * o.carWidthSigma, 1e-9);
    }
    Measurement motorcycle = side;
    motorcycle.box.length = 2.2;
    EXPECT_EQ(grownToAVehicle(slice, motorcycle, 1.5, SizesTold(), o).width, 0.9);
    slice.width = 1.6;
    EXPECT_EQ(grownToAVehicle(slice, side, 1.5, {true, true}, o).width, 1.6) << "width is known";
    slice.mean(kLength) = 9.0;
    slice.width = 0.9;
    const Measurement truck = measured({20.0, 3.0, 0.0, 9.0, 0.9}, faces({Face::Right}));
    EXPECT_GT(grownToAVehicle(slice, truck, 3.0, SizesTold(), o).width, 2.0);
}

}  // namespace
}  // namespace vdamf
