// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that move while a scanner turns.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <set>
#include <string>

#include "tracking/tracker/example_frames.h"
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
namespace
{
constexpr double kPeriod = 0.1;

const TrackReport* onlyConfirmedNear(const FrameResult& frame, const Eigen::Vector2d& position)
{
    const TrackReport* found = nullptr;
    for (const TrackReport& track : frame.tracks)
    {
        if (track.status != TrackStatus::Confirmed) continue;
        if ((track.box.centre() - position).norm() > 4.0) continue;
        EXPECT_EQ(found, nullptr) << "two tracks on one car at " << frame.time;
        found = &track;
    }
    return found;
}

// The sensor turns from ahead to ahead: a car there is seen at the begin and, 1.5 m farther on, at
// the end of each revolution.
TEST(Revolution, ACarAtItsSeamIsOneCarOfItsOwnSize)
{
    Tracker tracker{optionsForBoxes()};
    std::set<std::uint64_t> ids;
    for (int k = 0; k < 30; ++k)
    {
        const double t = kPeriod * k;
        const OrientedBox truth{18.0 + 15.0 * t, 0.2, 0.0, 4.4, 1.8};
        const FrameResult r = tracker.process(exampleFrame(
            t, {15.0 * t, 0.0}, {{truth, 1.5, {15.0, 0.0}}}, 60U + unsigned(k), kPeriod));
        if (k < 10) continue;
        const TrackReport* track = onlyConfirmedNear(r, truth.centre());
        ASSERT_NE(track, nullptr) << k;
        ids.insert(track->id);
        EXPECT_NEAR(track->speed, 15.0, 0.4) << k;
        EXPECT_NEAR(track->box.width, 1.8, 0.2) << k;
        EXPECT_NEAR(track->box.length, 4.4, 0.6) << k;
        const double rear = track->box.x - 0.5 * track->box.length;
        EXPECT_NEAR(rear, truth.x - 2.2, 0.12) << k;
        EXPECT_LT(std::abs(wrapAngle(track->box.heading)), 3.0 * kPi / 180.0) << k;
    }
    EXPECT_EQ(ids.size(), 1U);
}

// While its speed is not known to the decimetre per second, one of its halves seems to be ahead.
TEST(Revolution, ACarThatBrakesAtItsSeamKeepsItsHeading)
{
    Tracker tracker{optionsForBoxes()};
    double x = 18.0;
    double speed = 15.0;
    double platform = 0.0;
    for (int k = 0; k < 50; ++k)
    {
        const double t = kPeriod * k;
        const OrientedBox truth{x, 0.0, 0.0, 4.4, 1.8};
        const FrameResult r = tracker.process(exampleFrame(
            t, {platform, 0.0}, {{truth, 1.5, {speed, 0.0}}}, 160U + unsigned(k), kPeriod));
        if (k >= 20)
        {
            const TrackReport* track = onlyConfirmedNear(r, truth.centre());
            ASSERT_NE(track, nullptr) << k;
            EXPECT_NEAR(track->speed, speed, 0.8) << k;
            EXPECT_LT(std::abs(wrapAngle(track->box.heading)), 1.7 * kPi / 180.0) << k;
        }
        platform += kPeriod * speed;
        x += kPeriod * speed;
        if (k >= 20) speed = std::max(6.0, speed - kPeriod * 3.0);
    }
}

// Abreast of the sensor a quarter of the revolution has passed before the car is seen.
TEST(Revolution, BoxesStandWhereCarsAreAtTheFramesTime)
{
    Tracker tracker{optionsForBoxes()};
    for (int k = 0; k < 30; ++k)
    {
        const double t = kPeriod * k;
        const OrientedBox truth{-20.0 + 14.0 * t, 7.0, 0.0, 4.4, 1.8};
        const FrameResult r = tracker.process(
            exampleFrame(t, {0.0, 0.0}, {{truth, 1.5, {14.0, 0.0}}}, 90U + unsigned(k), kPeriod));
        if (k < 10) continue;
        const TrackReport* track = onlyConfirmedNear(r, truth.centre());
        ASSERT_NE(track, nullptr) << k;
        EXPECT_NEAR(track->speed, 14.0, 0.5) << k;
        EXPECT_NEAR(track->box.x, truth.x, 0.2) << k;
        EXPECT_NEAR(track->box.length, 4.4, 0.35) << k;
    }
}

struct Drive
{
    const char* name;
    double y;      // m to the left of the sensor
    double start;  // m ahead of it
    double speed;  // m/s
};

std::ostream& operator<<(std::ostream& out, const Drive& drive)
{
    return out << drive.name;
}

// Mean of the centre and the heading (either way round) against the truth at the frames' times.
Eigen::Vector3d meanError(const Drive& drive, double period)
{
    constexpr int kSettled = 12;
    constexpr int kFrames = 28;
    Tracker tracker{optionsForBoxes()};
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < kFrames; ++k)
    {
        const double t = kPeriod * k;
        const OrientedBox truth{drive.start + drive.speed * t, drive.y, 0.0, 4.4, 1.8};
        const FrameResult r = tracker.process(exampleFrame(
            t, {0.0, 0.0}, {{truth, 1.5, {drive.speed, 0.0}}}, 500U + unsigned(k), period));
        if (k < kSettled) continue;
        const TrackReport* track = onlyConfirmedNear(r, truth.centre());
        if (track == nullptr)
        {
            ADD_FAILURE() << "no track at " << t;
            continue;
        }
        sum += Eigen::Vector3d(track->box.x - truth.x, track->box.y - truth.y,
                               0.5 * wrapAngle(2.0 * track->box.heading));
    }
    return sum / (kFrames - kSettled);
}

