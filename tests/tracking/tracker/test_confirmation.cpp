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

// What is seen for sure to stand, with its side in view.
Track standing()
{
    Track track;
    track.hits = 100;
    track.state.mean(kLength) = 4.3;
    track.state.covariance(kSpeed, kSpeed) = 0.04;
    track.hypotheses->driving.front().covariance(kSpeed, kSpeed) = 0.04;
    HeadingCues side;
    side.side = FaceExtent{4.3, 1.0};
    track.front = HeadingBelief(side);
    return track;
}

int sightingsUntilConfirmed(Track track, const LifecycleOptions& options)
{
    for (track.sightings = 2; track.sightings < 50; ++track.sightings)
        if (withConfirmation(track, options).status == TrackStatus::Confirmed) break;
    return track.sightings;
}

TEST_F(Confirmation, OfFewHitsWhatMayDriveIsNotTakenToStand)
{
    // It seems to stand, and if it drives, it does so at 0 +- 2 m/s.
    Track track = standing();
    track.hypotheses->driving.front().covariance(kSpeed, kSpeed) = 4.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 3);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 7);
}

TEST_F(Confirmation, WaitsWhereItsShapeAndItsWayTellDifferentFronts)
{
    Track track = standing();
    track.state.mean(kSpeed) = -3.0;
    HeadingCues cues;
    cues.forth = 0.0;
    cues.dt = 0.1;
    track.front = track.front.after(cues);
    track.state.mean(kSpeed) = -1.2;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 7) << "it may stand";
    track.state.mean(kSpeed) = -3.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 13);
    cues.forth = 1.0;
    for (int k = 0; k < 5; ++k) track.front = track.front.after(cues);
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 3);
}

TEST_F(Confirmation, WaitsAfterAHopOnToSomethingElse)
{
    Track track = standing();
    track.surprisedAt = 4;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 7);
    track.surprisedAt = 50;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 18) << "not for ever";
    ASSERT_EQ(seenUntilConfirmed(0.03, 0.0), 3);
    EXPECT_EQ(track_.surprisedAt, 0);
    Sighting hop = rearAt(0.3, 1.8);
    hop.measurement.covariance(3, 3) = 1e-3;
    hop.measurement.box.x += 4.0;
    hop.around.x += 4.0;
    see(hop);
    EXPECT_EQ(track_.surprisedAt, 4);
}

// Seen to drive for a while, m/s.
Track onItsWay(double speed)
{
    Track track = standing();
    track.state.mean(kSpeed) = track.hypotheses->driving.front().mean(kSpeed) = speed;
    HeadingCues cues;
    cues.side = FaceExtent{4.3, 1.0};
    cues.course = HeadingCues::Course{0.0, speed};
    for (int k = 0; k < 10; ++k) track.front = track.front.after(cues);
    return track;
}

TEST_F(Confirmation, OfFewHitsWhatDrivesMayBeOnParkedCarsInTurn)
{
    Track track = onItsWay(20.0);
    ASSERT_GT(track.front.forwardProbability(), 0.9);
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 3);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 7);
}

// Of known speed and front, and surely a vehicle.
Track driving(double speed)
{
    Track track = onItsWay(speed);
    track.hypotheses->standingProbability = 0.0;
    track.judgement.probability = 0.9;
    return track;
}

TEST_F(Confirmation, NeedsNoThirdSightingOfAVehicleOfKnownSpeed)
{
    Track track = driving(20.0);
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 2);
    track.judgement.probability = 0.7;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 3) << "may be something else";
    track.judgement.probability = 0.9;
    track.state.covariance(kSpeed, kSpeed) = 1.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 3) << "may be slower";
    track.hypotheses->standingProbability = 0.9;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 2) << "likely stands";
    track.surprisedAt = 4;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 6) << "it hopped";
    options_.lifecycle.confirmHits = 10;
    track.surprisedAt = 0;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 9);
}

TEST_F(Confirmation, OfFewHitsAVehicleThatSurelyDrivesIsNotWaitedFor)
{
    Track track = driving(12.0);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 2);
    track.judgement.probability = 0.7;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 7) << "what is it?";
    Track slow = driving(1.2);
    slow.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(slow, options_.lifecycle), 7) << "may stand";
}

TEST_F(Confirmation, WaitsLongerWhereFewHitsDoNotTellTheAxes)
{
    Track track = standing();
    track.front = HeadingBelief();
    ASSERT_LT(track.front.axesProbability(), options_.lifecycle.confirmAxes);
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 13);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 33);
}

TEST_F(Confirmation, WaitsLongestWhereAxesAreMoreLikelyExchanged)
{
    Track track = standing();
    HeadingCues across;
    across.end = FaceExtent{3.4, 0.3};
    track.front = HeadingBelief(across);
    ASSERT_LT(track.front.axesProbability(), 0.5);
    EXPECT_EQ(sightingsUntilConfirmed(track, options_.lifecycle), 33);
}

TEST_F(Confirmation, WaitsForMoreThanThePieceOfAVehicle)
{
    Track piece = standing();
    piece.judgement.probability = 0.5;
    EXPECT_EQ(sightingsUntilConfirmed(piece, options_.lifecycle), 3);
    piece.state.mean(kLength) = 1.3;
    EXPECT_EQ(sightingsUntilConfirmed(piece, options_.lifecycle), 33);
    Track whole = piece;
    whole.told.length = true;
    whole.state.covariance(kLength, kLength) = 0.05 * 0.05;
    EXPECT_EQ(sightingsUntilConfirmed(whole, options_.lifecycle), 3) << "is as short";
    whole.state.covariance(kLength, kLength) = 0.5 * 0.5;
    EXPECT_EQ(sightingsUntilConfirmed(whole, options_.lifecycle), 33) << "may be longer";
    Track none = piece;
    none.judgement.probability = 0.01;
    EXPECT_EQ(sightingsUntilConfirmed(none, options_.lifecycle), 3);
    Track rider = piece;
    rider.isFaceless = true;
    EXPECT_EQ(sightingsUntilConfirmed(rider, options_.lifecycle), 3);
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
