// SPDX-License-Identifier: BSD-3-Clause
// MRPT's Kalman template with our model against a textbook filter, and its consistency.
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
VehicleState startState()
{
    VehicleState s;
    s.mean << 10.0, 5.0, 3.1, 8.0, 0.03, 1.26, 4.5;
    StateVector sigma;
    sigma << 0.3, 0.4, 0.1, 2.0, 0.02, 0.4, 0.3;
    s.covariance = sigma.cwiseAbs2().asDiagonal();
    s.width = 1.8;
    s.widthVariance = 0.01;
    return s;
}

BoxMeasurement measurementNear(const VehicleState& s)
{
    BoxMeasurement m;
    m.box << s.mean.head<3>() + Eigen::Vector3d(0.2, -0.1, 0.05), s.mean(kLength) - 0.1, s.width;
    m.box(2) = wrapAngle(m.box(2));
    m.covariance.topLeftCorner<3, 3>() << 0.02, 0.005, 0.001, 0.005, 0.03, 0.0, 0.001, 0.0, 0.001;
    m.covariance(3, 3) = m.covariance(4, 4) = 0.04;
    m.covariance(0, 3) = m.covariance(3, 0) = 0.01;
    return m;
}

TEST(VehicleKalmanFilter, EqualsTextbookFilter)
{
    const MotionOptions options;
    VehicleKalmanFilter filter(options);
    VehicleState s = startState();
    VehicleState reference = s;
    for (int k = 0; k < 30; ++k)
    {
        s = filter.predict(s, 0.1);
        const StateMatrix f = transitionJacobian(reference.mean, 0.1, options);
        const StateMatrix q = processNoise(reference.mean, 0.1, options);
        reference.mean = withinBounds(predictState(reference.mean, 0.1, options), options);
        const double speedAndTurn =
            reference.covariance(kSpeed, kSpeed) * reference.covariance(kCurvature, kCurvature) +
            std::pow(reference.covariance(kSpeed, kCurvature), 2);
        reference.covariance = f * reference.covariance * f.transpose() + q;
        reference.covariance(kHeading, kHeading) += 0.1 * 0.1 * speedAndTurn;
        ASSERT_LT((s.mean - reference.mean).norm(), 1e-10) << k;
        ASSERT_LT((s.covariance - reference.covariance).norm(), 1e-10) << k;

        // What motion tells of the length is not believed; the centre is the fixed point here.
        StateMatrix apart = StateMatrix::Identity();
        apart(kLength, kLength) = 0.0;
        const double lengthVariance = reference.covariance(kLength, kLength);
        reference.covariance = apart * reference.covariance * apart;
        reference.covariance(kLength, kLength) = lengthVariance;
        const BoxMeasurement m = measurementNear(reference);
        Eigen::Matrix<double, 4, 7> h = Eigen::Matrix<double, 4, 7>::Zero();
        h.topLeftCorner<3, 3>().setIdentity();
        h(3, kLength) = 1.0;
        const Eigen::Matrix4d noise = m.covariance.topLeftCorner<4, 4>();
        const Eigen::Matrix4d innovationCovariance =
            h * reference.covariance * h.transpose() + noise;
        Eigen::Vector4d innovation = m.box.head<4>() - h * reference.mean;
        innovation(2) = wrapAngle(innovation(2));
        const Eigen::Matrix<double, 7, 4> gain =
            reference.covariance * h.transpose() * innovationCovariance.inverse();
        // Joseph form.
        const StateMatrix keep = StateMatrix::Identity() - gain * h;
        reference.mean = withinBounds(reference.mean + gain * innovation, options);
        reference.covariance =
            keep * reference.covariance * keep.transpose() + gain * noise * gain.transpose();
        s = filter.update(s, m);
        ASSERT_LT((s.mean - reference.mean).norm(), 1e-9) << k;
        ASSERT_LT((s.covariance - reference.covariance).norm(), 1e-9) << k;
        ASSERT_EQ((s.covariance - s.covariance.transpose()).norm(), 0.0);
    }
}

// Where neither speed nor curvature is known, their product is not either: it is no part of a
// linear model.
TEST(VehicleKalmanFilter, HeadingOfWhatMayTurnEqualsMonteCarlo)
{
    const MotionOptions options;
    VehicleKalmanFilter filter(options);
    VehicleState s;
    s.mean << 0.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.2;
    s.covariance.diagonal() << 1e-4, 1e-4, 1e-6, 16.0, 0.0025, 1e-4, 1e-4;
    const double dt = 0.1;
    const double noise = processNoise(s.mean, dt, options)(kHeading, kHeading);
    std::mt19937 random(5);
    std::normal_distribution<double> speed(0.0, 4.0);
    std::normal_distribution<double> curvature(0.0, 0.05);
    std::normal_distribution<double> heading(0.0, 1e-3);
    constexpr int kSamples = 40000;
    double sum = 0.0;
    for (int k = 0; k < kSamples; ++k)
    {
        StateVector sample = s.mean;
        sample(kHeading) = heading(random);
        sample(kSpeed) = speed(random);
        sample(kCurvature) = curvature(random);
        sum += std::pow(predictState(sample, dt, options)(kHeading), 2);
    }
    const double variance = filter.predict(s, dt).covariance(kHeading, kHeading);
    EXPECT_NEAR(variance - noise, sum / kSamples, 0.05 * sum / kSamples);

    s.covariance(kSpeed, kSpeed) = 1e4;
    EXPECT_LT(filter.predict(s, dt).covariance(kHeading, kHeading), 0.04 * 0.04)
        << "no vehicle turns as fast as that";
}