class FromATurningSensor : public testing::TestWithParam<Drive>
{
};

// As from a sensor that sees all at once: what is left is the fit's, not the motion's.
TEST_P(FromATurningSensor, BoxesAreAsFromAnInstant)
{
    const Eigen::Vector3d turning = meanError(GetParam(), kPeriod);
    const Eigen::Vector3d instant = meanError(GetParam(), 0.0);
    EXPECT_NEAR(turning.x(), instant.x(), 0.03);
    EXPECT_NEAR(turning.y(), instant.y(), 0.03);
    EXPECT_NEAR(turning.z(), instant.z(), 0.3 * kPi / 180.0);
}

INSTANTIATE_TEST_SUITE_P(Cars, FromATurningSensor,
                         testing::Values(Drive{"abreast", 7.0, -20.0, 15.0},
                                         Drive{"oncoming", 6.0, 48.0, -15.0},
                                         Drive{"away_through_the_seam", 0.1, 6.0, 15.0},
                                         Drive{"towards_through_the_seam", 0.1, 50.0, -15.0}),
                         [](const auto& test) { return std::string(test.param.name); });

// The measurement is that of a later time; what it tells is brought back.
TEST(Revolution, AMeasurementOfLaterTellsOfNow)
{
    MotionOptions still;
    still.accelerationSigma = still.maxCurvatureRate = still.slipSigma = still.headingSigma =
        still.axisSigma = still.sizeSigma = 0.0;
    VehicleKalmanFilter filter(still);
    VehicleState now;
    now.mean << 5.0, 2.0, 0.4, 9.0, 0.02, 1.2, 4.4;
    now.covariance.diagonal() << 0.04, 0.04, 1e-3, 1.0, 1e-4, 0.1, 0.05;
    now.width = 1.8;
    now.widthVariance = 0.01;
    BoxMeasurement m;
    const VehicleState then = stateAt(now, 0.08, still);
    m.box << then.mean.head<3>() + Eigen::Vector3d(0.1, -0.05, 0.01), 4.5, 1.8;
    m.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.02, 0.02;
    const VehicleState first = filter.update(then, m);
    m.lag = 0.08;
    const VehicleState later = stateAt(filter.update(now, m), 0.08, still);
    EXPECT_LT((first.mean - later.mean).norm(), 2e-3);
    EXPECT_LT((first.covariance - later.covariance).norm(), 0.01 * first.covariance.norm());
}

// It is beside the sensor for more than a quarter of each revolution.
TEST(Revolution, AParkedCarCloseBesideASlowScannerIsOneCar)
{
    constexpr double kSlow = 0.2;
    Tracker tracker{optionsForBoxes()};
    const OrientedBox truth{0.0, 2.3, 0.0, 4.5, 1.8};
    std::set<std::uint64_t> ids;
    for (int k = 0; k < 12; ++k)
    {
        const FrameResult r = tracker.process(
            exampleFrame(kSlow * k, {0.0, 0.0}, {{truth}}, 260U + unsigned(k), kSlow));
        for (const TrackReport& track : r.tracks) ids.insert(track.id);
        if (k < 6) continue;
        const TrackReport* track = onlyConfirmedNear(r, truth.centre());
        ASSERT_NE(track, nullptr) << k;
        EXPECT_NEAR(track->box.length, 4.5, 0.3) << k;
    }
    EXPECT_EQ(ids.size(), 1U);
}

// Nothing else is hit above the ground, but neither is where scans begin and end.
TEST(Revolution, TwoCarsInAnEmptyFieldAreNotPartsOfOne)
{
    Tracker tracker{optionsForBoxes()};
    const std::vector<ExampleBody> bodies{{{3.5, 18.0, 0.0, 4.5, 1.8}},
                                          {{3.5, -18.5, 0.0, 4.5, 1.8}}};
    const FrameResult first = tracker.process(exampleFrame(0.0, {0.0, 0.0}, bodies, 1U, kPeriod));
    ASSERT_EQ(first.tracks.size(), 2U);
    Tracker untimed{optionsForBoxes()};
    const FrameResult same = untimed.process(exampleFrame(0.0, {0.0, 0.0}, bodies, 1U));
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(first.tracks[k].box.length, same.tracks[k].box.length, 0.05) << k;
}
}  // namespace
}  // namespace vdamf
