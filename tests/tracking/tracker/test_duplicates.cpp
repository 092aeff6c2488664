// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/duplicates.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
Track trackAt(std::uint64_t id, double x, double speed, TrackStatus status)
{
    Track track;
    track.id = id;
    track.status = status;
    track.sightings = 5;
    track.misses = status == TrackStatus::Coasting ? 3 : 0;
    track.state.mean << x, 0.0, 0.0, speed, 0.0, 1.2, 4.4;
    track.state.covariance.diagonal() << 0.04, 0.04, 1e-3, 0.04, 1e-4, 0.1, 0.1;
    track.state.width = 1.8;
    return track;
}

TEST(Duplicates, OfTwoThatAreSeenTheOlderStays)
{
    const auto tracks = withoutDuplicates({trackAt(3, 10.0, 5.0, TrackStatus::Confirmed),
                                           trackAt(4, 10.5, 5.0, TrackStatus::Confirmed)});
    EXPECT_EQ(tracks[0].status, TrackStatus::Confirmed);
    EXPECT_EQ(tracks[1].status, TrackStatus::Ended);
}

TEST(Duplicates, NeighboursAreNone)
{
    const auto tracks = withoutDuplicates({trackAt(3, 10.0, 5.0, TrackStatus::Coasting),
                                           trackAt(4, 13.0, 5.0, TrackStatus::Confirmed)});
    EXPECT_EQ(tracks[0].status, TrackStatus::Coasting);
    EXPECT_EQ(tracks[1].status, TrackStatus::Confirmed);
}

TEST(Duplicates, WhatWasLostWaitsForTheNewTrackInItsPlace)
{
    const auto tracks = withoutDuplicates({trackAt(3, 10.0, 5.0, TrackStatus::Coasting),
                                           trackAt(4, 10.5, 0.0, TrackStatus::Tentative)});
    EXPECT_EQ(tracks[0].status, TrackStatus::Coasting);
    EXPECT_EQ(tracks[1].status, TrackStatus::Tentative);
}

TEST(Duplicates, WhatMovesAsTheLostOneIsTheLostOne)
{
    const auto tracks = withoutDuplicates({trackAt(3, 10.0, 5.0, TrackStatus::Coasting),
                                           trackAt(4, 10.5, 5.3, TrackStatus::Confirmed)});
    EXPECT_EQ(tracks[0].id, 3U);
    EXPECT_EQ(tracks[0].status, TrackStatus::Confirmed);
    EXPECT_EQ(tracks[0].state.mean(kX), 10.5) << "where it is seen";
    EXPECT_EQ(tracks[0].sightings, 10);
    EXPECT_EQ(tracks[1].id, 4U);
    EXPECT_EQ(tracks[1].status, TrackStatus::Ended);
}

// A car that was to come past a parked one.
TEST(Duplicates, WhatStandsIsNotTheCarThatDroveThere)
{
    const auto tracks = withoutDuplicates({trackAt(3, 10.0, 8.0, TrackStatus::Coasting),
                                           trackAt(4, 10.5, 0.0, TrackStatus::Confirmed)});
    EXPECT_EQ(tracks[0].status, TrackStatus::Ended);
    EXPECT_EQ(tracks[1].id, 4U);
    EXPECT_EQ(tracks[1].status, TrackStatus::Confirmed);
}

}  // namespace
}  // namespace vdamf
