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
