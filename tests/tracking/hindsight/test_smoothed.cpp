// SPDX-License-Identifier: BSD-3-Clause
// Motion as later frames tell it.
#include "hindsight/smoothed.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "tracking/hindsight/example_history.h"

namespace vdamf
{
namespace
{
constexpr double kFrameStep = 0.1;  // s

// A vehicle that drives straight on and does what SmoothingNoise says, and an optimal filter that
// measures its place.
struct DrivenAtRandom
{
    std::vector<Eigen::Vector4d> truth;
    TrackHistory history;
};

DrivenAtRandom drivenAtRandom(std::mt19937& random, std::size_t frames)
{
    constexpr double kMeasured = 0.3;  // m
    std::normal_distribution<double> normal;
    using Noise = SmoothingNoise;
    Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
    f(0, 3) = kFrameStep;
    Eigen::Vector4d faster(0.5 * kFrameStep, 0.0, 0.0, 1.0);
    faster *= Noise::kAcceleration * kFrameStep;
    const Eigen::Vector2d wander = Eigen::Vector2d::Constant(Noise::kWander * kFrameStep);
    Eigen::Matrix4d q = faster * faster.transpose();
    q.diagonal().head<2>() += wander.cwiseAbs2();

    DrivenAtRandom s;
    Eigen::Vector4d mean(0.0, 0.0, 0.0, 10.0);
    Eigen::Matrix4d p = Eigen::Vector4d(1.0, 1.0, 0.0, 25.0).asDiagonal();
    Eigen::Vector4d truth =
        mean + Eigen::Vector4d(normal(random), normal(random), 0.0, 5.0 * normal(random));
    for (std::size_t k = 0; k < frames; ++k)
    {
        if (k > 0)
        {
            truth = f * truth + faster * normal(random);
            for (int i = 0; i < 2; ++i) truth(i) += wander(i) * normal(random);
            mean = f * mean;
            p = f * p * f.transpose() + q;
        }
        const Eigen::Vector2d z =
            truth.head<2>() + kMeasured * Eigen::Vector2d(normal(random), normal(random));
        const Eigen::Matrix2d innovation =
            p.topLeftCorner<2, 2>() + kMeasured * kMeasured * Eigen::Matrix2d::Identity();
        const Eigen::Matrix<double, 4, 2> gain = p.leftCols<2>() * innovation.inverse();
        mean += gain * (z - mean.head<2>());
        p -= gain * innovation * gain.transpose();
        TrackMoment moment;
        moment.time = kFrameStep * static_cast<double>(k);
        moment.report.status = TrackStatus::Confirmed;
        moment.report.box = {mean(0), mean(1), mean(2), 4.4, 1.8};
        moment.report.speed = mean(3);
        moment.report.covariance = p;
        s.history.push_back(moment);
        s.truth.push_back(truth);
    }
    return s;
}

TEST(Smoothed, ErrorsAreSmallerAndVariancesOfSpeedsAreTheirs)
{
    std::mt19937 random(41);
    constexpr int kRuns = 1000;
    double ofSpeed = 0.0;
    double before = 0.0;
    double after = 0.0;
    for (int run = 0; run < kRuns; ++run)
    {
        const DrivenAtRandom s = drivenAtRandom(random, 25);
        const TrackReport& filtered = s.history[5].report;
        const TrackReport report = smoothed(s.history)[5].report;
        const auto errorOf = [&](const TrackReport& r)
        {
            const Eigen::Vector4d& t = s.truth[5];
            return Eigen::Vector3d(r.box.x - t(0), r.box.y - t(1), r.speed - t(3));
        };
        ofSpeed += std::pow(errorOf(report).z(), 2) / report.covariance(3, 3) / kRuns;
        before += errorOf(filtered).squaredNorm();
        after += errorOf(report).squaredNorm();
        const Eigen::Matrix4d more = report.covariance - filtered.covariance;
        EXPECT_LT(more.topLeftCorner(3, 3).norm(), 1e-12) << "of the pose what lasts is not known";
    }
    // Chi-square of 1000 degrees of freedom: a standard deviation of 0.045.
    EXPECT_NEAR(ofSpeed, 1.0, 0.15);
    EXPECT_LT(after, 0.6 * before);
}

TEST(Smoothed, SpeedThatIsKnownLaterHoldsBefore)
{
    std::mt19937 random(42);
    TrackHistory history = drivenAtRandom(random, 30).history;
    for (std::size_t k = 0; k < 3; ++k)
    {
        history[k].report.speed = 0.0;
        history[k].report.covariance.diagonal() << 0.1, 0.1, 0.01, 256.0;
    }
    const TrackHistory told = smoothed(history);
    EXPECT_NEAR(told[0].report.speed, told[4].report.speed, 1.5);
    EXPECT_LT(told[0].report.covariance(3, 3), 1.0);
}

TEST(Smoothed, WhatStandsForSureStays)
{
    TrackHistory history = standingCar(10);
    for (TrackMoment& moment : history)
    {
        moment.report.covariance.row(3).setZero();
        moment.report.covariance.col(3).setZero();
    }
    for (const TrackMoment& moment : smoothed(history))
    {
        EXPECT_EQ(moment.report.speed, 0.0);
        EXPECT_EQ(moment.report.box.x, 0.0);
        EXPECT_EQ(moment.report.box.heading, 0.3);
    }
}

TEST(Smoothed, JumpsOfAKnownTrackSpoilNothingBeforeThem)
{
    TrackHistory history = standingCar(10);
    for (std::size_t k = 5; k < 10; ++k) history[k].report.box.x = 4.0;
    const TrackHistory told = smoothed(history);
    for (std::size_t k = 0; k < 5; ++k)
    {
        EXPECT_LT(std::abs(told[k].report.box.x), 0.05) << k;
        EXPECT_LT(std::abs(told[k].report.speed), 0.1) << k;
    }
}

TEST(Smoothed, EndsTellNothing)
{
    TrackHistory history = standingCar(5);
    for (TrackMoment& moment : history)
    {
        moment.report.box.x = 10.0 * moment.time;
        moment.report.box.heading = 0.0;
        moment.report.speed = 10.0;
        moment.report.covariance(3, 3) = 4.0;
    }
    history[4].report.status = TrackStatus::Ended;
    history[4].time = 10.0;
    EXPECT_EQ(smoothed(history)[3].report.speed, 10.0) << "it was not seen to stand since";
}

TEST(Smoothed, ANewTrackWasWhereItTurnedOutToBe)
{
    TrackHistory history = standingCar(10);
    for (std::size_t k = 0; k < 3; ++k)
    {
        TrackReport& report = history[k].report;
        report.status = TrackStatus::Tentative;
        report.box.x = -2.0;
        report.yawRate = 0.5;
        report.covariance(0, 0) = 0.5;
    }
    const TrackHistory told = smoothed(history);
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_LT(std::abs(told[k].report.box.x), 0.3) << k;
        EXPECT_EQ(told[k].report.yawRate, 0.0);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(told[k].report.covariance);
        EXPECT_GE(eigen.eigenvalues()(0), 0.0);
        EXPECT_NEAR(told[k].report.covariance(0, 0), history[3].report.covariance(0, 0), 1e-12);
    }
}

TEST(Smoothed, ATurningVehicleStaysOnItsCircle)
{
    // Its rear axle, 0.28 of the length behind the centre, is what goes where the heading points.
    constexpr double kSpeed = 6.0;
    constexpr double kYawRate = 0.4;
    TrackHistory history = standingCar(40);
    const auto centreAt = [&](double t)
    {
        const double heading = kYawRate * t;
        const double radius = kSpeed / kYawRate;
        const Eigen::Vector2d axle(radius * std::sin(heading), -radius * std::cos(heading));
        return Eigen::Vector2d(axle + 0.28 * 4.4 * rotation(heading).col(0));
    };
    for (TrackMoment& moment : history)
    {
        const Eigen::Vector2d centre = centreAt(moment.time);
        moment.report.box = {centre.x(), centre.y(), wrapAngle(kYawRate * moment.time), 4.4, 1.8};
        moment.report.speed = kSpeed;
        moment.report.yawRate = kYawRate;
    }
    const TrackHistory told = smoothed(history);
    for (std::size_t k = 0; k < told.size(); ++k)
        EXPECT_LT((told[k].report.box.centre() - history[k].report.box.centre()).norm(), 0.01);
}
}  // namespace
}  // namespace vdamf
