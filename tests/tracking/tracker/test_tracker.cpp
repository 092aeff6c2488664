// SPDX-License-Identifier: BSD-3-Clause
// The frame function on scenes with exact truth.
#include "vdamf/tracking/tracker/tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include "tracking/tracker/example_frames.h"

namespace vdamf
{
namespace
{
ExampleBody carBody(double x, double y, double heading)
{
    return {{x, y, heading, 4.4, 1.8}, 1.5};
}

TEST(Tracker, FollowsAPassingCarFromAMovingPlatform)
{
    Tracker tracker{optionsForBoxes()};
    std::set<std::uint64_t> ids;
    double worstPosition = 0.0;
    double speed = 0.0;
    double heading = 0.0;
    for (int k = 0; k < 40; ++k)
    {
        const double t = 0.1 * k;
        const OrientedBox truth = carBody(30.0 - 9.0 * t, 4.0, kPi).box;
        const FrameResult r = tracker.process(exampleFrame(
            t, {5.0 * t, 0.0}, {{truth, 1.5}, carBody(20.0, -5.0, 0.0)}, 1000U + unsigned(k)));
        EXPECT_EQ(r.time, t);
        if (k < 5) continue;
        const TrackReport* track = confirmedNear(r, truth.centre());
        ASSERT_NE(track, nullptr) << "frame " << k;
        ids.insert(track->id);
        if (k < 15) continue;
        worstPosition = std::max(worstPosition, (track->box.centre() - truth.centre()).norm());
        speed = track->speed;
        heading = track->box.heading;
        EXPECT_NEAR(track->box.length, 4.4, 0.6) << k;
        EXPECT_NEAR(track->box.width, 1.8, 0.5) << k;
    }
    EXPECT_EQ(ids.size(), 1U);
    EXPECT_LT(worstPosition, 0.6);
    EXPECT_NEAR(speed, 9.0, 0.7);
    EXPECT_LT(std::abs(wrapAngle(heading - kPi)), 3.0 * kPi / 180.0);
}

TEST(Tracker, ParkedCarStandsStillWhileThePlatformMoves)
{
    Tracker tracker{optionsForBoxes()};
    std::set<std::uint64_t> ids;
    for (int k = 0; k < 40; ++k)
    {
        const FrameResult r = tracker.process(
            exampleFrame(0.1 * k, {0.8 * k, 0.0}, {carBody(20.0, -4.0, 0.0)}, 7U + unsigned(k)));
        if (k < 10) continue;
        const TrackReport* track = confirmedNear(r, {20.0, -4.0});
        ASSERT_NE(track, nullptr) << k;
        ids.insert(track->id);
        EXPECT_LT(std::abs(track->speed), 0.7) << k;
        EXPECT_LT((track->box.centre() - Eigen::Vector2d(20.0, -4.0)).norm(), 0.7) << k;
    }
    EXPECT_EQ(ids.size(), 1U);
}

TEST(Tracker, KeepsACarThatPassesBehindAVan)
{
    Tracker tracker{optionsForBoxes()};
    const ExampleBody van{{0.0, 10.0, 0.0, 5.0, 2.0}, 2.5};
    std::set<std::uint64_t> before;
    std::set<std::uint64_t> after;
    int hidden = 0;
    for (int k = 0; k < 60; ++k)
    {
        const OrientedBox truth = carBody(-18.0 + 0.6 * k, 18.0, 0.0).box;
        const FrameResult r = tracker.process(
            exampleFrame(0.1 * k, {0.0, 0.0}, {van, {truth, 1.5}}, 40U + unsigned(k)));
        const TrackReport* track = confirmedNear(r, truth.centre());
        if (track == nullptr)
            ++hidden;
        else if (k > 5)
            (k < 30 ? before : after).insert(track->id);
        if (k >= 50)
        {
            ASSERT_NE(track, nullptr) << k;
            EXPECT_NEAR(track->speed, 6.0, 0.7) << k;
        }
    }
    EXPECT_GT(hidden, 5);
    EXPECT_EQ(before.size(), 1U);
    EXPECT_EQ(before, after);
}

TEST(Tracker, SameFramesSameResults)
{
    Tracker a{TrackerOptions()};
    Tracker b{TrackerOptions()};
    for (int k = 0; k < 8; ++k)
    {
        const LadarFrame frame = exampleFrame(
            0.1 * k, {0.0, 0.0}, {carBody(12.0 + 0.5 * k, 3.0, 0.2), carBody(-9.0, 4.0, 1.0)}, 5U);
        const FrameResult ra = a.process(frame);
        const FrameResult rb = b.process(frame);
        ASSERT_EQ(ra.tracks.size(), rb.tracks.size());
        for (std::size_t i = 0; i < ra.tracks.size(); ++i)
        {
            EXPECT_EQ(ra.tracks[i].box.x, rb.tracks[i].box.x);
            EXPECT_EQ(ra.tracks[i].covariance, rb.tracks[i].covariance);
        }
    }
}

TEST(Tracker, LifecycleConfirmsCoastsAndEnds)
{
    TrackerOptions options;
    options.lifecycle.maxCoast = 0.35;
    Tracker tracker{options};
    std::vector<TrackStatus> seen;
    for (int k = 0; k < 12; ++k)
    {
        std::vector<ExampleBody> bodies;
        if (k < 5) bodies.push_back(carBody(15.0, 2.0, 0.4));
        const FrameResult r = tracker.process(exampleFrame(0.1 * k, {0.0, 0.0}, bodies, 3U));
        if (!r.tracks.empty()) seen.push_back(r.tracks.front().status);
    }
    const std::vector<TrackStatus> expected{
        TrackStatus::Tentative, TrackStatus::Tentative, TrackStatus::Confirmed,
        TrackStatus::Confirmed, TrackStatus::Confirmed, TrackStatus::Coasting,
        TrackStatus::Coasting,  TrackStatus::Coasting,  TrackStatus::Ended};
    EXPECT_EQ(seen, expected);
}

TEST(Tracker, WorksFarFromTheOrigin)
{
    Tracker near{TrackerOptions()};
    Tracker far{TrackerOptions()};
    const Eigen::Vector2d shift(20000.0, -13000.0);
    FrameResult a;
    FrameResult b;
    for (int k = 0; k < 10; ++k)
    {
        const OrientedBox box = carBody(14.0 + 0.6 * k, 3.0, 0.1).box;
        OrientedBox moved = box;
        moved.x += shift.x();
        moved.y += shift.y();
        a = near.process(exampleFrame(0.1 * k, {0.0, 0.0}, {{box, 1.5}}, 9U));
        b = far.process(exampleFrame(0.1 * k, shift, {{moved, 1.5}}, 9U));
    }
    ASSERT_FALSE(a.tracks.empty());
    ASSERT_EQ(a.tracks.size(), b.tracks.size());
    EXPECT_NEAR(b.tracks[0].box.x - shift.x(), a.tracks[0].box.x, 5e-3);
    EXPECT_NEAR(b.tracks[0].speed, a.tracks[0].speed, 5e-3);
}

TEST(Tracker, RefusesTimeThatGoesBackAndBadOptions)
{
    Tracker tracker{optionsForBoxes()};
    LadarFrame frame;
    frame.time = 5.0;
    EXPECT_TRUE(tracker.process(frame).tracks.empty());
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    frame.time = std::nan("");
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    frame.time = 6.0;
    frame.origin.y() = std::nan("");
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    frame.origin.y() = 0.0;
    frame.sensor.x() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    frame.sensor.x() = 0.0;
    EXPECT_NO_THROW(tracker.process(frame)) << "what was refused changed nothing";
    TrackerOptions bad;
    bad.lifecycle.minHits = -1;
    bad.measurement.sigma = 99.0;
    EXPECT_EQ(bad.problems().size(), 2U);
    EXPECT_THROW(Tracker{bad}, std::invalid_argument);
    TrackerOptions empty;
    empty.discriminator.loaded = std::make_shared<const DiscriminatorModel>();
    EXPECT_THROW(Tracker{empty}, std::invalid_argument) << "a model without weights";
}

TEST(Tracker, RefusesPointsThatCannotBeMeant)
{
    Tracker tracker{TrackerOptions{}};
    LadarFrame frame = exampleFrame(0.0, {0.0, 0.0}, {{{15.0, 4.0, 0.0, 4.4, 1.8}}}, 1U, 0.1);
    const LadarFrame good = frame;
    for (float& time : frame.points.time) time *= 1e6F;
    EXPECT_THROW(tracker.process(frame), std::invalid_argument) << "microseconds";
    frame = good;
    frame.points.z.pop_back();
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    frame = good;
    frame.points.time.pop_back();
    EXPECT_THROW(tracker.process(frame), std::invalid_argument);
    EXPECT_EQ(tracker.process(good).points, good.points.size()) << "nothing was changed";
    frame = good;
    frame.time = 0.1;
    frame.points.time.back() = std::nanf("");
    EXPECT_NO_THROW(tracker.process(frame)) << "that point is left out";
}

TEST(Tracker, BeginsAnewAfterAnObserverThrew)
{
    Tracker tracker{optionsForBoxes()};
    const OrientedBox car{15.0, 4.0, 0.0, 4.4, 1.8};
    const auto frameAt = [&](int k) {
        return exampleFrame(0.1 * k, {0.0, 0.0}, {{car}}, unsigned(k));
    };
    for (int k = 0; k < 6; ++k) tracker.process(frameAt(k));
    tracker.onStage(
        [](const Stage* stage)
        {
            if (stage != nullptr && *stage == Stage::Update) throw std::runtime_error("observer");
        });
    EXPECT_THROW(tracker.process(frameAt(6)), std::runtime_error);
    tracker.onStage({});
    FrameResult last;
    for (int k = 7; k < 13; ++k) last = tracker.process(frameAt(k));
    const TrackReport* track = confirmedNear(last, car.centre());
    ASSERT_NE(track, nullptr);
    EXPECT_GT(track->id, 1U) << "identities are not given twice";
}

TEST(Tracker, AfterAGapNothingIsKnownAgain)
{
    for (const double gap : {1.5, 20.0, 1e5})
    {
        Tracker tracker{optionsForBoxes()};
        FrameResult before;
        double time = 0.0;
        for (int k = 0; k < 15; ++k)
            before = tracker.process(
                exampleFrame(time += 0.1, {0.0, 0.0}, {carBody(15.0, 2.0, 0.4)}, 3U + unsigned(k)));
        ASSERT_EQ(before.tracks.size(), 1U);
        time += gap;
        const FrameResult after =
            tracker.process(exampleFrame(time, {0.0, 0.0}, {carBody(15.0, 2.0, 0.4)}, 30U));
        if (gap < 2.0)
        {
            ASSERT_EQ(after.tracks.size(), 1U) << gap;
            EXPECT_EQ(after.tracks[0].id, before.tracks[0].id);
            continue;
        }
        ASSERT_EQ(after.tracks.size(), 2U) << gap;
        EXPECT_EQ(after.tracks[0].id, before.tracks[0].id);
        EXPECT_EQ(after.tracks[0].status, TrackStatus::Ended);
        EXPECT_EQ(after.tracks[0].points, 0);
        EXPECT_EQ(after.tracks[0].box.x, before.tracks[0].box.x);
        EXPECT_GT(after.tracks[1].id, before.tracks[0].id);
        EXPECT_TRUE(after.tracks[1].covariance.allFinite());
        EXPECT_LT(after.tracks[1].covariance(0, 0), 1.0);
        EXPECT_EQ(tracker.process(exampleFrame(time + 0.1, {0.0, 0.0}, {}, 31U)).tracks.size(), 1U)
            << "it is told once that a track has ended";
    }
}

TEST(Tracker, NamesItsStagesInOrder)
{
    Tracker tracker{optionsForBoxes()};
    std::vector<std::string> stages;
    tracker.onStage([&](const Stage* s) { stages.push_back(s != nullptr ? toString(*s) : "end"); });
    tracker.process(LadarFrame{});
    EXPECT_EQ(stages, (std::vector<std::string>{"ground removal", "clustering", "prediction",
                                                "association", "matched filter", "update",
                                                "new tracks", "discrimination", "end"}));
}

}  // namespace
}  // namespace vdamf
