// SPDX-License-Identifier: BSD-3-Clause
// How a track takes in sightings that are odd.
#include <gtest/gtest.h>

#include <cmath>

#include "tracker/neighbourhood.h"
#include "tracker/track.h"

namespace vdamf
{
namespace
{
constexpr double kWidth = 1.8;  // m

// The rear of a vehicle that drives ahead, as if it was turned by so much about its rear.
Sighting rearTurnedBy(double turn, double time)
{
    Sighting s;
    s.time = time;
    const Eigen::Vector2d rear(17.85 + 6.0 * time, 0.0);
    const Eigen::Vector2d centre = rear + rotation(turn) * Eigen::Vector2d(2.15, 0.0);
    s.measurement.box = {centre.x(), centre.y(), turn, 4.3, kWidth};
    s.measurement.covariance = (Vector5d() << 1e-3, 1e-3, 4e-3, 4.0, 1e-2).finished().asDiagonal();
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.hits = 30;
    s.measurement.match = 0.5;
    s.around = {rear.x(), rear.y(), turn, 0.1, kWidth};
    s.height = 1.4;
    s.end = {kWidth, 25.0};
    return s;
}

// Half turns away, rad.
double turnAfter(double turn)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter(options.motion);
    Track track = startedTrack(1, rearTurnedBy(0.0, 0.0), {0.0, 16.0}, options);
    for (int k = 1; k < 20; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        const double now = k == 19 ? turn : 0.0;
        track = sightedTrack(std::move(track), rearTurnedBy(now, 0.1 * k), Neighbourhood(), filter,
                             options);
    }
    return std::remainder(track.state.mean(kHeading), kPi);
}

TEST(TrackSightings, AnEndAloneThatSeemsToTurnAtOnceTellsLittle)
{
    EXPECT_NEAR(turnAfter(0.0), 0.0, 1e-3);
    EXPECT_GT(turnAfter(0.1), 0.005) << "what may be is believed as far as it is known";
    EXPECT_LT(std::abs(turnAfter(0.45)), 0.12);
}

TEST(TrackSightings, KeepsTheHitsWhereTheyAreWhenItsBoxMoves)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter(options.motion);
    Track track = startedTrack(1, rearTurnedBy(0.0, 0.0), {0.0, 16.0}, options);
    for (int k = 1; k < 10; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), rearTurnedBy(0.0, 0.1 * k), Neighbourhood(), filter,
                             options);
    }
    track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
    const double before = track.box().x;
    // Its side comes into view, and is longer than was assumed.
    Sighting all = rearTurnedBy(0.0, 1.0);
    all.measurement.box.length = 6.5;
    all.measurement.box.x += 1.1;
    all.measurement.covariance = 1e-3 * Matrix5d::Identity();
    all.measurement.facesSeen.add(Face::Left);
    all.around = all.measurement.box;
    all.side = {6.5, 60.0};
    track = sightedTrack(std::move(track), all, Neighbourhood(), filter, options);
    EXPECT_GT(track.box().x, before + 0.5);
    EXPECT_NEAR(track.boxOfHits().x, all.around.x, 0.01);
}

constexpr double kWall = 10.0;  // m: what is on this side of it is hidden

// The right side of a bus, up to its front, of which a wall hides the rear.
Sighting sideUpTo(double front, double time)
{
    const double seen = front - kWall;
    Sighting s;
    s.time = time;
    s.measurement.box = {front - 0.5 * seen, 12.0, 0.0, seen, 2.5};
    s.measurement.covariance = (Vector5d() << 1e-3, 1e-3, 1e-4, 4e-3, 1e-2).finished().asDiagonal();
    s.measurement.facesSeen.add(Face::Right);
    s.measurement.hiddenEnds.add(Face::Back);
    s.measurement.hits = 100;
    s.measurement.match = 0.4;
    s.around = s.measurement.box;
    s.height = 2.8;
    s.side = {seen, 75.0};
    return s;
}

// Sighted for half a second, to where its front is 8 m before the wall. Of what is seen a part is a
// row of hits without a wide gap.
Track comingOut(double speed, double row = 1.0)
{
    const TrackerOptions options;
    VehicleKalmanFilter filter(options.motion);
    const auto frontAt = [&](double time) { return kWall + 8.0 + speed * (time - 0.5); };
    const auto seenAt = [&](double time)
    {
        Sighting seen = sideUpTo(frontAt(time), time);
        seen.side.metres *= row;
        return seen;
    };
    Track track = startedTrack(1, seenAt(0.0), {0.0, 16.0}, options);
    for (int k = 1; k <= 5; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), seenAt(0.1 * k), Neighbourhood(), filter, options);
    }
    return track;
}

TEST(TrackSightings, ABusThatComesOutFromBehindAWallIsLongerThanWhatIsSeenOfIt)
{
    const VehicleState bus = comingOut(11.0).state;
    EXPECT_GT(bus.mean(kLength), 9.0);
    EXPECT_GT(std::sqrt(bus.covariance(kLength, kLength)), 1.0) << "nothing tells by how much";
    EXPECT_NEAR(bus.mean(kX) + 0.5 * bus.mean(kLength), kWall + 8.0, 0.1) << "its front is seen";
    EXPECT_NEAR(bus.mean(kSpeed), 11.0, 0.5);
}

TEST(TrackSightings, OfWhatStandsBehindAWallNoMoreIsTakenForAVehicle)
{
    EXPECT_NEAR(comingOut(0.0).state.mean(kLength), 8.0, 0.5);
}

TEST(TrackSightings, WhatLiesAheadOfAVehicleMakesNoBusOfIt)
{
    EXPECT_LT(comingOut(11.0, 0.3).state.mean(kLength), 9.0);
}

}  // namespace
}  // namespace vdamf
