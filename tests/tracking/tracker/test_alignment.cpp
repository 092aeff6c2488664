// SPDX-License-Identifier: BSD-3-Clause
// Where the platform's poses err, parked cars stay parked.
#include "tracker/alignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tracking/tracker/example_frames.h"

namespace vdamf
{
namespace
{
const std::vector<OrientedBox> kParkedCars{{8.0, -4.5, 0.02, 4.4, 1.8},
                                           {15.0, -4.4, -0.01, 4.2, 1.7},
                                           {23.0, -4.6, 0.03, 4.6, 1.8},
                                           {12.0, 5.0, 3.14, 4.3, 1.8},
                                           {26.0, 5.1, 3.12, 4.5, 1.8}};
constexpr double kDrivingBy = 5.0;  // m/s, of the platform and of the car that drives ahead

// The frame as it comes out where the platform's pose errs by a motion about the sensor.
LadarFrame withPoseOff(LadarFrame frame, const PlaneMotion& off)
{
    const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector2d p(frame.points.x[i], frame.points.y[i]);
        const Eigen::Vector2d q = sensor + off.of(p - sensor);
        frame.points.x[i] = static_cast<float>(q.x());
        frame.points.y[i] = static_cast<float>(q.y());
    }
    frame.sensor.head<2>() += off.shift;
    return frame;
}

struct DriveByParked
{
    double fastest = 0.0;    // m/s, of what is parked
    double farthest = 0.0;   // m, of what is parked, from where it stood
    double drivenOff = 0.0;  // m/s, most, of the car ahead
    double farFrom = 0.0;    // m, where the platform believes to be, at the end
    int aligned = 0;         // frames
    int seen = 0;            // parked cars, over all frames
};

// 4 s past parked cars. Errors of the pose walk by `step` (m) and a hundredth of it (rad) a frame.
DriveByParked driveByParked(double step, bool align)
{
    TrackerOptions options = optionsForBoxes();
    options.alignment.enabled = align;
    Tracker tracker{options};
    std::mt19937 random(11);
    std::normal_distribution<double> gauss;
    PlaneMotion off;
    DriveByParked result;
    for (int k = 0; k < 40; ++k)
    {
        const double time = 0.1 * k;
        std::vector<ExampleBody> bodies{{{14.0 + kDrivingBy * time, 0.0, 0.0, 4.4, 1.8}}};
        for (const OrientedBox& box : kParkedCars) bodies.push_back({box});
        const LadarFrame frame =
            exampleFrame(time, {kDrivingBy * time, 0.0}, bodies, 50 + static_cast<unsigned>(k));
        const FrameResult found = tracker.process(withPoseOff(frame, off));
        result.aligned += found.alignment.turn != 0.0 ? 1 : 0;
        result.farFrom = off.shift.norm();
        if (k >= 15)
        {
            for (const OrientedBox& box : kParkedCars)
                if (const TrackReport* track = confirmedNear(found, box.centre()))
                {
                    ++result.seen;
                    result.fastest = std::max(result.fastest, std::abs(track->speed));
                    result.farthest =
                        std::max(result.farthest, (track->box.centre() - box.centre()).norm());
                }
            if (const TrackReport* track = confirmedNear(found, bodies[0].box.centre(), 3.0))
                result.drivenOff = std::max(result.drivenOff, std::abs(track->speed - kDrivingBy));
        }
        off.turn += 0.01 * step * gauss(random);
        off.shift += step * Eigen::Vector2d(gauss(random), gauss(random));
    }
    return result;
}

// A car that stands along the x-axis and is known well.
Track standingAt(double x, double y)
{
    Track track;
    track.stoodProbability = 0.9;
    track.sightings = 5;
    for (VehicleState* state : {&track.state, &track.hypotheses->standing})
    {
        state->mean << x, y, 0.0, 0.0, 0.0, 1.0, 4.4;
        state->covariance = 1e-4 * StateMatrix::Identity();
        state->width = 1.8;
        state->widthVariance = 1e-4;
    }
    return track;
}

// A frame's fit of a track, shifted.
Sighting sightingOfTrack(const Track& track, const Eigen::Vector2d& off)
{
    Sighting seen;
    seen.measurement.box = track.box();
    seen.measurement.box.x += off.x();
    seen.measurement.box.y += off.y();
    seen.measurement.covariance = 1e-4 * Matrix5d::Identity();
    for (const Face face : {Face::Back, Face::Left}) seen.measurement.facesSeen.add(face);
    return seen;
}

TEST(Alignment, KeepsParkedCarsWhereTheyAreThoughPosesErr)
{
    const DriveByParked with = driveByParked(0.1, true);
    const DriveByParked without = driveByParked(0.1, false);
    ASSERT_GT(with.farFrom, 0.4);
    EXPECT_GT(with.seen, 80);
    EXPECT_LT(with.fastest, 0.1);
    EXPECT_LT(with.farthest, 0.4);
    EXPECT_LT(with.drivenOff, 1.0);
    EXPECT_GE(with.aligned, 25);
    EXPECT_EQ(without.aligned, 0);
    EXPECT_GT(without.fastest, 0.5);
}

TEST(Alignment, DoesNothingWherePosesAreGood)
{
    const DriveByParked good = driveByParked(0.005, true);
    EXPECT_EQ(good.aligned, 0);
    EXPECT_LT(good.fastest, 0.1);
}

// Poses jump to and fro by 10 cm and 0.3 degrees; the parked cars tell it, and are behind after 3
// s.
TEST(Alignment, ErrorsThatNothingTellsAnyMoreAreNoSpeed)
{
    Tracker tracker{optionsForBoxes()};
    std::mt19937 random(12);
    std::normal_distribution<double> gauss;
    double squares = 0.0;
    int seen = 0;
    for (int k = 0; k < 60; ++k)
    {
        const double time = 0.1 * k;
        std::vector<ExampleBody> bodies{{{14.0 + kDrivingBy * time, 0.0, 0.0, 4.4, 1.8}}};
        for (const OrientedBox& box : kParkedCars)
            if (k < 30) bodies.push_back({box});
        const PlaneMotion off{0.3 * kDegree * gauss(random),
                              0.1 * Eigen::Vector2d(gauss(random), gauss(random))};
        const LadarFrame frame =
            exampleFrame(time, {kDrivingBy * time, 0.0}, bodies, 90 + static_cast<unsigned>(k));
        const FrameResult found = tracker.process(withPoseOff(frame, off));
        const TrackReport* ahead = confirmedNear(found, bodies[0].box.centre(), 3.0);
        if (k < 32 || ahead == nullptr) continue;
        squares += std::pow(ahead->speed - kDrivingBy, 2);
        ++seen;
    }
    ASSERT_EQ(seen, 28);
    EXPECT_LT(std::sqrt(squares / seen), 0.1) << "m/s";
}

// The platform and the cars stand for minutes, and poses err by 10 cm.
TEST(Alignment, ItsErrorDoesNotGrowWithoutEnd)
{
    AlignmentOptions options;
    Alignment alignment(options);
    const Track car = standingAt(12.0, -4.0);
    const Track other = standingAt(20.0, -5.0);
    std::mt19937 random(13);
    std::normal_distribution<double> gauss;
    TrackReport report;
    report.box = car.box();
    std::vector<double> sigmas;
    for (int k = 0; k < 12000; ++k)
    {
        alignment.goOn({0.0, 0.0}, 0.1 * k);
        const Eigen::Vector2d off(0.1 * gauss(random), 0.1 * gauss(random));
        alignment.motionOf({car, other}, {sightingOfTrack(car, off), sightingOfTrack(other, off)},
                           {});
        if (k % 3000 == 2999)
            sigmas.push_back(std::sqrt(alignment.aligned(report, {0.0, 0.0}).covariance(0, 0)));
    }
    EXPECT_GT(sigmas.front(), 0.0);
    EXPECT_LT(sigmas[3], 1.05 * sigmas[1]) << "after 20 minutes as after 10";
}

// Boxes of first sights err by 6 cm, which over 8 m is a turn by 0.9 degrees.
TEST(Alignment, TakesNoMoreForErrorsOfFirstPosesThanPosesErr)
{
    Alignment alignment{AlignmentOptions()};
    Track car = standingAt(12.0, -4.0);
    Track other = standingAt(20.0, -4.0);
    double off = 0.06;
    for (Track* track : {&car, &other})
    {
        OrientedBox first = track->box();
        first.y += std::exchange(off, -off);
        track->path.push_back({0.0, first, {}});
    }
    std::mt19937 random(14);
    std::normal_distribution<double> gauss;
    for (int k = 0; k < 5; ++k)
    {
        alignment.goOn({0.0, 0.0}, 0.1 * k);
        const Eigen::Vector2d by(0.1 * gauss(random), 0.1 * gauss(random));
        alignment.motionOf({car, other}, {sightingOfTrack(car, by), sightingOfTrack(other, by)},
                           {});
    }
    const PlaneMotion found = alignment.inWorld({0.0, 0.0});
    EXPECT_GT(found.shift.norm(), 0.02) << "poses err, and by that it is moved";
    EXPECT_LT(std::abs(found.turn), 0.2 * kDegree);
}

TEST(Alignment, MovesReportsAndTellsThatTheyAreLessSure)
{
    Alignment alignment{AlignmentOptions()};
    alignment.goOn({0.0, 0.0}, 0.0);
    TrackReport report;
    report.box = {1012.0, 505.0, 0.1, 4.4, 1.8};
    report.measuredBox = report.box;
    report.covariance = 0.01 * Eigen::Matrix4d::Identity();
    const TrackReport same = alignment.aligned(report, {1000.0, 500.0});
    EXPECT_EQ(same.box.x, report.box.x);
    EXPECT_EQ(same.covariance, report.covariance);
}

TEST(Alignment, TakesStandingTracksThatAreKnown)
{
    const Track stands = standingAt(12.0, -4.0);
    Track moves = stands;
    moves.stoodProbability = 0.2;
    Track fresh = stands;
    fresh.sightings = 2;
    Sighting seen;
    seen.measurement.box = {12.1, -4.05, 0.01, 4.4, 1.8};
    seen.measurement.covariance = 1e-4 * Matrix5d::Identity();
    seen.measurement.facesSeen.add(Face::Back);
    seen.measurement.facesSeen.add(Face::Left);
    const auto points = standingPoints({stands, moves, fresh, stands},
                                       {seen, seen, seen, std::nullopt}, VisibilityOptions());
    ASSERT_EQ(points.size(), 1U);
    EXPECT_NEAR(points[0].innovation.value.x(), 0.1, 0.03);
    EXPECT_NEAR(points[0].innovation.value.y(), -0.05, 0.03);
    EXPECT_NEAR(points[0].innovation.value(2), 0.01, 1e-9);
    EXPECT_NEAR(points[0].at.x(), 9.9, 0.1);
}

TEST(Alignment, MovesTracksWithTheirPathsAndVelocities)
{
    Track track;
    track.state.mean << 3.0, 2.0, 0.5, 4.0, 0.0, 1.0, 4.4;
    track.hypotheses->standing = track.state;
    track.hypotheses->free.steering = Steering::Independent;
    track.hypotheses->freeProbability = 0.5;
    track.hypotheses->free.mean << 3.0, 2.0, 0.5, 2.0, 1.0, 0.0, 4.4;
    track.path.push_back({1.0, {3.0, 2.0, 0.5, 4.4, 1.8}, {}});
    const PlaneMotion motion{0.5 * kPi, {1.0, 0.0}};
    const Track moved = movedBy(track, motion);
    const Eigen::Vector2d there(-1.0, 3.0);
    EXPECT_TRUE(moved.box().centre().isApprox(there, 1e-12));
    EXPECT_NEAR(moved.state.mean(kHeading), 0.5 + 0.5 * kPi, 1e-12);
    EXPECT_EQ(moved.state.mean(kSpeed), 4.0);
    EXPECT_TRUE(moved.hypotheses->standing.box().centre().isApprox(there, 1e-12));
    EXPECT_TRUE(moved.path[0].box.centre().isApprox(there, 1e-12));
    EXPECT_NEAR(moved.hypotheses->free.mean(kVelocityX), -1.0, 1e-12);
    EXPECT_NEAR(moved.hypotheses->free.mean(kVelocityY), 2.0, 1e-12);
}

}  // namespace
}  // namespace vdamf
