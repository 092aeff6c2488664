// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/out_of_sight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kRadius = 15.0;  // m, of the bend that is driven
constexpr double kSpeed0 = 6.0;   // m/s
constexpr double kLongest = 8.0;  // s

// A car that goes round and round since time 0, published and in sight.
Track carAt(double time, std::uint64_t id)
{
    const double turned = time * kSpeed0 / kRadius;
    Track car;
    car.id = id;
    car.status = TrackStatus::Confirmed;
    car.wasPublished = true;
    car.judgement.probability = 0.95;
    car.state.mean << kRadius * std::sin(turned), kRadius * (1.0 - std::cos(turned)),
        wrapAngle(turned), kSpeed0, 1.0 / kRadius, 1.2, 4.4;
    car.state.covariance.diagonal() << 0.01, 0.01, 1e-3, 0.04, 1e-4, 0.1, 0.01;
    car.state.width = 1.8;
    car.height = 1.5;
    return car;
}

// The one that was last seen a tenth of a second before.
Track missedAt(double time, std::uint64_t id)
{
    Track car = carAt(time, id);
    car.status = TrackStatus::Coasting;
    car.misses = 1;
    return car;
}

// A new one that nobody was told of yet.
Track foundAt(double time, std::uint64_t id)
{
    Track car = carAt(time, id);
    car.status = TrackStatus::Tentative;
    car.wasPublished = false;
    car.firstSeen = time - 0.3;
    HeadingCues cues;
    cues.course = HeadingCues::Course{0.0, kSpeed0};
    cues.dt = 1.0;
    car.front = car.front.after(cues);
    return car;
}

std::vector<std::uint64_t> goingOn(const std::vector<Track>& tracks)
{
    std::vector<std::uint64_t> ids;
    for (const Track& track : tracks)
        if (track.status != TrackStatus::Ended) ids.push_back(track.id);
    return ids;
}

// Those that go on after car 1 drove out of sight at time 1 and another one was found.
std::vector<std::uint64_t> goingOnAfter(const Track& missed, double time, const Track& found)
{
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missed}, 1.0);
    return goingOn(outOfSight.withReturns({found}, time));
}

// The same where it is still waited for.
std::vector<Track> withEndedOneBeside(Track missed, const Track& found)
{
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missed}, 1.0);
    missed.misses = 36;
    return outOfSight.withReturns({missed, found}, 4.5);
}

using Ids = std::vector<std::uint64_t>;

TEST(OutOfSight, WhatComesBackAfterABendIsTheSameVehicle)
{
    const Track found = foundAt(4.5, 7);
    ASSERT_GT(found.front.forwardProbability(), 0.9);
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missedAt(1.0, 1)}, 1.0);
    const std::vector<Track> tracks = outOfSight.withReturns({carAt(9.0, 3), found}, 4.5);
    ASSERT_EQ(tracks.size(), 3u);
    EXPECT_EQ(tracks[0].id, 1u);
    EXPECT_EQ(tracks[0].state.mean(kX), found.state.mean(kX));
    EXPECT_EQ(tracks[0].status, TrackStatus::Tentative) << "is confirmed as others are";
    EXPECT_EQ(tracks[1].id, 3u);
    EXPECT_EQ(tracks[2].id, 7u);
    EXPECT_EQ(tracks[2].status, TrackStatus::Ended);
}

TEST(OutOfSight, WhatWasForetoldAndIsStillWaitedForGoesOnThere)
{
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missedAt(1.0, 1)}, 1.0);
    Track waitedFor = missedAt(1.0, 1);
    waitedFor.misses = 36;
    waitedFor.state.mean(kX) += 20.0;
    const std::vector<Track> tracks = outOfSight.withReturns({waitedFor, foundAt(4.5, 7)}, 4.5);
    EXPECT_EQ(goingOn(tracks), (Ids{1}));
    EXPECT_EQ(tracks[0].state.mean(kX), carAt(4.5, 1).state.mean(kX));
}

