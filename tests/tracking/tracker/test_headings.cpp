// SPDX-License-Identifier: BSD-3-Clause
// Which side of a box is taken for the front, where one side or a part of it is in view.
#include <gtest/gtest.h>

#include "tracker/neighbourhood.h"
#include "tracker/track.h"
#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
double degreesOff(double heading, double truth, double period)
{
    return std::abs(std::remainder(heading - truth, period)) * 180.0 / kPi;
}

// A body that drives steadily, seen from where the sensor stands.
struct DrivingBody
{
    OrientedBox box;
    double height = 1.5;
    double speed = 0.0;
    double sensorSpeed = 0.0;
    std::vector<ExampleBody> others = {};
};

// Largest error of the heading in degrees, modulo `period` (rad), from a frame on.
double worstHeading(const DrivingBody& scene, int frames, int from, double period)
{
    Tracker tracker{optionsForBoxes()};
    double worst = 0.0;
    for (int k = 0; k < frames; ++k)
    {
        const double t = 0.1 * k;
        OrientedBox box = scene.box;
        box.x += t * scene.speed * std::cos(box.heading);
        box.y += t * scene.speed * std::sin(box.heading);
        std::vector<ExampleBody> bodies = scene.others;
        bodies.push_back({box, scene.height});
        const FrameResult r = tracker.process(
            exampleFrame(t, {scene.sensorSpeed * t, 0.0}, bodies, 300U + unsigned(k)));
        if (k < from) continue;
        const TrackReport* track = confirmedNear(r, box.centre(), 3.0);
        if (track == nullptr) return 180.0;
        worst = std::max(worst, degreesOff(track->box.heading, box.heading, period));
    }
    return worst;
}

TEST(Headings, RowsAlongAnUnknownHeadingTellNoSizes)
{
    Sighting sighting;
    sighting.measurement.facesSeen.add(Face::Back);
    sighting.measurement.covariance = Matrix5d::Identity() * 1e-3;
    sighting.end = {3.2, 19.0};
    EXPECT_TRUE(sizeCues(sighting, sighting.measurement, 1.5).end);
    for (const double variance : {0.05, 1.2})
    {
        sighting.measurement.covariance(2, 2) = variance;
        EXPECT_FALSE(sizeCues(sighting, sighting.measurement, 1.5).end) << variance;
    }
}

TEST(Headings, RowsLongerThanAnyEndTellSoWhereTheFitSeesNone)
{
    Sighting sighting;
    sighting.measurement.facesSeen.add(Face::Left);
    sighting.measurement.covariance = Matrix5d::Identity() * 1e-3;
    sighting.side = {1.75, 60.0};
    sighting.end = {4.0, 15.0};
    const HeadingCues cues = sizeCues(sighting, sighting.measurement, 1.5);
    ASSERT_TRUE(cues.end);
    EXPECT_LT(axesEvidence(cues), -3.0);
    for (const FaceRow& row : {FaceRow{2.5, 15.0}, FaceRow{4.0, 6.0}})
    {
        sighting.end = row;
        EXPECT_FALSE(sizeCues(sighting, sighting.measurement, 1.5).end) << row.metres;
    }
}

TEST(Headings, OnlyARoofThatIsSeenTellsThatAllOfAVehicleIsLow)
{
    Sighting sighting;
    sighting.isRoofSeen = true;
    sighting.height = 1.5;
    EXPECT_TRUE(sizeCues(sighting, sighting.measurement, 1.5).isHeightSeen);
    EXPECT_FALSE(sizeCues(sighting, sighting.measurement, 2.4).isHeightSeen) << "it was higher";
    sighting.isRoofSeen = false;
    EXPECT_FALSE(sizeCues(sighting, sighting.measurement, 1.5).isHeightSeen);
}

// The left side that a sighting shows was found to be the edge of a shadow.
TEST(Headings, FacesThatWereRuledOutTellNoSizes)
{
    Sighting sighting;
    sighting.measurement.facesSeen.add(Face::Back);
    sighting.measurement.facesSeen.add(Face::Left);
    sighting.measurement.covariance = Matrix5d::Identity() * 1e-3;
    sighting.side = {2.2, 40.0};
    sighting.end = {1.2, 40.0};
    Measurement told = sighting.measurement;
    told.facesSeen.remove(Face::Left);
    EXPECT_TRUE(sizeCues(sighting, sighting.measurement, 1.5).side);
    EXPECT_FALSE(sizeCues(sighting, told, 1.5).side);
    EXPECT_TRUE(sizeCues(sighting, told, 1.5).end);
}

