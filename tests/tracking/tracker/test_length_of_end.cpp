// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/length_of_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"

namespace vdamf
{
namespace
{
// Likely a vehicle, seen from behind by a part of its end: taken for a van so far.
Track partOfARear()
{
    Track track;
    track.hypotheses->forEach(
        [](VehicleState& state)
        {
            state.mean << 20.0, 0.0, 0.0, 0.0, 0.0, 1.2, 5.0;
            state.width = 2.0;
            state.covariance(kLength, kLength) = 0.36;
        });
    track.assumedLength = AssumedSize{5.0, 0.6};
    track.highest = 3.0;
    track.judgement.probability = 0.9;
    return track;
}

VehicleState followed(const Track& track)
{
    Measurement m;
    m.facesSeen.add(Face::Back);
    return withEndFollowed(track, Sighting(), m, VisibilityOptions()).hypotheses->standing;
}

TEST(LengthOfEnd, BehindATallFaceOfUnknownWidthIsATruckOrABus)
{
    Track track = partOfARear();
    EXPECT_LT(followed(track).mean(kLength), 5.5) << "a tree over a car is as high";
    track.tallest = 2.6;
    const VehicleState truck = followed(track);
    EXPECT_NEAR(truck.mean(kLength), 8.5, 1e-9);
    EXPECT_NEAR(std::sqrt(truck.covariance(kLength, kLength)), 2.5, 0.01);
    EXPECT_NEAR(truck.mean(kX) - 0.5 * truck.mean(kLength), 17.5, 1e-9) << "its rear stays";
}

TEST(LengthOfEnd, WhereNothingWasAssumedWhatIsMuchShorterIsAPart)
{
    Track track = partOfARear();
    track.assumedLength.reset();
    track.tallest = 2.6;
    EXPECT_NEAR(followed(track).mean(kLength), 8.5, 1e-9);
    track.hypotheses->forEach([](VehicleState& state) { state.mean(kLength) = 7.5; });
    EXPECT_EQ(followed(track).mean(kLength), 7.5);
}

TEST(LengthOfEnd, NotOfWhatIsHardlyAVehicleNorOfAKnownWidth)
{
    Track hedge = partOfARear();
    hedge.tallest = 2.6;
    hedge.judgement.probability = 0.4;
    EXPECT_LT(followed(hedge).mean(kLength), 5.5);
    Track van = partOfARear();
    van.tallest = 2.6;
    van.told.width = true;
    van.state.width = 2.0;
    EXPECT_LT(followed(van).mean(kLength), 5.5);
}

TEST(LengthOfEnd, APartOfAnEndThatIsWiderThanCarsIsATrucksIfItDrives)
{
    Track part = partOfARear();
    part.highest = 2.1;
    part.hypotheses->standingProbability = 0.0;
    const auto drive = [&part](double width)
    {
        part.hypotheses->forEach(
            [width](VehicleState& state)
            {
                state.mean(kSpeed) = 19.0;
                state.width = width;
                state.covariance(kSpeed, kSpeed) = 0.01;
            });
    };
    drive(2.2);
    EXPECT_LT(followed(part).mean(kLength), 5.5);
    drive(2.35);
    EXPECT_NEAR(followed(part).mean(kLength), 9.0, 1e-9);
    part.judgement.probability = 0.4;
    EXPECT_EQ(followed(part).mean(kLength), 5.0) << "hardly a vehicle";
    part.judgement.probability = 0.9;
    part.hypotheses->standingProbability = 1.0;
    EXPECT_EQ(followed(part).mean(kLength), 5.0) << "a bush before a car";
}

// A truck ahead that drives at 8 m/s, of a length that its rear let guess and that an update by
// hits which reach to 9.6 m has changed since it was `foretold`.
struct TruckAhead
{
    Track track;
    VehicleState foretold;
    Sighting sighting;
    Measurement m;

