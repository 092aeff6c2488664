// SPDX-License-Identifier: BSD-3-Clause
// What the last hits of a car say that goes out of sight.
#include <gtest/gtest.h>

#include <cmath>

#include "tracker/neighbourhood.h"
#include "tracker/sighting.h"
#include "tracker/track.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
// Of a car 10 m ahead, its left side and rear in view.
Sighting wholeAt(double time)
{
    Sighting s;
    s.time = time;
    s.measurement.box = {12.0, -4.0, 0.0, 4.4, 1.8};
    s.measurement.covariance = (Vector5d() << 1e-3, 1e-3, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.facesSeen.add(Face::Left);
    s.measurement.hits = 200;
    s.measurement.match = 0.5;
    s.around = s.measurement.box;
    s.height = 1.5;
    s.side = {4.4, 150.0};
    s.end = {1.8, 50.0};
    return s;
}

// Half a metre of its side, taken for a box of its own.
Sighting glimpseAt(double time)
{
    Sighting s = wholeAt(time);
    s.measurement.box = {13.6, -3.3, 0.2, 4.4, 1.8};
    s.measurement.facesSeen = {};
    s.measurement.facesSeen.add(Face::Left);
    s.measurement.hiddenEnds.add(Face::Front);
    s.measurement.hits = 6;
    s.around = {13.5, -3.1, 0.0, 0.5, 0.1};
    s.side = {0.5, 6.0};
    s.end = {};
    return s;
}

Track parkedFor(int frames, VehicleKalmanFilter& filter)
{
    const TrackerOptions options;
    Track track = startedTrack(1, wholeAt(0.0), {0.0, options.lifecycle.startSpeedSigma}, options);
    for (int k = 1; k <= frames; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), wholeAt(0.1 * k), Neighbourhood(), filter, options);
    }
    return predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
}

TEST(LastGlimpse, TellsThatAParkedCarIsThereAndNotWhere)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    Track track = parkedFor(20, filter);
    ASSERT_GT(track.hypotheses->standingProbability, 0.5);
    track.misses = 1;
    const Track after = sightedTrack(track, glimpseAt(2.1), Neighbourhood(), filter, options);
    EXPECT_EQ(after.state.mean, track.state.mean);
    EXPECT_EQ(after.state.covariance, track.state.covariance);
    EXPECT_EQ(after.misses, 0);
    EXPECT_EQ(after.lastSeen, 2.1);
    EXPECT_FALSE(after.nis.has_value());
    EXPECT_FALSE(after.measurement.has_value());
    EXPECT_EQ(after.hits, 6);
    ASSERT_TRUE(after.shownHeading && track.shownHeading);
    EXPECT_EQ(after.shownHeading->heading, track.shownHeading->heading);
    EXPECT_EQ(after.shownHeading->variance, track.shownHeading->variance);
}

TEST(LastGlimpse, IsASightingLikeOthersWhereTheLengthWasNeverSeen)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    Track track = parkedFor(20, filter);
    track.told.length = false;
    const Track after = sightedTrack(track, glimpseAt(2.1), Neighbourhood(), filter, options);
    EXPECT_NE(after.state.mean, track.state.mean);
    EXPECT_TRUE(after.nis.has_value());
}

// The front half of the side, its rear hidden: the row ends a metre behind where the front is.
TEST(LastGlimpse, OfAParkedCarRowsThatAreCutShortDoNotMoveIt)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    const Track track = parkedFor(20, filter);
    Sighting cut = wholeAt(2.1);
    cut.measurement.box = {11.5, -4.0, 0.0, 3.2, 1.8};
    cut.measurement.facesSeen.remove(Face::Back);
    cut.measurement.hiddenEnds.add(Face::Back);
    cut.side = {3.2, 10.0};
    const Track after = sightedTrack(track, cut, Neighbourhood(), filter, options);
    EXPECT_LT((after.box().centre() - track.box().centre()).norm(), 0.1);
    EXPECT_LT(std::abs(after.state.mean(kSpeed)), 0.2);
    // What is not known to stand, nor how fast it is, may have moved.
    Track mayMove = track;
    mayMove.hypotheses->standingProbability = 0.3;
    for (VehicleState& state : mayMove.hypotheses->driving) state.covariance(kSpeed, kSpeed) = 4.0;
    const Track moved = sightedTrack(mayMove, cut, Neighbourhood(), filter, options);
    EXPECT_LT(moved.box().x, after.box().x - 0.03);
}

Sighting sightingMoved(Sighting sighting, double metres)
{
    sighting.measurement.box.x += metres;
    sighting.around.x += metres;
    return sighting;
}

constexpr double kSpeedAhead = 6.0;  // m/s