TEST(VehicleKalmanFilter, HeadingInnovationWraps)
{
    VehicleKalmanFilter filter{MotionOptions()};
    VehicleState s = startState();
    BoxMeasurement m = measurementNear(s);
    m.box(2) = -3.1;  // 0.083 rad ahead of 3.1 over the wrap
    EXPECT_NEAR(innovationOf(s, m).value(2), 2.0 * kPi - 6.2, 1e-12);
    EXPECT_GT(std::abs(filter.update(s, m).mean(kHeading)), 3.1);
}

// Of a car of which only the rear was seen the front is not known, nor the middle; once its side
// shows the front, the middle follows and the speed is what it was.
TEST(VehicleKalmanFilter, LengthMovesTheCentreAndNotTheSpeed)
{
    VehicleKalmanFilter filter{MotionOptions()};
    VehicleState s;
    s.mean << 20.0, 0.0, 0.0, 10.0, 0.0, 1.2, 4.2;
    s.width = 1.8;
    s.widthVariance = 0.01;
    s.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.05, 1e-4, 0.1, 0.25;
    s.covariance(kX, kX) += 0.25 * 0.25;  // the rear is where it was seen
    s.covariance(kX, kLength) = s.covariance(kLength, kX) = 0.5 * 0.25;
    const VehicleState before = filter.predict(s, 0.1);
    BoxMeasurement m;
    m.box << 21.0 + 0.5, 0.0, 0.0, 5.2, 1.8;  // a metre longer, the rear as foretold
    m.covariance.diagonal() << 1e-3, 1e-3, 1e-5, 1e-3, 1e-3;
    m.fixedPoint = {-1.0, 1.0};
    EXPECT_LT(innovationOf(before, m).nis(), 0.1);
    const VehicleState after = filter.update(before, m);
    EXPECT_NEAR(after.mean(kLength), 5.2, 0.05);
    EXPECT_NEAR(after.mean(kX), 21.5, 0.05);
    EXPECT_NEAR(after.mean(kSpeed), 10.0, 0.05);
}

// A rear was seen, and nothing of the length or the width: its place along the course is known to
// centimetres, though the fit's heading is off by 4 degrees.
TEST(VehicleKalmanFilter, WhatIsUnknownAcrossAFaceDoesNotBlurItsPlace)
{
    VehicleState s = startState();
    s.mean << 20.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    s.covariance.setZero();
    s.covariance.diagonal() << 0.01, 0.01, 0.003, 0.0, 0.0, 0.0, 0.01;
    const double heading = 0.07;
    const Eigen::Matrix2d axes = rotation(heading);
    BoxMeasurement m;
    m.fixedPoint = {-1.0, 0.0};
    m.box << 23.0, 0.0, heading, 4.5, 1.8;  // 3 m ahead of the state
    m.covariance(2, 2) = 1e-3;
    // Error of the rear, of the front, and of either side, m.
    const double sigma[4] = {0.04, 50.0, 50.0, 50.0};
    for (int face = 0; face < 4; ++face)
    {
        Vector5d byFace = Vector5d::Zero();
        byFace.head<2>() = 0.5 * axes.col(face / 2);
        byFace(3 + face / 2) = face % 2 == 0 ? -1.0 : 1.0;
        m.covariance += sigma[face] * sigma[face] * byFace * byFace.transpose();
    }
    const double nis = innovationOf(s, m).nis();
    EXPECT_GT(nis, 9.0 / 0.02);
    // The same seen from any side.
    m.box.head<2>() = rotation(1.0) * m.box.head<2>();
    m.box(2) += 1.0;
    Matrix5d turn = Matrix5d::Identity();
    turn.topLeftCorner<2, 2>() = rotation(1.0);
    m.covariance = turn * m.covariance * turn.transpose();
    s.mean.head<2>() = rotation(1.0) * s.mean.head<2>();
    s.mean(kHeading) += 1.0;
    s.covariance.topLeftCorner<2, 2>() =
        rotation(1.0) * s.covariance.topLeftCorner<2, 2>() * rotation(-1.0);
    EXPECT_NEAR(innovationOf(s, m).nis(), nis, 1e-6 * nis);
}

