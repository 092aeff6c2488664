// SPDX-License-Identifier: BSD-3-Clause
// What tracks are by the truth, and which of them belong together.
#include <gtest/gtest.h>

#include "vdamf/learning/label.h"
#include "vdamf/learning/sample.h"

namespace vdamf
{
namespace
{
TrackRow confirmedAt(std::uint64_t id, double time, double x, double y)
{
    TrackRow row;
    row.time = time;
    row.report.id = id;
    row.report.status = TrackStatus::Confirmed;
    row.report.box = {x, y, 0.0, 4.4, 1.8};
    return row;
}

// Truth and tracks of one frame at time 5.
struct Scene
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;

    void object(const std::string& id, const std::string& objectClass, double x, int points = 100)
    {
        TruthRow row;
        row.time = 5.0;
        row.objectId = id;
        row.objectClass = objectClass;
        row.box = {x, 0.0, 0.0, 4.4, 1.8};
        row.points = points;
        truth.push_back(row);
    }
    void track(std::uint64_t id, double x, double y = 0.0, double time = 5.0)
    {
        tracks.push_back(confirmedAt(id, time, x, y));
    }
    ObjectLabel labelOf(std::uint64_t id) const
    {
        ScoringOptions options;
        options.minPoints = 10;
        for (const LabelledRow& row : labelTracks(truth, tracks, options))
            if (row.track == id) return row.label;
        return ObjectLabel::Unknown;
    }
};

TEST(Labels, AreByWhatTheTrackLiesOn)
{
    Scene scene;
    scene.object("car", "Car", 0.0);
    scene.object("person", "Pedestrian", 20.0);
    scene.object("far", "Van", 40.0, 3);
    scene.track(1, 0.5);
    scene.track(2, 20.0);
    scene.track(3, 40.0);
    scene.track(4, 60.0);
    scene.track(5, 3.6);        // touches the car with its end
    scene.track(6, 0.0, 1.75);  // a hedge beside it that reaches 5 cm into it
    EXPECT_EQ(scene.labelOf(1), ObjectLabel::Vehicle);
    EXPECT_EQ(scene.labelOf(2), ObjectLabel::Clutter);
    EXPECT_EQ(scene.labelOf(3), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(4), ObjectLabel::Clutter);
    EXPECT_EQ(scene.labelOf(5), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(6), ObjectLabel::Clutter);
}

TEST(Labels, AreUnknownWhereTheTruthSaysNothingOfTheTime)
{
    Scene scene;
    scene.object("car", "Car", 0.0);
    scene.truth.push_back(scene.truth.front());
    scene.truth.back().time = 6.0;
    scene.track(1, 60.0, 0.0, 5.5);
    scene.track(2, 60.0, 0.0, 6.0);
    EXPECT_EQ(scene.labelOf(1), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(2), ObjectLabel::Clutter);
}

// A drive whose sector of 90 degrees ahead is labelled: the sensor moves on along x.
struct Drive
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;

    void frame(double time, double sensorX)
    {
        TruthRow row;
        row.time = time;
        row.objectId = "car";
        row.objectClass = "Car";
        row.box = {200.0, 0.0, 0.0, 4.4, 1.8};
        row.points = 100;
        row.sensor = PlanePose{sensorX, 0.0, 0.0};
        truth.push_back(row);
    }
    void track(std::uint64_t id, double time, double x, double y)
    {
        tracks.push_back(confirmedAt(id, time, x, y));
    }
    ObjectLabel labelOf(std::uint64_t id, double time) const
    {
        ScoringOptions options;
        options.minPoints = 10;
        options.regionFov = kPi / 2.0;
        for (const LabelledRow& row : labelTracks(truth, tracks, options))
            if (row.track == id && row.time == time) return row.label;
        return ObjectLabel::Unknown;
    }
};

TEST(Labels, StayWithWhatStandsBehindTheLabelledSector)
{
    Drive drive;
    drive.frame(1.0, 0.0);
    drive.frame(2.0, 30.0);
    drive.track(1, 1.0, 20.0, 5.0);  // a hedge that stays behind
    drive.track(1, 2.0, 20.2, 5.0);
    drive.track(2, 1.0, 20.0, -5.0);  // what moves may be something else by now
    drive.track(2, 2.0, 26.0, -5.0);
    drive.track(3, 2.0, 10.0, 8.0);  // never in the sector
    EXPECT_EQ(drive.labelOf(1, 1.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(1, 2.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(2, 1.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(2, 2.0), ObjectLabel::Unknown);
    EXPECT_EQ(drive.labelOf(3, 2.0), ObjectLabel::Unknown);
}

TEST(Labels, OfVehiclesHoldOutsideOfTheSectorAndWhereTheyAreNotLabelledAnyMore)
{
    Drive drive;
    drive.frame(1.0, 0.0);
    drive.truth[0].box = {-10.0, 3.0, 0.0, 4.4, 1.8};  // labelled although it is behind
    drive.track(1, 1.0, -10.0, 3.0);
    drive.frame(2.0, 0.0);
    drive.track(1, 2.0, -10.1, 3.0);  // not labelled: still the same
    drive.track(2, 1.0, -10.0, 3.0);
    drive.track(2, 2.0, 30.0, 3.0);  // in the sector, but it was a vehicle before
    EXPECT_EQ(drive.labelOf(1, 1.0), ObjectLabel::Vehicle);
    EXPECT_EQ(drive.labelOf(1, 2.0), ObjectLabel::Vehicle);
    EXPECT_EQ(drive.labelOf(2, 2.0), ObjectLabel::Unknown);
}

TEST(Samples, OfOneObjectShareAGroup)
{
    std::vector<ObjectSample> samples;
    for (const std::uint64_t track : {7U, 4U, 9U, 4U})
    {
        ObjectSample s;
        s.track = track;
        s.time = static_cast<double>(samples.size());
        if (track != 9) s.object = "car";
        samples.push_back(s);
    }
    const std::vector<TrackSamples> tracks = groupedByTrack(samples, 2, "drive", "");
    ASSERT_EQ(tracks.size(), 3U);
    EXPECT_EQ(tracks[0].frames.size(), 2U);
    EXPECT_LT(tracks[0].frames[0].time, tracks[0].frames[1].time);
    EXPECT_EQ(tracks[0].group, tracks[1].group);
    EXPECT_NE(tracks[0].group, tracks[2].group);
    EXPECT_EQ(groupedByTrack(samples, 2, "drive", "scene")[2].group, "scene");
}
}  // namespace
}  // namespace vdamf
