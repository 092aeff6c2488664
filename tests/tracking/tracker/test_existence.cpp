// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/existence.h"

#include <gtest/gtest.h>

#include <limits>

#include "tracking/tracker/example_frames.h"

namespace vdamf
{
namespace
{
constexpr float kFar = 100.0F;

// A frame that sees the ground all around but for the bearings from `from` to `to` (rad).
LadarFrame groundAround(double from = 1.0, double to = 1.0)
{
    LadarFrame frame;
    for (double bearing = -3.1; bearing < 3.1; bearing += 0.01)
    {
        if (bearing > from && bearing < to) continue;
        frame.points.x.push_back(static_cast<float>(8.0 * std::cos(bearing)));
        frame.points.y.push_back(static_cast<float>(8.0 * std::sin(bearing)));
        frame.points.z.push_back(0.0F);
    }
    return frame;
}

// Nothing but, from bearing 0 to `to` (rad), something at a range (m).
RangeProfile profileWith(double to, float range)
{
    RangeProfile profile;
    profile.nearest.assign(720, kFar);
    for (std::size_t k = 360; k < 720; ++k)
        if (static_cast<double>(k - 360) * kPi / 360.0 < to) profile.nearest[k] = range;
    return profile;
}

Track trackAhead(double sigmaAcross)
{
    Track track;
    track.status = TrackStatus::Confirmed;
    track.existence = 0.99;
    track.interval = 0.1;
    track.state.mean << 20.0, 0.0, 0.5 * kPi, 0.0, 0.0, 1.2, 4.4;
    track.state.covariance.diagonal() << 0.01, sigmaAcross * sigmaAcross, 1e-3, 0.1, 1e-4, 0.1, 0.1;
    track.state.width = 1.8;
    return track;
}

const OrientedBox kCarAhead{20.0, 0.0, 0.5 * kPi, 4.4, 1.8};

TEST(Existence, SeesThroughWhereNothingStands)
{
    const RangeProfile open = profileWith(0.0, kFar);
    EXPECT_EQ(shareSeenThrough(kCarAhead, {0.0, {0.0, 0.0}, open, FieldOfView(groundAround())}),
              1.0);
}

TEST(Existence, WhatIsBehindSomethingNearerIsHidden)
{
    const RangeProfile half = profileWith(1.0, 9.0F);
    const double share =
        shareSeenThrough(kCarAhead, {0.0, {0.0, 0.0}, half, FieldOfView(groundAround())});
    EXPECT_NEAR(share, 0.5, 0.12);
}

TEST(Existence, HitsInTheBoxAreNotSeenThrough)
{
    const RangeProfile hits = profileWith(1.0, 20.0F);
    EXPECT_LT(shareSeenThrough(kCarAhead, {0.0, {0.0, 0.0}, hits, FieldOfView(groundAround())}),
              0.6);
}

TEST(Existence, WhereTheSensorDoesNotLookNothingIsMissed)
{
    const RangeProfile open = profileWith(0.0, kFar);
    const OpenView view{0.0, {0.0, 0.0}, open, FieldOfView(groundAround(-0.4, 0.4))};
    EXPECT_EQ(shareSeenThrough(kCarAhead, view), 0.0);
}

TEST(Existence, NoHitSpeaksAgainstATrack)
{
    for (const double probability : {0.1, 0.3, 0.9})
    {
        LifecycleOptions options;
        options.hitProbability = probability;
        Track track = trackAhead(0.1);
        const double before = track.existence;
        for (int k = 1; k < 20; ++k) track = withHit(std::move(track), 0.1 * k, options);
        EXPECT_GE(track.existence, before) << probability;
    }
}

TEST(Existence, TracksEndSoonWhereTheyWouldBeSeen)
{
    const RangeProfile open = profileWith(0.0, kFar);
    Track track = trackAhead(0.1);
    for (int k = 1; track.status != TrackStatus::Ended && k < 30; ++k)
        track =
            withMiss(track, {0.1 * k, {0.0, 0.0}, open, FieldOfView(groundAround())}, Unseen(), {});
    EXPECT_EQ(track.status, TrackStatus::Ended);
    EXPECT_LE(track.misses, 7);
    EXPECT_GE(track.misses, 3) << "one missed frame or two are no end";
}

TEST(Existence, HiddenOnesCoastAsLongAsTheyMay)
{
    const RangeProfile wall = profileWith(kPi, 9.0F);
    RangeProfile both = wall;
    std::fill(both.nearest.begin(), both.nearest.end(), 9.0F);
    LifecycleOptions options;
    Track track = trackAhead(0.1);
    int k = 0;
    for (k = 1; track.status != TrackStatus::Ended && k < 100; ++k)
        track = withMiss(track, {0.1 * k, {0.0, 0.0}, both, FieldOfView(groundAround())}, Unseen(),
                         options);
    EXPECT_EQ(track.existence, 0.99);
    EXPECT_NEAR(0.1 * track.misses, options.maxCoast, 0.11);
}

TEST(Existence, HiddenOnesEndOnceTheyMayBeALaneAndAHalfOff)
{
    const RangeProfile wall = profileWith(kPi, 9.0F);
    const auto statusWith = [&](double sigma)
    {
        Track track = trackAhead(sigma);
        track.state.covariance(kX, kX) = sigma * sigma;
        return withMiss(track, {0.1, {0.0, 0.0}, wall, FieldOfView(groundAround())}, Unseen(), {})
            .status;
    };
    EXPECT_EQ(statusWith(4.4), TrackStatus::Coasting);
    EXPECT_EQ(statusWith(4.6), TrackStatus::Ended);
}

TEST(Existence, WhatMayHaveStoppedBehindAWallIsHidden)
{
    const RangeProfile half = profileWith(1.0, 9.0F);
    Track track = trackAhead(2.5);
    track.state.mean(kY) = -4.0;  // in view, if it went on
    const OpenView view{0.0, {0.0, 0.0}, half, FieldOfView(groundAround())};
    EXPECT_EQ(shareSeenThrough(track.box(), view), 1.0);
    EXPECT_LT(shareSeenThrough(track, view), 0.6);
}

TEST(Existence, HitsMakeATrackLastLonger)
{
    const RangeProfile open = profileWith(0.0, kFar);
    const auto framesAfter = [&](int hits)
    {
        Track track = trackAhead(0.1);
        track.existence = 0.5;
        for (int k = 0; k < hits; ++k) track = withHit(track, 0.0, {});
        EXPECT_LE(track.existence, 0.99);
        for (int k = 1; track.status != TrackStatus::Ended && k < 100; ++k)
            track = withMiss(track, {0.1 * k, {0.0, 0.0}, open, FieldOfView(groundAround())},
                             Unseen(), {});
        return track.misses;
    };
    EXPECT_LT(framesAfter(2), framesAfter(10));
    EXPECT_EQ(framesAfter(20), framesAfter(200));
}

TEST(Existence, TracksLastAsLongHoweverFastFramesFollow)
{
    const RangeProfile open = profileWith(0.0, kFar);
    const auto lasts = [&](double interval)
    {
        Track track = trackAhead(0.1);
        track.interval = interval;
        for (int k = 1; track.status != TrackStatus::Ended && k < 100; ++k)
            track = withMiss(track, {interval * k, {0.0, 0.0}, open, FieldOfView(groundAround())},
                             Unseen(), {});
        return track.misses * interval;
    };
    EXPECT_NEAR(lasts(0.05), lasts(0.1), 0.06);
    // Slower ones each see anew.
    EXPECT_NEAR(lasts(0.2), 2.0 * lasts(0.1), 1e-9);
}

TEST(Existence, WhatIsHitInEveryOtherFrameAloneEndsHoweverFastFramesFollow)
{
    const RangeProfile open = profileWith(0.0, kFar);
    for (const double interval : {0.2, 0.1, 0.05, 0.02})
    {
        Track track = trackAhead(0.1);
        track.interval = interval;
        for (int k = 1; k < 400 && track.status != TrackStatus::Ended; k += 2)
        {
            const double time = interval * k;
            track = withHit(track, time, {});
            track =
                withMiss(track, {time + interval, {0.0, 0.0}, open, FieldOfView(groundAround())},
                         Unseen(), {});
        }
        EXPECT_EQ(track.status, TrackStatus::Ended) << interval;
    }
}

TEST(Existence, VehiclesOfFewHitsAreMissedForLonger)
{
    const RangeProfile open = profileWith(0.0, kFar);
    const auto lastsFor = [&](double probability, int hits)
    {
        Track track = trackAhead(0.1);
        track.judgement.probability = probability;
        track.lastHits = hits;
        for (int k = 1; track.status != TrackStatus::Ended && k < 100; ++k)
            track = withMiss(track, {0.1 * k, {0.0, 0.0}, open, FieldOfView(groundAround())},
                             Unseen(), {});
        return track.misses;
    };
    EXPECT_EQ(lastsFor(0.95, 2000), lastsFor(0.5, 2000));
    EXPECT_GT(lastsFor(0.95, 12), lastsFor(0.95, 200) + 2);
    EXPECT_EQ(lastsFor(0.5, 12), lastsFor(0.5, 200)) << "no vehicle for sure";
}

TEST(Existence, FewHitsTellThatItIsThere)
{
    const RangeProfile open = profileWith(0.0, kFar);
    Track track = trackAhead(0.1);
    for (int k = 1; k <= 20; ++k)
        track = withMiss(track, {0.1 * k, {0.0, 0.0}, open, FieldOfView(groundAround())},
                         Unseen{true, true}, {});
    EXPECT_EQ(track.status, TrackStatus::Coasting);
    EXPECT_EQ(track.existence, 0.99);
}

TEST(Existence, NewTracksAreNotWaitedFor)
{
    const RangeProfile wall = profileWith(kPi, 9.0F);
    Track track = trackAhead(0.1);
    track.status = TrackStatus::Tentative;
    track.existence = 0.5;
    for (int k = 1; k <= 2; ++k)
        track =
            withMiss(track, {0.1 * k, {0.0, 0.0}, wall, FieldOfView(groundAround())}, Unseen(), {});
    EXPECT_EQ(track.status, TrackStatus::Ended);
}

TEST(Existence, WhatWasPublishedIsThoughItsBoxWasTurnedSince)
{
    const RangeProfile wall = profileWith(kPi, 9.0F);
    Track track = trackAhead(0.1);
    track.status = TrackStatus::Tentative;
    track.wasPublished = true;
    for (int k = 1; k <= 15; ++k)
        track =
            withMiss(track, {0.1 * k, {0.0, 0.0}, wall, FieldOfView(groundAround())}, Unseen(), {});
    EXPECT_NE(track.status, TrackStatus::Ended);
}

TEST(Existence, ClutterIsNotWaitedForEither)
{
    const RangeProfile wall = profileWith(kPi, 9.0F);
    Track track = trackAhead(0.1);
    for (int k = 1; k < 10 && track.status != TrackStatus::Ended; ++k)
        track = withMiss(track, {0.1 * k, {0.0, 0.0}, wall, FieldOfView(groundAround())},
                         Unseen{false}, {});
    EXPECT_EQ(track.status, TrackStatus::Ended);
    EXPECT_GT(track.misses, 3) << "hits may be missing for a frame or two";
}

}  // namespace
}  // namespace vdamf
