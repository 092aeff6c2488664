// SPDX-License-Identifier: BSD-3-Clause
// The steering model against numerical integration and differentiation.
#include "vdamf/tracking/estimation/variable_axis_model.h"

#include <gtest/gtest.h>

#include <random>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
const MotionOptions kMotion;
constexpr double kCarLength = 4.5;

StateVector state(double heading, double speed, double curvature, double axis)
{
    return (StateVector() << 3.0, -2.0, heading, speed, curvature, axis, kCarLength).finished();
}

// Forward, reverse, standstill, straight, both sides of the series' limit, over the wrap.
const StateVector kStates[] = {
    state(0.3, 10.0, 0.05, 1.3),   state(-2.0, 6.0, -0.2, 1.0),   state(3.1, 8.0, 0.1, 1.3),
    state(1.0, -3.0, 0.15, 1.2),   state(0.5, 0.0, 0.1, 1.3),     state(0.5, 12.0, 0.0, 1.3),
    state(0.5, 10.0, 0.9e-3, 1.3), state(0.5, 10.0, 1.1e-3, 1.3), state(2.0, 1e-9, -0.2, -0.3)};

// d/dt of (x, y, theta, v, kappa, d): model of the header, continuous time.
StateVector rate(const StateVector& x)
{
    const double c = std::cos(x(kHeading));
    const double s = std::sin(x(kHeading));
    const double v = x(kSpeed);
    const double dk = x(kAxis) * x(kCurvature);
    StateVector r = StateVector::Zero();
    r(kX) = v * (c - dk * s);
    r(kY) = v * (s + dk * c);
    r(kHeading) = v * x(kCurvature);
    return r;  // the step's axis offset is held while it moves
}

