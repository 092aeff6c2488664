// SPDX-License-Identifier: BSD-3-Clause
// A whole run in hindsight.
#include "vdamf/tracking/hindsight/hindsight.h"

#include <gtest/gtest.h>

#include "tracking/hindsight/example_history.h"

namespace vdamf
{
namespace
{
// Frames of some tracks, from the first on.
std::vector<FrameResult> framesOf(const std::vector<TrackHistory>& histories)
{
    std::vector<FrameResult> frames;
    for (const TrackHistory& history : histories)
        for (std::size_t k = 0; k < history.size(); ++k)
        {
            if (frames.size() <= k) frames.emplace_back();
            frames[k].time = history[k].time;
            frames[k].tracks.push_back(history[k].report);
        }
    return frames;
}

TrackHistory newCar(std::size_t frames, std::size_t tentative)
{
    TrackHistory history = standingCar(frames);
    for (std::size_t k = 0; k < tentative; ++k) history[k].report.status = TrackStatus::Tentative;
    return history;
}

TEST(Hindsight, TracksAreThereFromWhenTheyWereFirstSeen)
{
    TrackHistory car = newCar(8, 3);
    car[1].report.points = 0;
    car[7].report.status = TrackStatus::Ended;
    const auto frames = inHindsight(framesOf({car}));
    ASSERT_EQ(frames.size(), 8U);
    EXPECT_EQ(frames[0].tracks[0].status, TrackStatus::Confirmed);
    EXPECT_EQ(frames[1].tracks[0].status, TrackStatus::Coasting) << "not measured in this frame";
    EXPECT_EQ(frames[7].tracks[0].status, TrackStatus::Ended);
}

TEST(Hindsight, WhatWasHardlyEverConfirmedStaysAsItIs)
{
    TrackHistory flicker = newCar(8, 6);
    flicker[0].report.box.length = 3.0;
    const auto frames = inHindsight(framesOf({flicker}));
    EXPECT_EQ(frames[0].tracks[0].status, TrackStatus::Tentative);
    EXPECT_EQ(frames[0].tracks[0].box.length, 3.0);
}

TEST(Hindsight, ItIsAVehicleOrNoneAsMostOfItsHitsSay)
{
    TrackHistory car = newCar(10, 2);
    for (std::size_t k = 0; k < 10; ++k)
    {
        const bool isNear = k >= 7;
        car[k].report.points = isNear ? 300 : 30;
        car[k].report.vehicleProbability = isNear ? 0.9 : 0.2;
        car[k].report.isVehicle = isNear;
    }
    TrackHistory unjudged = standingCar(10);
    for (TrackMoment& moment : unjudged) moment.report.id = 8;
    for (const FrameResult& frame : inHindsight(framesOf({car, unjudged})))
    {
        EXPECT_EQ(frame.tracks[0].isVehicle, true);
        EXPECT_NEAR(*frame.tracks[0].vehicleProbability, (900 * 0.9 + 150 * 0.2) / 1050.0, 1e-12);
        EXPECT_FALSE(frame.tracks[1].isVehicle.has_value()) << "no discriminator ran";
        EXPECT_FALSE(frame.tracks[1].vehicleProbability.has_value());
    }
}

TEST(Hindsight, WhatIsNoVehicleHasNoSize)
{
    for (const bool isVehicle : {true, false})
    {
        TrackHistory thing = standingCar(9);
        for (TrackMoment& moment : thing)
        {
            moment.report.vehicleProbability = isVehicle ? 0.9 : 0.1;
            moment.report.isVehicle = isVehicle;
        }
        thing[0].report.box.length = 2.0;
        const auto frames = inHindsight(framesOf({thing}));
        EXPECT_EQ(frames[0].tracks[0].box.length, isVehicle ? 4.4 : 2.0);
    }
}

TEST(Hindsight, WhatIsRuledOutStaysWhereItsHitsAre)
{
    TrackHistory bush = newCar(9, 2);
    for (std::size_t k = 0; k < 9; ++k)
    {
        bush[k].report.vehicleProbability = 0.02;
        bush[k].report.isVehicle = false;
        bush[k].report.isOfHits = true;
        bush[k].report.box = {0.2 * static_cast<double>(k % 3), 0.0, k % 2 == 0 ? 0.3 : 1.87, 3.0,
                              1.0 + 0.1 * static_cast<double>(k)};
    }
    const auto frames = inHindsight(framesOf({bush}));
    for (std::size_t k = 0; k < 9; ++k)
    {
        EXPECT_EQ(frames[k].tracks[0].box, bush[k].report.box);
        EXPECT_EQ(frames[k].tracks[0].status, TrackStatus::Confirmed);
    }
}

TEST(Hindsight, KeepsFramesAndTheirOrder)
{
    TrackHistory one = standingCar(5);
    TrackHistory other = standingCar(5);
    for (std::size_t k = 0; k < 5; ++k)
    {
        other[k].report.id = 9;
        other[k].report.points = static_cast<int>(100 + k);
        other[k].report.nis = 0.5 + static_cast<double>(k);
    }
    const auto frames = inHindsight(framesOf({one, other}));
    ASSERT_EQ(frames.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k)
    {
        ASSERT_EQ(frames[k].tracks.size(), 2U);
        EXPECT_EQ(frames[k].time, one[k].time);
        EXPECT_EQ(frames[k].tracks[0].id, 7U);
        EXPECT_EQ(frames[k].tracks[1].id, 9U);
        EXPECT_EQ(frames[k].tracks[1].points, static_cast<int>(100 + k));
        EXPECT_EQ(frames[k].tracks[1].nis, 0.5 + static_cast<double>(k)) << "of the frame";
    }
    EXPECT_TRUE(inHindsight({}).empty());
}
}  // namespace
}  // namespace vdamf
