// SPDX-License-Identifier: BSD-3-Clause
// For how many sightings a track waits to be confirmed, by what is known of it.
#include <gtest/gtest.h>

#include "tracker/existence.h"
#include "tracker/track.h"

namespace vdamf
{
namespace
{
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

TEST(ConfirmationPatience, OfFewHitsWhatMayDriveIsNotTakenToStand)
{
    const LifecycleOptions lifecycle;
    // It seems to stand, and if it drives, it does so at 0 +- 2 m/s.
    Track track = standing();
    track.hypotheses->driving.front().covariance(kSpeed, kSpeed) = 4.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 3);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 7);
}

TEST(ConfirmationPatience, WaitsWhereItsShapeAndItsWayTellDifferentFronts)
{
    const LifecycleOptions lifecycle;
    Track track = standing();
    HeadingCues cues;
    cues.forth = 0.0;
    cues.dt = 0.1;
    track.front = track.front.after(cues);
    track.state.mean(kSpeed) = -1.2;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 7) << "it may stand";
    track.state.mean(kSpeed) = -3.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 13);
    cues.forth = 1.0;
    for (int k = 0; k < 5; ++k) track.front = track.front.after(cues);
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 3);
}

TEST(ConfirmationPatience, WaitsAfterAHopOnToSomethingElse)
{
    const LifecycleOptions lifecycle;
    Track track = standing();
    track.surprisedAt = 4;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 7);
    track.surprisedAt = 50;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 18) << "not for ever";
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

TEST(ConfirmationPatience, OfFewHitsWhatDrivesMayBeOnParkedCarsInTurn)
{
    const LifecycleOptions lifecycle;
    Track track = onItsWay(20.0);
    ASSERT_GT(track.front.forwardProbability(), 0.9);
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 3);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 7);
}

// Of known speed and front, and surely a vehicle.
Track driving(double speed)
{
    Track track = onItsWay(speed);
    track.hypotheses->standingProbability = 0.0;
    track.judgement.probability = 0.9;
    return track;
}

TEST(ConfirmationPatience, NeedsNoThirdSightingOfAVehicleOfKnownSpeed)
{
    LifecycleOptions lifecycle;
    Track track = driving(20.0);
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 2);
    track.judgement.probability = 0.7;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 3) << "may be something else";
    track.judgement.probability = 0.9;
    track.state.covariance(kSpeed, kSpeed) = 1.0;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 3) << "may be slower";
    track.hypotheses->standingProbability = 0.9;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 2) << "likely stands";
    track.surprisedAt = 4;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 6) << "it hopped";
    lifecycle.confirmHits = 10;
    track.surprisedAt = 0;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 9);
}

TEST(ConfirmationPatience, OfFewHitsAVehicleThatSurelyDrivesIsNotWaitedFor)
{
    const LifecycleOptions lifecycle;
    Track track = driving(12.0);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 2);
    track.judgement.probability = 0.7;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 7) << "what is it?";
    Track slow = driving(1.2);
    slow.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(slow, lifecycle), 7) << "may stand";
}

TEST(ConfirmationPatience, WaitsLongerWhereFewHitsDoNotTellTheAxes)
{
    const LifecycleOptions lifecycle;
    Track track = standing();
    track.front = HeadingBelief();
    ASSERT_LT(track.front.axesProbability(), lifecycle.confirmAxes);
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 13);
    track.hits = 15;
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 33);
}

TEST(ConfirmationPatience, WaitsLongestWhereAxesAreMoreLikelyExchanged)
{
    const LifecycleOptions lifecycle;
    Track track = standing();
    HeadingCues across;
    across.end = FaceExtent{3.4, 0.3};
    track.front = HeadingBelief(across);
    ASSERT_LT(track.front.axesProbability(), 0.5);
    EXPECT_EQ(sightingsUntilConfirmed(track, lifecycle), 33);
}

TEST(ConfirmationPatience, WaitsForMoreThanThePieceOfAVehicle)
{
    const LifecycleOptions lifecycle;
    Track piece = standing();
    piece.judgement.probability = 0.5;
    EXPECT_EQ(sightingsUntilConfirmed(piece, lifecycle), 3);
    piece.state.mean(kLength) = 1.3;
    EXPECT_EQ(sightingsUntilConfirmed(piece, lifecycle), 33);
    Track whole = piece;
    whole.told.length = true;
    whole.state.covariance(kLength, kLength) = 0.05 * 0.05;
    EXPECT_EQ(sightingsUntilConfirmed(whole, lifecycle), 3) << "is as short";
    whole.state.covariance(kLength, kLength) = 0.5 * 0.5;
    EXPECT_EQ(sightingsUntilConfirmed(whole, lifecycle), 33) << "may be longer";
    Track none = piece;
    none.judgement.probability = 0.01;
    EXPECT_EQ(sightingsUntilConfirmed(none, lifecycle), 3);
    Track rider = piece;
    rider.isFaceless = true;
    EXPECT_EQ(sightingsUntilConfirmed(rider, lifecycle), 3);
}

}  // namespace
}  // namespace vdamf