// Ahead, for two seconds; its next sighting is due at 2.1 s.
Track drivenOn(VehicleKalmanFilter& filter)
{
    const TrackerOptions options;
    Track track = startedTrack(1, wholeAt(0.0), {0.0, options.lifecycle.startSpeedSigma}, options);
    for (int k = 1; k <= 20; ++k)
    {
        const double time = 0.1 * k;
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), sightingMoved(wholeAt(time), kSpeedAhead * time),
                             Neighbourhood(), filter, options);
    }
    return predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
}

TEST(LastGlimpse, OfAMovingCarThatShowsNoFaceLeavesItsPose)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    const Track track = drivenOn(filter);
    ASSERT_LT(track.hypotheses->standingProbability, 0.5);
    Sighting glimpse = sightingMoved(glimpseAt(2.1), kSpeedAhead * 2.1);
    EXPECT_EQ(sightedTrack(track, glimpse, Neighbourhood(), filter, options).state.mean,
              track.state.mean)
        << "a face of six hits";
    glimpse.measurement.hits = 9;
    const Track withFace = sightedTrack(track, glimpse, Neighbourhood(), filter, options);
    EXPECT_NE(withFace.state.mean, track.state.mean);
    glimpse.measurement.facesSeen = {};
    glimpse.measurement.hiddenEnds = {};
    const Track after = sightedTrack(track, glimpse, Neighbourhood(), filter, options);
    EXPECT_EQ(after.state.mean, track.state.mean);
    EXPECT_EQ(after.lastSeen, 2.1);
}

// It is on the car where the car was at that time.
TEST(LastGlimpse, OfAMovingCarMayBeAFractionOfARevolutionLater)
{
    constexpr double kLag = 0.1;  // s
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    const Track track = drivenOn(filter);
    Sighting glimpse = sightingMoved(glimpseAt(2.1), kSpeedAhead * (2.1 + kLag));
    glimpse.lag = kLag;
    glimpse.around.x += 0.3;  // at its front end
    const Track after = sightedTrack(track, glimpse, Neighbourhood(), filter, options);
    EXPECT_EQ(after.state.mean, track.state.mean);
    EXPECT_EQ(after.lastSeen, 2.1);
}

TEST(LastGlimpse, OfAMovingCarThatSeemsToTurnAtOnceLeavesItsPose)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    Track track = drivenOn(filter);
    Sighting glimpse = sightingMoved(glimpseAt(2.1), kSpeedAhead * 2.1);
    glimpse.measurement.hits = 9;
    glimpse.measurement.box.heading = -0.7;
    EXPECT_EQ(sightedTrack(track, glimpse, Neighbourhood(), filter, options).state.mean,
              track.state.mean);
    // Unless it may have turned so far since it was seen.
    track.state.covariance(kHeading, kHeading) = 0.2 * 0.2;
    EXPECT_NE(sightedTrack(track, glimpse, Neighbourhood(), filter, options).state.mean,
              track.state.mean);
}

// A sliver of its rear between two others, taken for a piece of its left side 0.2 m from its
// right one.
TEST(LastGlimpse, OfAMovingCarAPieceFarInsideOfItsFaceLeavesItsPose)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter{options.motion};
    const Track track = drivenOn(filter);
    Sighting glimpse = sightingMoved(glimpseAt(2.1), kSpeedAhead * 2.1);
    glimpse.measurement.hits = 9;
    glimpse.measurement.box.heading = 0.0;
    glimpse.measurement.box.y -= 1.6;
    glimpse.around.y -= 1.6;
    const auto update = [&](const Sighting& seen)
    { return sightedTrack(track, seen, Neighbourhood(), filter, options).state.mean; };
    EXPECT_NE(update(glimpse), track.state.mean) << "its front alone is hidden";
    glimpse.measurement.hiddenEnds.add(Face::Back);
    EXPECT_EQ(update(glimpse), track.state.mean);
    // Whichever way its box was taken to point,
    glimpse.measurement = turnedBy(glimpse.measurement, 2);
    EXPECT_EQ(update(glimpse), track.state.mean);
    glimpse.measurement = turnedBy(glimpse.measurement, 2);
    // but not where its heading is so vague that the side may lie there,
    Track vague = track;
    vague.state.covariance(kHeading, kHeading) = 0.3 * 0.3;
    EXPECT_NE(sightedTrack(vague, glimpse, Neighbourhood(), filter, options).state.mean,
              track.state.mean);
    // nor where it is foretold.
    glimpse.measurement.box.y += 1.6;
    glimpse.around.y += 1.6;
    EXPECT_NE(update(glimpse), track.state.mean);
}

}  // namespace
}  // namespace vdamf
