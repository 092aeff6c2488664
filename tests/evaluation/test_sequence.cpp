// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/sequence.h"

#include <gmock/gmock.h>

#include "../files/temporary_folder.h"
#include "small_sequences.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::uint64_t> trackIds(const ScoredFrame& frame)
{
    std::vector<std::uint64_t> ids;
    for (const TrackRow& row : frame.tracks) ids.push_back(row.report.id);
    return ids;
}

TEST(MakeSequence, BringsRowsTogetherByTime)
{
    Scene scene;
    scene.object(1, "b", carAt(0.0));
    scene.object(0, "b", carAt(0.0));
    scene.object(0, "a", carAt(9.0));
    scene.track(0, 12, carAt(0.0));
    scene.track(0, 3, carAt(0.0));
    scene.track(1, 3, carAt(0.0));
    scene.tracks[0].time += 0.9e-3;
    scene.tracks[1].time -= 0.9e-3;
    ScoringOptions options;
    options.timeTolerance = 2e-3;
    const Sequence sequence = scene.sequence(options);
    ASSERT_EQ(sequence.frames.size(), 2U);
    const ScoredFrame& first = sequence.frames[0];
    EXPECT_NEAR(first.time, timeOf(0), 1e-3);
    ASSERT_EQ(first.truth.size(), 2U);
    EXPECT_EQ(first.truth[0].objectId, "a");
    EXPECT_EQ(first.truth[1].objectId, "b");
    EXPECT_THAT(trackIds(first), ElementsAre(3, 12));
    EXPECT_EQ(sequence.frames[1].truth.size(), 1U);
}

TEST(MakeSequence, OnlyTheLabelledSpanIsScored)
{
    Scene scene;
    for (const int f : {2, 4}) scene.object(f, "a", carAt(0.0));
    for (int f = 0; f < 7; ++f) scene.track(f, 1, carAt(0.0));
    const Sequence sequence = scene.sequence();
    ASSERT_EQ(sequence.frames.size(), 3U);
    EXPECT_NEAR(sequence.frames[0].time, timeOf(2), 1e-6);
    EXPECT_TRUE(sequence.frames[1].truth.empty());
    EXPECT_EQ(sequence.frames[1].tracks.size(), 1U);
    EXPECT_NEAR(sequence.frames[2].time, timeOf(4), 1e-6);
}

TEST(MakeSequence, WithoutTracksAllIsMissed)
{
    const Sequence sequence = lonelyObject(3).sequence();
    ASSERT_EQ(sequence.frames.size(), 3U);
    EXPECT_TRUE(sequence.frames[2].tracks.empty());
}

TEST(MakeSequence, TablesThatDoNotFitAreErrors)
{
    const Scene scene = inPieces(3, 3, 1);
    Scene twice = scene;
    twice.object(1, "a", carAt(5.0));
    EXPECT_THAT(errorOf([&] { twice.sequence(); }),
                HasSubstr("object 'a' stands twice in the frame at 1700000000.100000 s"));
    twice = scene;
    twice.track(2, 1, carAt(5.0));
    EXPECT_THAT(errorOf([&] { twice.sequence(); }),
                HasSubstr("track 1 stands twice in the frame at 1700000000.200000 s"));
    Scene later = scene;
    for (TrackRow& row : later.tracks) row.time += 0.05;
    EXPECT_THAT(
        errorOf([&] { later.sequence(); }),
        HasSubstr("no frame of the truth (1700000000.000000 to 1700000000.200000 s) has a time "
                  "of the tracks (1700000000.050000 to 1700000000.250000 s)"));
    EXPECT_THAT(errorOf([&] { makeSequence({}, scene.tracks, {}); }),
                HasSubstr("the truth has no rows"));
}

TEST(MakeSequence, VehiclesWithHitsCount)
{
    Scene scene;
    for (const std::string& name : truthClasses())
    {
        scene.object(0, name, carAt(0.0)).objectClass = name;
    }
    scene.object(0, "hits 0", carAt(0.0)).points = 0;
    scene.object(0, "hits 1", carAt(0.0)).points = 1;
    const ScoredFrame frame = scene.sequence().frames.at(0);
    std::vector<std::string> counted;
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        if (frame.counts[i]) counted.push_back(frame.truth[i].objectId);
    }
    EXPECT_EQ(frame.truth.size(), 10U);
    EXPECT_THAT(counted, ElementsAre("Bus", "Car", "Tram", "Truck", "Van", "hits 1"));
}

TEST(MakeSequence, OtherClassesCountWhenAskedFor)
{
    Scene scene;
    for (const std::string& name : truthClasses())
        scene.object(0, name, carAt(0.0)).objectClass = name;
    ScoringOptions options;
    options.classes = {"Cyclist", "Pedestrian"};
    const ScoredFrame frame = scene.sequence(options).frames.at(0);
    for (std::size_t i = 0; i < frame.truth.size(); ++i)
    {
        const std::string& name = frame.truth[i].objectClass;
        EXPECT_EQ(frame.counts[i], name == "Cyclist" || name == "Pedestrian") << name;
    }
}

