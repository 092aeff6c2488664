// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/predicted_targets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
PredictedTarget targetOf(const Track& track, double interval = 0.1)
{
    return predictedTargets({track}, Discriminator(DiscriminatorOptions()), interval,
                            LifecycleOptions())
        .front();
}

PredictedTarget targetOf(double probability, double width, double height)
{
    Track track;
    track.state.mean << 10.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    track.state.width = width;
    track.height = height;
    track.judgement.probability = probability;
    return targetOf(track);
}

Track truckOfKnownWidth()
{
    Track track;
    track.state.mean << 10.0, 0.0, 0.0, 0.0, 0.0, 1.2, 9.0;
    track.state.width = 2.5;
    track.height = 3.0;
    track.judgement.probability = 0.9;
    track.told.width = true;
    return track;
}

TEST(PredictedTargets, MayBeAsFarAsNewOnesGoBetweenTwoScans)
{
    const double speedSigma = LifecycleOptions().startSpeedSigma;
    EXPECT_EQ(targetOf(truckOfKnownWidth(), 0.1).greatestSigma, 2.0);
    EXPECT_EQ(targetOf(truckOfKnownWidth(), 0.5).greatestSigma, 0.5 * speedSigma);
}

TEST(PredictedTargets, ACarIsOneWhereThatIsSure)
{
    EXPECT_TRUE(targetOf(0.9, 1.8, 1.5).isBounded);
    EXPECT_FALSE(targetOf(0.7, 1.8, 1.5).isBounded);
}

TEST(PredictedTargets, WhatMayBeATruckIsNoCar)
{
    EXPECT_FALSE(targetOf(0.9, 2.5, 1.5).isBounded) << "its cab may be out of view";
    EXPECT_FALSE(targetOf(0.9, 1.8, 2.8).isBounded);
}

TEST(PredictedTargets, ATreeOverACarMakesItNoTruck)
{
    Track car = truckOfKnownWidth();
    car.state.width = 1.8;
    car.height = 2.9;
    car.judgement.probability = 0.99;
    EXPECT_FALSE(targetOf(car).isBounded) << "its faces may be as high";
    car.tallest = 1.6;
    EXPECT_TRUE(targetOf(car).isBounded);
    car.tallest = 2.5;
    EXPECT_FALSE(targetOf(car).isBounded);
    car.tallest = 1.6;
    car.state.width = 2.5;
    EXPECT_FALSE(targetOf(car).isBounded) << "the front of a truck";
    car.state.width = 1.8;
    car.judgement.probability = 0.9;
    EXPECT_FALSE(targetOf(car).isBounded) << "the cab of one";
}

TEST(PredictedTargets, ATruckEndsWhereItsBoxDoesWhereItStandsAndItsSizeIsKnown)
{
    Track truck = truckOfKnownWidth();
    truck.state.covariance(kLength, kLength) = truck.state.widthVariance = 0.2 * 0.2;
    truck.stoodProbability = 0.9;
    truck.told.length = true;
    EXPECT_TRUE(targetOf(truck).isBounded);
    for (const auto& change :
         {+[](Track& t) { t.stoodProbability = 0.1; }, +[](Track& t) { t.told.length = false; },
          +[](Track& t) { t.told.width = false; }, +[](Track& t) { t.state.width = 5.0; },
          +[](Track& t) { t.judgement.probability = 0.7; },
          +[](Track& t) { t.state.covariance(kLength, kLength) = 0.5 * 0.5; },
          +[](Track& t) { t.state.widthVariance = 0.5 * 0.5; }})
    {
        Track other = truck;
        change(other);
        EXPECT_FALSE(targetOf(other).isBounded);
    }
}

// A rear known to 0.05 m, and a length to 0.6 m: the centre errs by half of the length's error.
TEST(PredictedTargets, TheEndThatIsSeenIsSureWhereTheLengthIsNot)
{
    Track car;
    car.state.mean << 10.0, 5.0, 0.5 * kPi, 0.0, 0.0, 1.2, 4.5;
    car.state.covariance(kLength, kLength) = 0.6 * 0.6;
    car.state.covariance(kY, kY) = 0.05 * 0.05 + 0.3 * 0.3;
    car.state.covariance(kY, kLength) = car.state.covariance(kLength, kY) = 0.5 * 0.6 * 0.6;
    const Eigen::Vector2d sigma = targetOf(car).endSigma;
    EXPECT_NEAR(sigma(0), 0.05, 1e-9) << "the rear";
    EXPECT_NEAR(sigma(1), std::hypot(0.05, 0.6), 1e-9) << "the front";
    // Turned about, its front is seen.
    car.state.mean(kHeading) *= -1.0;
    EXPECT_NEAR(targetOf(car).endSigma(1), 0.05, 1e-9);
}

TEST(PredictedTargets, ATruckIsOneWhereItDrivesAndItsWidthWasSeen)
{
    const Track truck = truckOfKnownWidth();
    EXPECT_TRUE(targetOf(truck).isDrivingTruck);
    for (const auto& change :
         {+[](Track& t) { t.stoodProbability = 0.9; }, +[](Track& t) { t.told.width = false; },
          +[](Track& t) { t.judgement.probability = 0.7; }, +[](Track& t) { t.state.width = 5.0; },
          +[](Track& t)
          {
              t.state.width = 1.8;
              t.height = 1.5;
          }})
    {
        Track other = truck;
        change(other);
        EXPECT_FALSE(targetOf(other).isDrivingTruck);
    }
}

TEST(PredictedTargets, WhatIsNoVehicleIsAsLargeAsItsHits)
{
    Track rail;
    rail.state.mean << 10.0, 5.0, 0.0, 20.0, 0.0, 1.2, 26.0;
    rail.state.width = 2.1;
    rail.state.widthVariance = 0.3 * 0.3;
    rail.around = {0.0, -0.9, 0.0, 25.0, 0.3};
    rail.judgement.probability = 0.005;
    rail.sightings = 20;
    for (const int misses : {0, 1})
    {
        rail.misses = misses;
        EXPECT_EQ(targetOf(rail).box, rail.boxOfHits()) << misses << " misses";
        EXPECT_EQ(targetOf(rail).widthSigma, 0.0);
    }
    rail.judgement.probability = 0.05;
    EXPECT_EQ(targetOf(rail).box, rail.box()) << "its last hits may have been a part of a car";
    EXPECT_EQ(targetOf(rail).widthSigma, 0.3);
    rail.misses = 0;
    EXPECT_EQ(targetOf(rail).box, rail.boxOfHits());
}

TEST(PredictedTargets, ClutterIsWhatSurelyIsNoVehicle)
{
    EXPECT_TRUE(targetOf(0.1, 1.8, 1.5).isClutter);
    EXPECT_FALSE(targetOf(0.4, 1.8, 1.5).isClutter);
}

}  // namespace
}  // namespace vdamf
