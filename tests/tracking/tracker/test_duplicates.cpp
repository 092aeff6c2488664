// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
Track trackAt(std::uint64_t id, double x, int misses = 0)
{
    Track track;
    track.id = id;
    track.status = TrackStatus::Confirmed;
    track.misses = misses;
    track.state.mean << x, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    track.state.width = 1.8;
    return track;
}

std::vector<std::uint64_t> goingOn(std::vector<Track> tracks,
                                   const std::vector<OrientedBox>& extents)
{
    std::vector<std::uint64_t> ids;
    for (const Track& track : withDuplicatesEnded(std::move(tracks), extents))
        if (track.status != TrackStatus::Ended) ids.push_back(track.id);
    return ids;
}

std::vector<std::uint64_t> goingOn(const std::vector<Track>& tracks)
{
    std::vector<OrientedBox> boxes;
    for (const Track& track : tracks) boxes.push_back(track.box());
    return goingOn(tracks, boxes);
}

using Ids = std::vector<std::uint64_t>;

TEST(Duplicates, TheOlderTrackGoesOn)
{
    EXPECT_EQ(goingOn({trackAt(1, 10.0), trackAt(2, 11.0)}), (Ids{1}));
    EXPECT_EQ(goingOn({trackAt(1, 10.0, 1), trackAt(2, 11.0, 1)}), (Ids{1}));
}

TEST(Duplicates, UnlessItIsTheOneThatWasLost)
{
    EXPECT_EQ(goingOn({trackAt(1, 10.0, 2), trackAt(2, 11.0)}), (Ids{2}));
}

// More shows than can be its own: what starts anew there is the same vehicle.
TEST(Duplicates, ANewBoxOfALostVehicleTakesItsIdentity)
{
    Track lost = trackAt(1, 10.0, 1);
    lost.status = TrackStatus::Coasting;
    lost.wasPublished = true;
    lost.judgement.probability = 0.9;
    Track fresh = trackAt(5, 11.0);
    fresh.status = TrackStatus::Tentative;
    fresh.judgement.probability = 0.9;
    const auto boxes = [](const Track& a, const Track& b) {
        return std::vector<OrientedBox>{a.box(), b.box()};
    };
    const std::vector<Track> tracks = withDuplicatesEnded({lost, fresh}, boxes(lost, fresh));
    EXPECT_EQ(tracks[0].id, 1u);
    EXPECT_EQ(tracks[0].state.mean(kX), 11.0);
    EXPECT_EQ(tracks[0].status, TrackStatus::Tentative);
    EXPECT_TRUE(tracks[0].wasPublished);
    EXPECT_EQ(tracks[1].id, 5u);
    EXPECT_EQ(tracks[1].status, TrackStatus::Ended);
    EXPECT_FALSE(tracks[1].wasPublished);
    fresh.judgement.probability = 0.2;
    EXPECT_EQ(goingOn({lost, fresh}), (Ids{5})) << "may be no vehicle";
    fresh.judgement.probability = 0.9;
    fresh.status = TrackStatus::Confirmed;
    EXPECT_EQ(goingOn({lost, fresh}), (Ids{5})) << "has been told as another one";
    fresh.status = lost.status = TrackStatus::Tentative;
    EXPECT_EQ(goingOn({lost, fresh}), (Ids{5})) << "was never told";
}

TEST(Duplicates, CarsBumperToBumperAreTwo)
{
    EXPECT_EQ(goingOn({trackAt(1, 10.0), trackAt(2, 14.6)}), (Ids{1, 2}));
}

TEST(Duplicates, CarsStandWithinWhatABushCouldHaveBeen)
{
    const Track bush = trackAt(1, 10.0);
    const Track car = trackAt(2, 11.0);
    EXPECT_EQ(goingOn({bush, car}), (Ids{1}));
    EXPECT_EQ(goingOn({bush, car}, {{8.0, 0.0, 0.0, 0.8, 0.5}, car.box()}), (Ids{1, 2}));
}

TEST(Duplicates, AnEndedTrackEndsNoOther)
{
    Track ended = trackAt(1, 10.0);
    ended.status = TrackStatus::Ended;
    EXPECT_EQ(goingOn({ended, trackAt(2, 10.0)}), (Ids{2}));
    EXPECT_EQ(goingOn({trackAt(1, 10.0), trackAt(2, 11.0), trackAt(3, 12.4)}), (Ids{1, 3}))
        << "the second one is on both, but ended by the first";
    EXPECT_EQ(goingOn({}), Ids{});
}

TEST(Duplicates, AHedgeAroundACarIsNotTheCar)
{
    Track hedge = trackAt(1, 10.0);
    Track car = trackAt(2, 11.0);
    car.judgement.probability = 0.9;
    EXPECT_EQ(goingOn({hedge, car}), (Ids{1})) << "it may be the car as well";
    hedge.judgement.probability = 0.05;
    EXPECT_EQ(goingOn({hedge, car}), (Ids{2}));
    std::swap(hedge.id, car.id);
    EXPECT_EQ(goingOn({car, hedge}), (Ids{1}));
}

}  // namespace
}  // namespace vdamf
