// SPDX-License-Identifier: BSD-3-Clause
// What is no vehicle and stands is glanced at most of the time, and measured as soon as it differs.
#include "tracker/glance.h"

#include <gtest/gtest.h>

#include <memory>

#include "tracking/tracker/example_frames.h"

namespace vdamf
{
namespace
{
// Two rows of hits around a middle, as long and as wide as a hedge.
SegmentedFrame hedgeAt(const Eigen::Vector2d& middle, double length)
{
    SegmentedFrame frame;
    frame.time = 2.0;
    Hits hits;
    for (int k = 0; k <= 20; ++k)
        for (const double side : {-0.4, 0.4})
        {
            hits.x.push_back(middle.x() + length * (k / 20.0 - 0.5));
            hits.y.push_back(middle.y() + side);
            hits.weight.push_back(2.0);
            hits.totalWeight += 2.0;
        }
    frame.hits.push_back(hits);
    frame.clusters.resize(1);
    return frame;
}

Track hedge()
{
    Track track;
    track.interval = 0.1;
    track.state.mean << 12.0, 5.0, 0.0, 0.0, 0.0, 1.0, 4.5;
    track.state.width = 1.8;
    track.around = {-0.5, 0.3, 0.0, 3.0, 0.8};
    track.sightings = 10;
    track.status = TrackStatus::Confirmed;
    track.stoodProbability = 0.8;
    track.hypotheses->standingProbability = 0.75;
    return track;
}

const Eigen::Vector2d kMiddle(11.5, 5.3);

// Whether a glance is enough at a hedge that has moved, and is as long now.
bool isEnough(const Track& track, const Eigen::Vector2d& moved, double length, bool mayGrow = false)
{
    return isWhereItWas(track, hedgeAt(kMiddle + moved, length), {0}, mayGrow);
}

const Eigen::Vector2d kNowhere(0.0, 0.0);

TEST(Glance, IsEnoughWhereTheHitsEndWhereTheyDid)
{
    EXPECT_TRUE(isEnough(hedge(), kNowhere, 3.0));
    EXPECT_TRUE(isEnough(hedge(), {0.1, 0.1}, 3.2));
}

TEST(Glance, IsNotEnoughForWhatMovesGrowsShrinksOrWasLost)
{
    EXPECT_FALSE(isEnough(hedge(), {0.5, 0.0}, 3.0));
    EXPECT_FALSE(isEnough(hedge(), {0.0, -0.5}, 3.0));
    EXPECT_FALSE(isEnough(hedge(), kNowhere, 4.0));
    EXPECT_FALSE(isEnough(hedge(), kNowhere, 2.0));
    // One end moves while the other one stays.
    EXPECT_FALSE(isEnough(hedge(), {0.2, 0.0}, 3.4));
    Track moves = hedge();
    moves.stoodProbability = 0.4;
    EXPECT_FALSE(isEnough(moves, kNowhere, 3.0));
    Track lost = hedge();
    lost.misses = 1;
    EXPECT_FALSE(isEnough(lost, kNowhere, 3.0));
}

TEST(Glance, IsNotEnoughBeforeTheSpeedIsKnown)
{
    Track track = hedge();
    track.state.covariance(kSpeed, kSpeed) = 1.0;
    EXPECT_FALSE(isEnough(track, kNowhere, 3.0));
    EXPECT_FALSE(isEnough(track, kNowhere, 3.0, true));
}

TEST(Glance, IsEnoughForWhatGrowsAtOneEndIfItMay)
{
    EXPECT_TRUE(isEnough(hedge(), {1.0, 0.0}, 5.0, true));
    EXPECT_TRUE(isEnough(hedge(), {-0.8, 0.1}, 1.4, true));
    // At both ends, along or across.
    EXPECT_FALSE(isEnough(hedge(), kNowhere, 4.0, true));
    EXPECT_FALSE(isEnough(hedge(), {0.5, 0.0}, 3.0, true));
    EXPECT_FALSE(isEnough(hedge(), {0.0, 0.5}, 3.0, true));
}

TEST(Glance, TellsThatItIsThereAndStandsAndNoMore)
{
    const Track before = hedge();
    const Track after = glancedTrack(before, hedgeAt(kMiddle, 3.0), {0}, LifecycleOptions());
    EXPECT_EQ(after.state.mean, before.state.mean);
    EXPECT_EQ(after.state.covariance, before.state.covariance);
    EXPECT_EQ(after.hypotheses->standingProbability, 0.8);
    EXPECT_EQ(after.hits, 84);
    EXPECT_EQ(after.sightings, 11);
    EXPECT_EQ(after.lastSeen, 2.0);
    EXPECT_GT(after.existence, before.existence);
    EXPECT_FALSE(after.measurement.has_value());
    EXPECT_FALSE(after.nis.has_value());
}

TEST(Glance, TellsHowLargeItIsNow)
{
    const Track after =
        glancedTrack(hedge(), hedgeAt(kMiddle + Eigen::Vector2d(1.0, 0.0), 5.0), {0}, {});
    EXPECT_NEAR(after.boxOfHits().length, 5.0, 1e-9);
    EXPECT_NEAR(after.boxOfHits().x, 12.5, 1e-9);
    EXPECT_EQ(after.state.mean, hedge().state.mean);
}

// A tracker whose discriminator takes everything for the same.
Tracker trackerThatTakesAllFor(double logOdds)
{
    DiscriminatorModel model = untrainedModel();
    model.bias = logOdds;
    TrackerOptions options;
    options.discriminator.loaded = std::make_shared<const DiscriminatorModel>(model);
    return Tracker(options);
}

// Of each frame that shows a standing body, the only track.
std::vector<TrackReport> tracksOf(const ExampleBody& body, double logOdds, int frames)
{
    Tracker tracker = trackerThatTakesAllFor(logOdds);
    std::vector<TrackReport> tracks;
    for (int k = 0; k < frames; ++k)
    {
        const FrameResult result = tracker.process(
            exampleFrame(0.1 * k, {0.0, 0.0}, {body}, 100U + static_cast<unsigned>(k)));
        EXPECT_EQ(result.tracks.size(), 1U);
        tracks.push_back(result.tracks.empty() ? TrackReport() : result.tracks.front());
    }
    return tracks;
}

// Frames in which a standing body was seen and in which it was measured.
struct Looks
{
    int seen = 0;
    int measured = 0;
};

Looks looksAtABody(double logOdds)
{
    const std::vector<TrackReport> tracks =
        tracksOf({{14.0, 4.0, 0.0, 4.0, 1.8}, 1.5, {0.0, 0.0}}, logOdds, 30);
    Looks looks;
    for (std::size_t k = 10; k < tracks.size(); ++k)
    {
        const TrackReport& track = tracks[k];
        EXPECT_EQ(track.id, 1U);
        EXPECT_EQ(track.status, TrackStatus::Confirmed);
        EXPECT_LT(std::abs(track.speed), 0.15);
        looks.seen += track.points > 0 ? 1 : 0;
        looks.measured += track.measuredBox ? 1 : 0;
    }
    return looks;
}

TEST(Glance, SavesMostMeasurementsOfClutterAndNoneOfVehicles)
{
    const Looks clutter = looksAtABody(-1.2);
    EXPECT_EQ(clutter.seen, 20);
    EXPECT_EQ(clutter.measured, 5);
    const Looks surely = looksAtABody(-6.0);
    EXPECT_EQ(surely.seen, 20);
    EXPECT_GE(surely.measured, 2);
    EXPECT_LE(surely.measured, 3);
    const Looks vehicle = looksAtABody(4.0);
    EXPECT_EQ(vehicle.seen, 20);
    EXPECT_EQ(vehicle.measured, 20);
}

// What a tracker that takes all for the same reports of a post 0.6 m wide, 14 m ahead.
OrientedBox boxOfAPost(double logOdds)
{
    return tracksOf({{14.0, 0.0, 0.0, 0.6, 0.6}, 1.5, {0.0, 0.0}}, logOdds, 10).back().box;
}

TEST(Clutter, IsReportedAsLargeAsItsHits)
{
    const OrientedBox clutter = boxOfAPost(-4.0);
    EXPECT_LT(std::max(clutter.length, clutter.width), 0.8);
    EXPECT_LT((clutter.centre() - Eigen::Vector2d(13.7, 0.0)).norm(), 0.15);
    EXPECT_GT(std::max(boxOfAPost(4.0).length, boxOfAPost(4.0).width), 0.85);
}

}  // namespace
}  // namespace vdamf