TEST(VariableAxisModel, TransitionEqualsRungeKutta)
{
    for (const StateVector& start : kStates)
    {
        const double dt = 0.1;
        const int steps = 200;
        const double h = dt / steps;
        StateVector x = start;
        for (int k = 0; k < steps; ++k)
        {
            const StateVector a = rate(x);
            const StateVector b = rate(x + 0.5 * h * a);
            const StateVector c = rate(x + 0.5 * h * b);
            const StateVector d = rate(x + h * c);
            x += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        const StateVector y = predictState(start, dt, kMotion);
        EXPECT_NEAR(y(kX), x(kX), 1e-11) << start.transpose();
        EXPECT_NEAR(y(kY), x(kY), 1e-11) << start.transpose();
        EXPECT_NEAR(wrapAngle(y(kHeading) - x(kHeading)), 0.0, 1e-11) << start.transpose();
        EXPECT_EQ(y(kSpeed), start(kSpeed));
        EXPECT_EQ(y(kCurvature), start(kCurvature));
    }
}

TEST(VariableAxisModel, AxisOffsetReturnsToItsPrior)
{
    StateVector x = state(0.0, 0.0, 0.0, 2.0);
    x = predictState(x, kMotion.axisTime, kMotion);
    const double prior = kMotion.axisFraction * kCarLength;
    EXPECT_NEAR(x(kAxis), prior + (2.0 - prior) * std::exp(-1.0), 1e-12);
}

TEST(VariableAxisModel, JacobianEqualsDifferences)
{
    for (const StateVector& x : kStates)
    {
        const StateMatrix f = transitionJacobian(x, 0.1, kMotion);
        for (int j = 0; j < 7; ++j)
        {
            const double h = 1e-5;
            const StateVector e = StateVector::Unit(j) * h;
            StateVector difference =
                predictState(x + e, 0.1, kMotion) - predictState(x - e, 0.1, kMotion);
            difference(kHeading) = wrapAngle(difference(kHeading));
            EXPECT_LT((f.col(j) - difference / (2.0 * h)).norm(), 1e-7)
                << "column " << j << " at " << x.transpose();
        }
    }
}

TEST(VariableAxisModel, ReverseUndoesForward)
{
    StateVector x = state(0.4, 7.0, 0.12, kMotion.axisFraction * kCarLength);
    StateVector y = predictState(x, 0.3, kMotion);
    y(kSpeed) = -y(kSpeed);
    y = predictState(y, 0.3, kMotion);
    EXPECT_LT((y - x).head<3>().norm(), 1e-12);
}

TEST(VariableAxisModel, ProcessNoiseEqualsMonteCarloOfItsInputs)
{
    // Acceleration and curvature rate are white, as strong as if each value held for 0.1 s.
    const StateVector x = state(0.7, 8.0, 0.04, 1.26);
    const double dt = 0.1;
    std::mt19937_64 generator(5);
    std::normal_distribution<double> gauss;
    const double rateSigma = std::min(kMotion.maxCurvatureRate, kMotion.lateralJerk / 64.0);
    const int samples = 20000;
    StateMatrix sum = StateMatrix::Zero();
    const StateVector mean = predictState(x, dt, kMotion);
    for (int k = 0; k < samples; ++k)
    {
        StateVector y = x;
        const int steps = 20;
        const double white = std::sqrt(0.1 * steps / dt);
        for (int i = 0; i < steps; ++i)
        {
            const double a = white * kMotion.accelerationSigma * gauss(generator);
            const double r = white * rateSigma * gauss(generator);
            y(kSpeed) += 0.5 * a * dt / steps;
            y(kCurvature) += 0.5 * r * dt / steps;
            y += dt / steps * rate(y + 0.5 * dt / steps * rate(y));
            y(kSpeed) += 0.5 * a * dt / steps;
            y(kCurvature) += 0.5 * r * dt / steps;
        }
        y(kAxis) = mean(kAxis);
        const StateVector e = y - mean;
        sum += e * e.transpose();
    }
    MotionOptions inputs = kMotion;
    inputs.slipSigma = inputs.headingSigma = inputs.axisSigma = inputs.sizeSigma = 0.0;
    const StateMatrix q = processNoise(x, dt, inputs);
    const StateMatrix sampled = sum / samples;
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_NEAR(sampled(i, i), q(i, i), 0.05 * q(i, i)) << i;
        for (int j = 0; j < 5; ++j)
            EXPECT_NEAR(sampled(i, j), q(i, j), 0.05 * std::sqrt(q(i, i) * q(j, j))) << i << j;
    }
}

TEST(VariableAxisModel, WhatIsLongSteersLess)
{
    StateVector x = state(0.3, 8.0, 0.04, 1.26);
    const auto noise = [&](double length, StateRow row)
    {
        x(kLength) = length;
        return processNoise(x, 0.1, kMotion)(row, row);
    };
    EXPECT_EQ(noise(4.0, kCurvature), noise(5.5, kCurvature));
    EXPECT_NEAR(noise(11.0, kCurvature), 0.25 * noise(5.5, kCurvature), 1e-12);
    EXPECT_EQ(noise(11.0, kSpeed), noise(5.5, kSpeed));
}

TEST(VariableAxisModel, NoiseDoesNotGrowAtStandstill)
{
    const StateMatrix q = processNoise(state(0.3, 0.0, 0.1, 1.3), 0.1, kMotion);
    EXPECT_EQ(q(kCurvature, kCurvature), 0.0);
    EXPECT_GT(q(kX, kX), 0.0);
    EXPECT_GE(smallestEigenvalue(q), -1e-15);
}

TEST(VariableAxisModel, BoundsHold)
{
    const StateVector x = withinBounds(state(4.0, 20.0, 0.5, 9.0), kMotion);
    EXPECT_NEAR(x(kHeading), 4.0 - 2.0 * kPi, 1e-12);
    EXPECT_NEAR(x(kCurvature), 6.0 / 400.0, 1e-12);
    EXPECT_NEAR(x(kAxis), 0.45 * kCarLength, 1e-12);
    EXPECT_TRUE(problemsOf(kMotion).empty());
}

}  // namespace
}  // namespace vdamf
