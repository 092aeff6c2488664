// SPDX-License-Identifier: BSD-3-Clause
// Tracks are confirmed once it is clear which way their boxes lie, and anew where that changes.
#include <gtest/gtest.h>

#include "tracker/existence.h"
#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"
#include "tracker/track.h"

namespace vdamf
{
namespace
{
// What is taken for the rear of a vehicle ahead, of which so much is in view, `along` m further.
Sighting rearAt(double time, double width, double along = 0.0)
{
    Sighting s;
    s.time = time;
    s.measurement.box = {20.0, along + 0.5 * width, 0.0, 4.3, width};
    s.measurement.covariance = (Vector5d() << 1e-3, 1e-3, 1e-4, 4.0, 1e-2).finished().asDiagonal();
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.hits = 30;
    s.measurement.match = 0.5;
    s.around = {17.85, along + 0.5 * width, 0.0, 0.1, width};
    s.height = 1.4;
    s.end = {width, 25.0};
    return s;
}

constexpr double kDriven = 8.0;  // m/s

class Confirmation : public ::testing::Test
{
protected:
    void see(const Sighting& sighting)
    {
        if (sighting.time > 0.0)
            track_ = predictedTrack(std::move(track_), 0.1, {0.0, 0.0}, filter_, options_.motion);
        track_ =
            sighting.time > 0.0
                ? withConfirmation(
                      sightedTrack(std::move(track_), sighting, Neighbourhood(), filter_, options_),
                      options_.lifecycle)
                : startedTrack(1, sighting, {0.0, options_.lifecycle.startSpeedSigma}, options_);
    }

    // Sightings of what drives ahead (m/s), seen so well (m along its path).
    int seenUntilConfirmed(double sigma, double speed)
    {
        track_ = {};
        while (track_.status == TrackStatus::Tentative && track_.sightings < 50)
        {
            const double time = 0.1 * track_.sightings;
            Sighting s = rearAt(time, 1.8);
            s.measurement.box.x += speed * time;
            s.around.x += speed * time;
            s.measurement.covariance(0, 0) = s.measurement.covariance(3, 3) = sigma * sigma;
            see(s);
        }
        return track_.sightings;
    }

    // Modulo half a turn, rad.
    double heading() const { return std::abs(std::remainder(track_.state.mean(kHeading), kPi)); }

    TrackerOptions options_;
    VehicleKalmanFilter filter_{options_.motion};
    Track track_;
};

TEST_F(Confirmation, WaitsForAWhileWhereAxesAreUndecided)
{
    // As wide as the widest of rears, and as long as a part of a side: it may be either.
    const auto sightingsUntilConfirmed = [this]
    {
        see(rearAt(0.0, 2.25));
        while (track_.status == TrackStatus::Tentative && track_.sightings < 50)
            see(rearAt(0.1 * track_.sightings, 2.25));
        return track_.sightings;
    };
    options_.lifecycle.confirmAxes = 0.99;
    EXPECT_EQ(sightingsUntilConfirmed(), 13);
    EXPECT_LT(track_.front.axesProbability(), 0.99);
    options_.lifecycle.confirmAxes = 0.0;
    EXPECT_EQ(sightingsUntilConfirmed(), 4);  // of which one is for the speed
}

TEST_F(Confirmation, WaitsForAWhileWhereTheSpeedIsNotKnown)
{
    EXPECT_EQ(seenUntilConfirmed(0.03, kDriven), 3);
    EXPECT_LT(track_.state.covariance(kSpeed, kSpeed), 4.0);
    EXPECT_GT(seenUntilConfirmed(1.0, kDriven), 3);
    EXPECT_LE(track_.sightings, 7);
}

TEST_F(Confirmation, WaitsForAWhileWhereWhatMayBeMovingMayDriveEitherWay)
{
    options_.lifecycle.confirmSpeedSigma = 40.0;
    EXPECT_EQ(seenUntilConfirmed(0.03, kDriven), 3);
    EXPECT_GT(track_.front.forwardProbability(), 0.9);
    EXPECT_GT(seenUntilConfirmed(0.5, 0.0), 3);
    EXPECT_LE(track_.sightings, 7);
    // What stands for sure never shows which way it drives.
    EXPECT_EQ(seenUntilConfirmed(0.03, 0.0), 3);
    EXPECT_NEAR(track_.front.forwardProbability(), 0.5, 0.1);
}

TEST_F(Confirmation, KnowsOfAHopOnToSomethingElse)
{
    ASSERT_EQ(seenUntilConfirmed(0.03, 0.0), 3);
    EXPECT_EQ(track_.surprisedAt, 0);
    Sighting hop = rearAt(0.3, 1.8);
    hop.measurement.covariance(3, 3) = 1e-3;
    hop.measurement.box.x += 4.0;
    hop.around.x += 4.0;
    see(hop);
    EXPECT_EQ(track_.surprisedAt, 4);
}

TEST_F(Confirmation, BeginsAnewWhereAxesAreExchanged)
{
    int k = 0;
    for (; k < 7; ++k) see(rearAt(0.1 * k, 1.8));
    ASSERT_EQ(track_.status, TrackStatus::Confirmed);
    ASSERT_LT(heading(), 0.2);
    // No car is so wide.
    for (; heading() < 0.2 && k < 13; ++k) see(rearAt(0.1 * k, 4.0));
    ASSERT_GT(heading(), 1.3);
    EXPECT_EQ(track_.status, TrackStatus::Tentative);
    EXPECT_EQ(track_.startedAt, track_.sightings);
    EXPECT_EQ(track_.id, 1U);
    // What was told of its width is told of its length.
    EXPECT_TRUE(track_.told.length);
    EXPECT_FALSE(track_.told.width);

    Sighting side = rearAt(0.0, 4.0);
    side.measurement = turnedBy(side.measurement, 1);
    std::swap(side.side, side.end);
    side.around = {17.85, 2.0, 0.5 * kPi, 4.0, 0.1};
    for (const TrackStatus status : {TrackStatus::Tentative, TrackStatus::Confirmed})
    {
        side.time = 0.1 * k++;
        see(side);
        EXPECT_EQ(track_.status, status);
    }
}

TEST_F(Confirmation, IsKeptWhereTheCourseToldThatAxesAreExchanged)
{
    // It stands, and then slides along what is taken for its width: that is its length.
    int k = 0;
    for (; k < 7; ++k) see(rearAt(0.1 * k, 1.8));
    ASSERT_EQ(track_.status, TrackStatus::Confirmed);
    for (; heading() < 0.2 && k < 30; ++k) see(rearAt(0.1 * k, 1.8, 0.6 * (k - 6)));
    ASSERT_GT(heading(), 1.3);
    EXPECT_EQ(track_.status, TrackStatus::Confirmed);
    EXPECT_NEAR(std::abs(track_.state.mean(kSpeed)), 6.0, 1.0);
}

}  // namespace
}  // namespace vdamf