// A parked car is seen from behind, then its left part goes behind a post whose shadow ends on it.
TEST(Headings, TheEdgeOfAShadowTurnsNothing)
{
    const auto rear = [](double time)
    {
        Sighting s;
        s.time = time;
        s.measurement.box = {12.0, -4.0, 0.0, 4.4, 1.8};
        s.measurement.covariance =
            (Vector5d() << 1e-3, 1e-3, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
        s.measurement.facesSeen.add(Face::Back);
        s.measurement.hiddenEnds.add(Face::Front);
        s.measurement.hits = 200;
        s.measurement.match = 0.5;
        s.around = {10.0, -4.0, 0.0, 0.4, 1.8};
        s.height = 1.5;
        s.end = {1.8, 60.0};
        return s;
    };
    const auto rightPart = [&](double time)
    {
        Sighting s = rear(time);
        s.measurement.box = {10.9, -4.3, 0.0, 2.2, 1.2};
        s.measurement.facesSeen.add(Face::Left);
        s.measurement.shadowEdges.add(Face::Left);
        s.measurement.hiddenEnds = {};
        s.around = s.measurement.box;
        s.side = {2.2, 40.0};
        s.end = {1.2, 40.0};
        return s;
    };
    const TrackerOptions options;
    VehicleKalmanFilter filter(options.motion);
    Track track = startedTrack(1, rear(0.0), {0.0, options.lifecycle.startSpeedSigma}, options);
    for (int k = 1; k <= 40; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), k < 9 ? rear(0.1 * k) : rightPart(0.1 * k),
                             Neighbourhood(), filter, options);
        if (k < 9) continue;
        EXPECT_NEAR(track.state.mean(kHeading), 0.0, 0.05) << k;
        EXPECT_GT(track.front.axesProbability(), 0.9) << k;
    }
}

// Of a vehicle that is held across, as what is seen of it may be either face, its way tells more.
TEST(Headings, AVehicleOfKnownCourseDoesNotStandWhenItIsTurnedByAQuarter)
{
    constexpr double kFast = 10.0;  // m/s
    const auto corner = [&](double time)
    {
        Sighting s;
        s.time = time;
        s.measurement.box = {15.0, -20.0 + kFast * time, 0.0, 2.0, 2.0};
        s.measurement.covariance =
            (Vector5d() << 1e-3, 1e-3, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
        s.measurement.facesSeen.add(Face::Back);
        s.measurement.facesSeen.add(Face::Left);
        s.measurement.hiddenEnds.add(Face::Front);
        s.measurement.hiddenEnds.add(Face::Right);
        s.measurement.hits = 50;
        s.measurement.match = 0.5;
        s.around = s.measurement.box;
        s.height = 1.5;
        s.side = s.end = {2.0, 25.0};
        return s;
    };
    const TrackerOptions options;
    VehicleKalmanFilter filter(options.motion);
    Track track = startedTrack(1, corner(0.0), {0.0, options.lifecycle.startSpeedSigma}, options);
    bool isTurned = false;
    for (int k = 1; k <= 30 && !isTurned; ++k)
    {
        track = predictedTrack(std::move(track), 0.1, {0.0, 0.0}, filter, options.motion);
        track = sightedTrack(std::move(track), corner(0.1 * k), Neighbourhood(), filter, options);
        isTurned = track.startedAt == track.sightings;
    }
    ASSERT_TRUE(isTurned);
    EXPECT_NEAR(track.state.mean(kHeading), 0.5 * kPi, 0.1);
    EXPECT_LT(track.hypotheses->standingProbability, 0.01);
    EXPECT_NEAR(track.hypotheses->combined(options.motion).mean(kSpeed), kFast, 1.0);
}

TEST(Headings, WideEndsOfCarsAreNoSides)
{
    EXPECT_LT(worstHeading({{20.0, 0.5, 0.0, 4.6, 2.2}}, 20, 5, kPi), 10.0);
}

TEST(Headings, WideEndsOfTrucksAreNoSides)
{
    EXPECT_LT(worstHeading({{25.0, 0.5, 0.0, 9.0, 2.6}, 2.9}, 20, 5, kPi), 10.0);
}

TEST(Headings, SidesOfCarsAreNoEnds)
{
    EXPECT_LT(worstHeading({{20.0, 0.5, 0.5 * kPi, 4.2, 1.8}}, 20, 5, kPi), 10.0);
}

TEST(Headings, ASideThatComesOutOfHidingIsNoEnd)
{
    // A van hides its rear half at first, less and less as the sensor drives on.
    const DrivingBody scene{
        {22.0, 12.0, 0.0, 4.4, 1.8}, 1.5, 0.0, 6.0, {{{9.0, 6.5, 0.0, 5.0, 2.0}, 2.5}}};
    EXPECT_LT(worstHeading(scene, 30, 18, kPi), 10.0);
}

TEST(Headings, SlowVehiclesHaveTheirFrontAheadSoon)
{
    // Seen from ahead, where new tracks are taken to drive away.
    EXPECT_LT(worstHeading({{25.0, 1.0, kPi, 4.4, 1.8}, 1.5, 1.5}, 25, 12, 2.0 * kPi), 10.0);
}

TEST(Headings, ParkedCarsCloseByKeepTheirs)
{
    // Its side is 2.2 m beside the sensor.
    const DrivingBody scene{{12.0, -3.1, 0.0, 4.4, 1.8}, 1.5, 0.0, 8.0};
    EXPECT_LT(worstHeading(scene, 28, 5, kPi), 3.0);
}

}  // namespace
}  // namespace vdamf
