// SPDX-License-Identifier: BSD-3-Clause
// The steering model against numerical integration and differentiation.
#include "vdamf/tracking/estimation/variable_axis_model.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace vdamf
{
namespace
{
const MotionOptions kOptions;
constexpr double kLength = 4.5;

Vector6d state(double heading, double speed, double curvature, double axis)
{
    return (Vector6d() << 3.0, -2.0, heading, speed, curvature, axis).finished();
}

// Forward, reverse, standstill, straight, both sides of the series' limit, over the wrap.
const Vector6d kStates[] = {
    state(0.3, 10.0, 0.05, 1.3),   state(-2.0, 6.0, -0.2, 1.0),   state(3.1, 8.0, 0.1, 1.3),
    state(1.0, -3.0, 0.15, 1.2),   state(0.5, 0.0, 0.1, 1.3),     state(0.5, 12.0, 0.0, 1.3),
    state(0.5, 10.0, 0.9e-3, 1.3), state(0.5, 10.0, 1.1e-3, 1.3), state(2.0, 1e-9, -0.2, -0.3)};

// d/dt of (x, y, theta, v, kappa, d): models of the header, continuous time.
Vector6d rate(const Vector6d& x)
{
    const double c = std::cos(x(kHeading));
    const double s = std::sin(x(kHeading));
    const double v = x(kSpeed);
    const double dk = x(kAxis) * x(kCurvature);
    Vector6d r = Vector6d::Zero();
    r(kX) = v * (c - dk * s);
    r(kY) = v * (s + dk * c);
    r(kHeading) = v * x(kCurvature);
    return r;  // the step's axis offset is held while it moves
}

TEST(VariableAxisModel, TransitionEqualsRungeKutta)
{
    for (const Vector6d& start : kStates)
    {
        const double dt = 0.1;
        const int steps = 200;
        const double h = dt / steps;
        Vector6d x = start;
        for (int k = 0; k < steps; ++k)
        {
            const Vector6d a = rate(x);
            const Vector6d b = rate(x + 0.5 * h * a);
            const Vector6d c = rate(x + 0.5 * h * b);
            const Vector6d d = rate(x + h * c);
            x += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        const Vector6d y = predictState(start, dt, kLength, kOptions);
        EXPECT_NEAR(y(kX), x(kX), 1e-11) << start.transpose();
        EXPECT_NEAR(y(kY), x(kY), 1e-11) << start.transpose();
        EXPECT_NEAR(wrapAngle(y(kHeading) - x(kHeading)), 0.0, 1e-11) << start.transpose();
        EXPECT_EQ(y(kSpeed), start(kSpeed));
        EXPECT_EQ(y(kCurvature), start(kCurvature));
    }
}

TEST(VariableAxisModel, AxisOffsetReturnsToItsPrior)
{
    Vector6d x = state(0.0, 0.0, 0.0, 2.0);
    x = predictState(x, kOptions.axisTime, kLength, kOptions);
    const double prior = kOptions.axisFraction * kLength;
    EXPECT_NEAR(x(kAxis), prior + (2.0 - prior) * std::exp(-1.0), 1e-12);
}

TEST(VariableAxisModel, JacobianEqualsDifferences)
{
    for (const Vector6d& x : kStates)
    {
        const Matrix6d f = transitionJacobian(x, 0.1, kOptions);
        for (int j = 0; j < 6; ++j)
        {
            const double h = 1e-5;
            const Vector6d e = Vector6d::Unit(j) * h;
            Vector6d difference = predictState(x + e, 0.1, kLength, kOptions) -
                                  predictState(x - e, 0.1, kLength, kOptions);
            difference(kHeading) = wrapAngle(difference(kHeading));
            EXPECT_LT((f.col(j) - difference / (2.0 * h)).norm(), 1e-7)
                << "column " << j << " at " << x.transpose();
        }
    }
}

TEST(VariableAxisModel, ReverseUndoesForward)
{
    Vector6d x = state(0.4, 7.0, 0.12, kOptions.axisFraction * kLength);
    Vector6d y = predictState(x, 0.3, kLength, kOptions);
    y(kSpeed) = -y(kSpeed);
    y = predictState(y, 0.3, kLength, kOptions);
    EXPECT_LT((y - x).head<3>().norm(), 1e-12);
}

TEST(VariableAxisModel, ProcessNoiseEqualsMonteCarloOfItsInputs)
{
    // Constant random acceleration and curvature rate over the step, and the diagonal terms.
    const Vector6d x = state(0.7, 8.0, 0.04, 1.26);
    const double dt = 0.1;
    std::mt19937_64 generator(5);
    std::normal_distribution<double> gauss;
    const double rateSigma = std::min(kOptions.maxCurvatureRate, kOptions.lateralJerk / 64.0);
    const int samples = 20000;
    Matrix6d sum = Matrix6d::Zero();
    const Vector6d mean = predictState(x, dt, kLength, kOptions);
    for (int k = 0; k < samples; ++k)
    {
        const double a = kOptions.accelerationSigma * gauss(generator);
        const double r = rateSigma * gauss(generator);
        Vector6d y = x;
        const int steps = 20;
        for (int i = 0; i < steps; ++i)
        {
            y(kSpeed) += 0.5 * a * dt / steps;
            y(kCurvature) += 0.5 * r * dt / steps;
            y += dt / steps * rate(y + 0.5 * dt / steps * rate(y));
            y(kSpeed) += 0.5 * a * dt / steps;
            y(kCurvature) += 0.5 * r * dt / steps;
        }
        y(kAxis) = mean(kAxis);
        const Vector6d e = y - mean;
        sum += e * e.transpose();
    }
    MotionOptions inputs = kOptions;
    inputs.slipSigma = inputs.headingSigma = inputs.axisSigma = 0.0;
    const Matrix6d q = processNoise(x, dt, inputs);
    const Matrix6d sampled = sum / samples;
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_NEAR(sampled(i, i), q(i, i), 0.05 * q(i, i)) << i;
        for (int j = 0; j < 5; ++j)
            EXPECT_NEAR(sampled(i, j), q(i, j), 0.05 * std::sqrt(q(i, i) * q(j, j))) << i << j;
    }
}

TEST(VariableAxisModel, NoiseDoesNotGrowAtStandstill)
{
    const Matrix6d q = processNoise(state(0.3, 0.0, 0.1, 1.3), 0.1, kOptions);
    EXPECT_EQ(q(kCurvature, kCurvature), 0.0);
    EXPECT_GT(q(kX, kX), 0.0);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(q);
    EXPECT_GE(eigen.eigenvalues()(0), -1e-15);
}

TEST(VariableAxisModel, BoundsHold)
{
    const Vector6d x = withinBounds(state(4.0, 20.0, 0.5, 9.0), kLength, kOptions);
    EXPECT_NEAR(x(kHeading), 4.0 - 2.0 * kPi, 1e-12);
    EXPECT_NEAR(x(kCurvature), 6.0 / 400.0, 1e-12);
    EXPECT_NEAR(x(kAxis), 0.45 * kLength, 1e-12);
    EXPECT_TRUE(problemsOf(kOptions).empty());
}

}  // namespace
}  // namespace vdamf