TEST(MakeSequence, PublishedTracksAreScored)
{
    Scene scene = lonelyObject(1);
    scene.track(0, 1, carAt(0.0)).status = TrackStatus::Tentative;
    scene.track(0, 2, carAt(0.0)).status = TrackStatus::Coasting;
    scene.track(0, 3, carAt(0.0)).status = TrackStatus::Ended;
    scene.track(0, 4, carAt(0.0)).vehicleProbability = 0.4;
    scene.track(0, 5, carAt(0.0)).vehicleProbability = 0.6;
    EXPECT_THAT(trackIds(scene.sequence().frames[0]), ElementsAre(2, 4, 5));
    ScoringOptions options;
    options.withTentative = true;
    EXPECT_THAT(trackIds(scene.sequence(options).frames[0]), ElementsAre(1, 2, 4, 5));
    options.onlyVehicles = true;
    EXPECT_THAT(trackIds(scene.sequence(options).frames[0]), ElementsAre(1, 2, 5));
}

/// A sensor at (100, 50) that looks along +y; places are given as range and bearing from there.
OrientedBox placed(double range, double bearing)
{
    return carAt(100.0 - range * std::sin(bearing), 50.0 + range * std::cos(bearing));
}

TEST(MakeSequence, TheRegionIsSeenFromTheSensor)
{
    Scene scene;
    const std::vector<OrientedBox> places = {placed(29.0, 0.0), placed(31.0, 0.0),
                                             placed(20.0, 0.5), placed(20.0, -0.7),
                                             placed(20.0, 3.0)};
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        TruthRow& row = scene.object(0, std::to_string(i), places[i]);
        if (i == 2) row.sensor = PlanePose{100.0, 50.0, kPi / 2};
        OrientedBox wide = places[i];
        wide.x += 5.0;  // overlaps nothing
        scene.track(0, i, wide);
    }
    ScoringOptions options;
    options.maxRange = 30.0;
    const ScoredFrame near = scene.sequence(options).frames.at(0);
    EXPECT_EQ(near.counts, (std::vector<bool>{true, false, true, true, true}));
    EXPECT_THAT(trackIds(near), ElementsAre(0, 2, 3, 4));
    options.maxRange = 0.0;
    options.regionFov = 1.2;
    const ScoredFrame ahead = scene.sequence(options).frames.at(0);
    EXPECT_EQ(ahead.counts, (std::vector<bool>{true, true, true, false, false}));
    EXPECT_THAT(trackIds(ahead), ElementsAre(0, 1, 2));
}

TEST(MakeSequence, AtTheBorderTruthAndTrackMayStandOnDifferentSides)
{
    Scene scene;
    scene.object(0, "in", placed(29.8, 0.0)).sensor = PlanePose{100.0, 50.0, kPi / 2};
    scene.object(0, "out", placed(30.1, 1.0));
    scene.track(0, 1, placed(30.2, 0.0));
    scene.track(0, 2, placed(29.9, 1.0));
    ScoringOptions options;
    options.maxRange = 30.0;
    const ScoredFrame frame = scene.sequence(options).frames.at(0);
    EXPECT_EQ(frame.counts, (std::vector<bool>{true, false}));
    EXPECT_THAT(trackIds(frame), ElementsAre(1, 2));
}

TEST(MakeSequence, TheSensorIsInterpolated)
{
    Scene scene = lonelyObject(6);
    scene.truth[1].sensor = PlanePose{10.0, 0.0, 3.0};
    scene.truth[4].sensor = PlanePose{13.0, -6.0, -3.0};
    for (const int f : {2, 3})
    {
        scene.truth.erase(scene.truth.begin() + 2);
        scene.track(f, 1, carAt(0.0));
    }
    scene.track(0, 1, carAt(0.0));
    const Sequence sequence = scene.sequence();
    ASSERT_EQ(sequence.frames.size(), 6U);
    EXPECT_FALSE(sequence.frames[0].sensor);
    ASSERT_TRUE(sequence.frames[3].sensor);
    EXPECT_NEAR(sequence.frames[3].sensor->x, 12.0, 1e-5);
    EXPECT_NEAR(sequence.frames[3].sensor->y, -4.0, 1e-5);
    // From 3 to -3 rad by way of pi: 2/3 of 0.283 rad on.
    EXPECT_NEAR(sequence.frames[3].sensor->heading, 3.0 + (2 * kPi - 6.0) * 2 / 3 - 2 * kPi, 1e-5);
    EXPECT_FALSE(sequence.frames[5].sensor);
}

TEST(MakeSequence, ARegionWithoutSensorIsAnError)
{
    ScoringOptions options;
    options.maxRange = 30.0;
    EXPECT_THAT(errorOf([&] { lonelyObject(2).sequence(options); }),
                HasSubstr("none at 1700000000.000000 s: fill its columns sensor_x_m, sensor_y_m "
                          "and sensor_heading_rad"));
    options.maxRange = 0.0;
    EXPECT_EQ(lonelyObject(2).sequence(options).frames.size(), 2U);
}

}  // namespace
}  // namespace vdamf
