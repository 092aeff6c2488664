// SPDX-License-Identifier: BSD-3-Clause
// What the place of a point on a vehicle tells of its length, and what it leaves as it is.
#include "estimation/length_apart.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

namespace vdamf
{
namespace
{
constexpr double kRear = -1.0;
constexpr double kFront = 1.0;

// Heads along x; ends and motion err apart from each other (sigmas, m).
VehicleState withEnds(double rearSigma, double frontSigma)
{
    VehicleState s;
    s.mean << 10.0, 5.0, 0.0, 6.0, 0.0, 1.2, 8.5;
    s.width = 2.5;
    s.widthVariance = 0.01;
    const double rear = rearSigma * rearSigma;
    const double front = frontSigma * frontSigma;
    s.covariance.setZero();
    s.covariance.diagonal() << 0.25 * (rear + front), 0.01, 1e-4, 0.04, 1e-4, 0.04, rear + front;
    s.covariance(kX, kLength) = s.covariance(kLength, kX) = 0.5 * (front - rear);
    return s;
}

// The place of an end alone, whatever the length is (sigma, m).
BoxMeasurement placeOf(double end, double x, double sigma, const VehicleState& state)
{
    constexpr double kUntold = 1e4;  // m^2, of the other end
    const double told = sigma * sigma;
    BoxMeasurement m;
    m.box << x - 0.5 * end * state.mean(kLength), state.mean(kY), 0.0, state.mean(kLength), 2.5;
    m.fixedPoint = {end, 1.0};
    m.covariance.diagonal() << 0.25 * (kUntold + told), 0.01, 0.01, kUntold + told, 0.01;
    m.covariance(0, 3) = m.covariance(3, 0) = 0.5 * end * (told - kUntold);
    return m;
}

double placeOf(const VehicleState& state, double end)
{
    return state.mean(kX) + 0.5 * end * state.mean(kLength);
}

TEST(LengthApart, EndsOfAKnownLengthMoveTogether)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const VehicleState before = withEnds(0.15, 0.1);
    const VehicleState after =
        filter.update(before, placeOf(kRear, placeOf(before, kRear) - 0.2, 0.05, before));
    EXPECT_NEAR(after.mean(kLength), before.mean(kLength), 1e-3);
    EXPECT_NEAR(placeOf(after, kFront) - placeOf(before, kFront), -0.18, 0.01);
}

TEST(LengthApart, TheRearTellsTheLengthWhereTheFrontWasInView)
{
    VehicleKalmanFilter filter{MotionOptions()};
    for (const double seen : {kRear, kFront})
    {
        const VehicleState before = seen == kRear ? withEnds(2.5, 0.2) : withEnds(0.2, 2.5);
        const double other = -seen;
        const VehicleState after =
            filter.update(before, placeOf(seen, placeOf(before, seen) + seen, 0.1, before));
        EXPECT_NEAR(after.mean(kLength), 9.5, 0.02) << seen;
        EXPECT_NEAR(placeOf(after, other), placeOf(before, other), 0.02) << seen;
        EXPECT_NEAR(after.faceSigma(0, seen == kRear ? 0 : 1), 0.1, 0.01) << seen;
        EXPECT_NEAR(after.faceSigma(0, seen == kRear ? 1 : 0), 0.2, 0.01) << seen;
        EXPECT_NEAR(after.mean(kSpeed), 6.0, 1e-9) << "motion is apart";
    }
}

TEST(LengthApart, AVagueFrontTellsNothingOfTheLength)
{
    VehicleKalmanFilter filter{MotionOptions()};
    const VehicleState before = withEnds(2.5, 0.6);
    const VehicleState after =
        filter.update(before, placeOf(kRear, placeOf(before, kRear) - 1.0, 0.1, before));
    EXPECT_NEAR(after.mean(kLength), 8.5, 0.05);
    EXPECT_NEAR(placeOf(after, kRear) - placeOf(before, kRear), -1.0, 0.02);
}

TEST(LengthApart, StaysACovarianceAndKeepsThePlaceThatTheRestIsToldFrom)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 200; ++k)
    {
        VehicleState s = withEnds(1.0, 1.0);
        StateMatrix root;
        for (double& each : root.reshaped()) each = 0.5 * normal(random);
        s.covariance = root * root.transpose();
        s.mean(kHeading) = normal(random);
        for (const double at : {kRear, 0.3, kFront})
        {
            const VehicleState apart = withLengthApart(s, at);
            const Eigen::SelfAdjointEigenSolver<StateMatrix> solver(apart.covariance);
            EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-9);
            EXPECT_NEAR(apart.covariance(kLength, kLength), s.covariance(kLength, kLength), 1e-12);
            EXPECT_NEAR(apart.covariance(kSpeed, kLength), 0.0, 1e-12);
            EXPECT_NEAR(apart.covariance(kSpeed, kSpeed), s.covariance(kSpeed, kSpeed), 1e-12);
        }
    }
}

}  // namespace
}  // namespace vdamf