    TruckAhead()
    {
        foretold.mean << 20.0, 0.0, 0.0, 8.0, 0.0, 1.8, 9.0;
        foretold.width = 2.5;
        foretold.covariance.diagonal().setConstant(0.01);
        foretold.covariance(kLength, kLength) = 4.0;
        track.hypotheses->standingProbability = 0.0;
        track.hypotheses->forEach(
            [&](VehicleState& state)
            {
                state = foretold;
                state.mean(kLength) = 9.55;
                state.mean(kX) += 0.275;
                state.covariance(kLength, kLength) = 0.25;
            });
        track.height = 3.0;
        m.box = {20.3, 0.0, 0.0, 9.6, 2.5};
        for (const Face face : {Face::Back, Face::Left}) m.facesSeen.add(face);
        m.hiddenEnds.add(Face::Front);
        sighting.side.metres = 2.5;
        sighting.around.length = 9.2;
    }

    VehicleState after() const
    {
        return goingOnOutOfSight(track, sighting, m, foretold, VisibilityOptions())
            .hypotheses->driving.front();
    }
};

TEST(LengthOfEnd, HitsBeyondAGuessedLengthTellThatItIsLongerAndNoMore)
{
    const VehicleState after = TruckAhead().after();
    const AssumedSize whole = longerThan(9.6, {9.0, 2.0});
    EXPECT_NEAR(after.mean(kLength), whole.metres, 1e-9);
    EXPECT_GT(after.mean(kLength), 10.5);
    EXPECT_NEAR(after.covariance(kLength, kLength), whole.sigma * whole.sigma, 1e-9);
    EXPECT_NEAR(after.mean(kX) - 0.5 * after.mean(kLength), 15.5, 1e-9) << "its rear stays";
}

TEST(LengthOfEnd, NotWhereTheHiddenEndWasInViewJustBefore)
{
    TruckAhead placed;
    placed.foretold.covariance(kX, kLength) = placed.foretold.covariance(kLength, kX) = -1.95;
    placed.foretold.covariance(kX, kX) = 1.0;
    ASSERT_LT(placed.foretold.faceSigma(0, 1), 0.3);
    EXPECT_EQ(placed.after().mean(kLength), 9.55);
}

TEST(LengthOfEnd, NotWhereTheLengthIsToldNorHitsReachLittleFarther)
{
    TruckAhead told;
    told.track.told.length = true;
    EXPECT_EQ(told.after().mean(kLength), 9.55);
    TruckAhead better;
    better.foretold.covariance(kLength, kLength) = 1.0;
    EXPECT_EQ(better.after().mean(kLength), 9.55) << "no guess";
    TruckAhead little;
    little.m.box.length = 9.25;
    EXPECT_EQ(little.after().mean(kLength), 9.55);
    TruckAhead stands;
    stands.track.hypotheses->standingProbability = 0.5;
    EXPECT_EQ(stands.after().mean(kLength), 9.55) << "something else may be there";
    TruckAhead sees;
    sees.m.hiddenEnds = {};
    EXPECT_EQ(sees.after().mean(kLength), 9.55) << "both ends are told";
}

TEST(LengthOfEnd, FacesAreAsHighAsTwoSightingsTell)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    Sighting rear;
    rear.measurement.box = {22.0, 0.0, 0.0, 4.3, 1.8};
    rear.measurement.covariance.diagonal() << 1e-3, 1e-3, 1e-4, 1e-3, 1e-2;
    rear.measurement.facesSeen.add(Face::Back);
    rear.measurement.hits = 30;
    rear.around = {19.85, 0.0, 0.0, 0.1, 1.8};
    rear.faceHeight = 1.0;
    Track track = startedTrack(1, rear, {0.0, 10.0}, options);
    for (const double height : {2.8, 1.1, 2.7, 2.6})
    {
        rear.time += 0.1;
        rear.faceHeight = height;
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), rear, Neighbourhood(), filter, options);
        EXPECT_LE(track.tallest, height) << "once higher is an error";
    }
    EXPECT_EQ(track.tallest, 2.6);
}

}  // namespace
}  // namespace vdamf