TEST(OutOfSight, OnlyWhatMayHaveDrivenThereIs)
{
    const Track missed = missedAt(1.0, 1);
    ASSERT_EQ(goingOnAfter(missed, 4.5, foundAt(4.5, 7)), (Ids{1}));
    EXPECT_EQ(goingOnAfter(missed, 4.5, foundAt(6.0, 7)), (Ids{7})) << "9 m too far";
    EXPECT_EQ(goingOnAfter(missed, 4.5, foundAt(3.0, 7)), (Ids{7})) << "9 m too near";
    Track found = foundAt(4.5, 7);
    found.state.mean(kSpeed) = 10.0;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "drives faster";
    found = foundAt(4.5, 7);
    found.state.mean(kHeading) -= 1.0;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "another way";
    Track standing = missed;
    standing.state.mean(kSpeed) = 0.5;
    EXPECT_EQ(goingOnAfter(standing, 4.5, foundAt(4.5, 7)), (Ids{7})) << "stood";
}

TEST(OutOfSight, OnlyWhatIsAsLargeIs)
{
    const Track missed = missedAt(1.0, 1);
    Track found = foundAt(4.5, 7);
    found.state.mean(kLength) = 3.6;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{1})) << "a part of it shows";
    found.state.mean(kLength) = 8.0;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "longer";
    found = foundAt(4.5, 7);
    found.state.width = 2.4;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "wider";
    found = foundAt(4.5, 7);
    found.height = 2.2;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "higher";
}

TEST(OutOfSight, OnlyOneOfWhichNobodyWasTold)
{
    const Track missed = missedAt(1.0, 1);
    Track found = foundAt(4.5, 7);
    found.wasPublished = true;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7}));
    found = foundAt(4.5, 7);
    found.status = TrackStatus::Ended;
    EXPECT_EQ(goingOn(withEndedOneBeside(missed, found)), (Ids{1})) << "was another one's";
    found = foundAt(4.5, 7);
    found.firstSeen = 0.5;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "was there before";
    found = foundAt(4.5, 7);
    found.judgement.probability = 0.2;
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "may be no vehicle";
    found = foundAt(4.5, 7);
    found.front = HeadingBelief();
    EXPECT_EQ(goingOnAfter(missed, 4.5, found), (Ids{7})) << "may drive either way";
}

TEST(OutOfSight, WhatMayBeTwoIsNeither)
{
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missedAt(1.0, 1), missedAt(1.2, 2)}, 1.0);
    EXPECT_EQ(goingOn(outOfSight.withReturns({foundAt(4.5, 7)}, 4.5)), (Ids{7}));
    OutOfSight one(kLongest);
    one.withReturns({missedAt(1.0, 1)}, 1.0);
    EXPECT_EQ(goingOn(one.withReturns({foundAt(4.4, 7), foundAt(4.6, 8)}, 4.5)), (Ids{7, 8}));
}

TEST(OutOfSight, WhatIsSeenAgainOrWasUnseenForLongIsForgotten)
{
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missedAt(1.0, 1)}, 1.0);
    outOfSight.withReturns({carAt(1.5, 1)}, 1.5);
    EXPECT_EQ(goingOn(outOfSight.withReturns({foundAt(4.5, 7)}, 4.5)), (Ids{7}));
    OutOfSight brief(3.0);
    brief.withReturns({missedAt(1.0, 1)}, 1.0);
    EXPECT_EQ(goingOn(brief.withReturns({foundAt(4.5, 7)}, 4.5)), (Ids{7}));
}

TEST(OutOfSight, PlacesGoWithTheFrame)
{
    const Eigen::Vector3d back(-30.0, 4.0, 0.0);
    const PlaneMotion turned{0.2, {1.0, -2.0}};
    OutOfSight outOfSight(kLongest);
    outOfSight.withReturns({missedAt(1.0, 1)}, 1.0);
    outOfSight.moveBy(back);
    outOfSight.moveBy(turned);
    Track found = foundAt(4.5, 7);
    found.state.mean.head<2>() =
        turned.of(Eigen::Vector2d(found.state.mean.head<2>() + back.head<2>()));
    found.state.mean(kHeading) = wrapAngle(found.state.mean(kHeading) + turned.turn);
    EXPECT_EQ(goingOn(outOfSight.withReturns({found}, 4.5)), (Ids{1}));
    EXPECT_EQ(goingOnAfter(missedAt(1.0, 1), 4.5, found), (Ids{7}));
}
}  // namespace
}  // namespace vdamf