TEST(VehicleKalmanFilter, WidthSaysWhereTheCentreIsBehindOneSide)
{
    VehicleKalmanFilter filter{MotionOptions()};
    VehicleState s = startState();
    s.mean << 0.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    // The left side at y = 1 m; the right one is not told.
    BoxMeasurement m;
    m.box << 0.0, 0.2, 0.0, 4.5, 1.6;
    m.covariance.diagonal() << 1e-3, 1e-4 + 25.0, 1e-5, 1e-3, 1e-4 + 100.0;
    m.covariance(1, 4) = m.covariance(4, 1) = -50.0;
    m.fixedPoint = {0.0, 1.0};
    const VehicleState after = filter.update(s, m);
    EXPECT_NEAR(after.width, 1.8, 0.01);
    EXPECT_NEAR(after.mean(kY) + 0.5 * after.width, 1.0, 0.01);
}

// The front is known, the length is not; then nothing is told along it, from either end.
TEST(VehicleKalmanFilter, WhatStandsKeepsThePlaceOfAnEndWhileNoneIsTold)
{
    constexpr double kOfLength = 0.25;  // variances, m^2
    constexpr double kOfFront = 0.01;
    constexpr double kUntold = 1e4;
    VehicleKalmanFilter filter{MotionOptions()};
    VehicleState s = startState();
    s.mean << 10.0, 5.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    s.covariance = StateMatrix::Zero();
    s.covariance(kY, kY) = 0.01;
    s.covariance(kHeading, kHeading) = 1e-4;
    s.covariance(kX, kX) = kOfFront + 0.25 * kOfLength;
    s.covariance(kX, kLength) = s.covariance(kLength, kX) = -0.5 * kOfLength;
    s.covariance(kLength, kLength) = kOfLength;
    const auto frontVariance = [](const VehicleState& state) {
        return foretoldPoint(state, {1.0, 0.0}).covariance(0, 0);
    };
    ASSERT_NEAR(frontVariance(s), kOfFront, 1e-12);
    for (const double fixed : {-1.0, 1.0, -1.0})
    {
        BoxMeasurement m;
        m.box << s.mean.head<3>(), s.mean(kLength), s.width;
        m.box.x() += 0.7;
        m.fixedPoint = {fixed, 1.0};
        m.covariance.diagonal() << 0.5 * kUntold, 0.01, 0.01, 2.0 * kUntold, 0.01;
        s = filter.update(s, m);
        EXPECT_NEAR(s.mean.x(), 10.0, 0.01) << fixed;
        EXPECT_LT(frontVariance(s), 1.1 * kOfFront) << fixed;
        EXPECT_NEAR(s.covariance(kLength, kLength), kOfLength, 0.01) << fixed;
    }
}

TEST(VehicleKalmanFilter, ZeroTimeChangesNothing)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const VehicleState s = startState();
    EXPECT_EQ(filter.predict(s, 0.0).mean, s.mean);
}

// Vehicles that follow the model with its own noise: NEES and NIS must fit their distributions.
TEST(VehicleKalmanFilter, IsConsistent)
{
    // Bounds that the random vehicles never meet: clipping is not part of the filter's model.
    MotionOptions options;
    options.maxLateralAcceleration = 30.0;
    VehicleKalmanFilter filter(options);
    std::mt19937_64 generator(11);
    std::normal_distribution<double> gauss;
    const auto sample = [&](const StateMatrix& covariance)
    {
        StateVector u;
        for (double& each : u) each = gauss(generator);
        return StateVector(squareRoot(covariance) * u);
    };
    const int runs = 100;
    const int steps = 40;
    double nees = 0.0;
    double nis = 0.0;
    for (int run = 0; run < runs; ++run)
    {
        VehicleState s = startState();
        s.mean(kSpeed) = 10.0;
        s.covariance(kSpeed, kSpeed) = 1.0;
        s.covariance(kAxis, kAxis) = 0.04;
        StateVector truth = s.mean + sample(s.covariance);
        for (int k = 0; k < steps; ++k)
        {
            truth = predictState(truth, 0.1, options) + sample(processNoise(truth, 0.1, options));
            s = filter.predict(s, 0.1);
            BoxMeasurement m;
            m.covariance.diagonal() << 0.01, 0.005, 0.0007, 0.02, 0.01;
            m.box << truth.head<3>(), truth(kLength), s.width;
            for (int i = 0; i < 4; ++i)
                m.box(i) += std::sqrt(m.covariance(i, i)) * gauss(generator);
            nis += innovationOf(s, m).nis();
            s = filter.update(s, m);
        }
        StateVector error = s.mean - truth;
        error(kHeading) = wrapAngle(error(kHeading));
        nees += squaredMahalanobis(error, s.covariance);
    }
    // 95 % bounds: chi-square of 700 degrees of freedom over 100 runs; NIS over 12000 with slack
    // for the linearisation.
    EXPECT_GT(nees / runs, 6.28);
    EXPECT_LT(nees / runs, 7.76);
    EXPECT_NEAR(nis / (runs * steps), 3.0, 0.15);
}

}  // namespace
}  // namespace vdamf
