// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/variable_axis_model.h"

#include <algorithm>
#include <cmath>

#include "estimation/held_inputs.h"

namespace vdamf
{
namespace
{
// Below this turn within a step the closed forms lose digits and their series take over.
constexpr double kSmallTurn = 1e-3;

// Displacement of the centre in the old body frame over arc length s, ahead (a) and left (b), with
// derivatives by kappa.
struct Displacement
{
    double a, b, aKappa, bKappa;
};

Displacement displacement(double s, double kappa, double d)
{
    const double eta = kappa * s;
    const auto [c, z] = directionOf(eta);
    const double eta2 = eta * eta;
    if (std::abs(eta) < kSmallTurn)
    {
        const double oneMinusC = eta2 * (0.5 - eta2 / 24.0);
        const double sinEta = eta * (1.0 - eta2 / 6.0);
        return {s * (1.0 - eta2 / 6.0 + eta2 * eta2 / 120.0) - d * oneMinusC,
                s * eta * (0.5 - eta2 / 24.0) + d * sinEta,
                s * s * eta * (-1.0 / 3.0 + eta2 / 30.0) - d * s * z,
                s * s * (0.5 - eta2 / 8.0 + eta2 * eta2 / 144.0) + d * s * c};
    }
    return {z / kappa - d * (1.0 - c), (1.0 - c) / kappa + d * z,
            (eta * c - z) / (kappa * kappa) - d * s * z,
            (eta * z - (1.0 - c)) / (kappa * kappa) + d * s * c};
}

// How x, y and heading are moved, t seconds later, by a unit change of another row now:
// g1 t + g2 t^2.
struct Influence
{
    Eigen::Vector3d g1, g2;
};

// Covariance from changes of that row of unit variance per second over dt: the integral of g g^T.
StateMatrix accumulated(const Influence& g, StateRow row, double dt)
{
    const double dt2 = dt * dt;
    // Worked out before they are scaled: symmetric to the last bit.
    const Eigen::Matrix3d g11 = g.g1 * g.g1.transpose();
    const Eigen::Matrix3d g12 = g.g1 * g.g2.transpose();
    const Eigen::Matrix3d g22 = g.g2 * g.g2.transpose();
    const Eigen::Vector3d withRow = dt2 / 2.0 * g.g1 + dt2 * dt / 3.0 * g.g2;
    StateMatrix q = StateMatrix::Zero();
    q.topLeftCorner<3, 3>() = dt2 * dt / 3.0 * g11 + dt2 * dt2 / 4.0 * (g12 + g12.transpose()) +
                              dt2 * dt2 * dt / 5.0 * g22;
    q.block<3, 1>(0, row) = withRow;
    q.block<1, 3>(row, 0) = withRow.transpose();
    q(row, row) = dt;
    return q;
}
}  // namespace

StateVector predictState(const StateVector& x, double dt, const MotionOptions& options)
{
    const double s = x(kSpeed) * dt;
    const Displacement move = displacement(s, x(kCurvature), x(kAxis));
    const Eigen::Vector2d world = rotation(x(kHeading)) * Eigen::Vector2d(move.a, move.b);
    const double prior = options.axisFraction * x(kLength);
    StateVector y = x;
    y(kX) += world.x();
    y(kY) += world.y();
    y(kHeading) = wrapAngle(x(kHeading) + x(kCurvature) * s);
    y(kAxis) = prior + (x(kAxis) - prior) * std::exp(-dt / options.axisTime);
    return y;
}

StateMatrix transitionJacobian(const StateVector& x, double dt, const MotionOptions& options)
{
    const double kappa = x(kCurvature);
    const double d = x(kAxis);
    const double s = x(kSpeed) * dt;
    const double eta = kappa * s;
    const auto [cosEta, sinEta] = directionOf(eta);
    const Displacement move = displacement(s, kappa, d);
    const Eigen::Matrix2d r = rotation(x(kHeading));
    StateMatrix f = StateMatrix::Identity();
    f.block<2, 1>(kX, kHeading) = r * Eigen::Vector2d(-move.b, move.a);
    f.block<2, 1>(kX, kSpeed) =
        dt * (r * Eigen::Vector2d(cosEta - d * kappa * sinEta, sinEta + d * kappa * cosEta));
    f.block<2, 1>(kX, kCurvature) = r * Eigen::Vector2d(move.aKappa, move.bKappa);
    f.block<2, 1>(kX, kAxis) = r * Eigen::Vector2d(-(1.0 - cosEta), sinEta);
    f(kHeading, kSpeed) = kappa * dt;
    f(kHeading, kCurvature) = s;
    f(kAxis, kAxis) = std::exp(-dt / options.axisTime);
    f(kAxis, kLength) = options.axisFraction * (1.0 - f(kAxis, kAxis));
    return f;
}

StateMatrix processNoise(const StateVector& x, double step, const MotionOptions& options)
{
    const double dt = std::abs(step);
    const double v = x(kSpeed);
    const double kappa = x(kCurvature);
    const double d = x(kAxis);
    const double eta = kappa * v * step;
    // Of the direction halfway through the step.
    const Eigen::Matrix2d r = rotation(x(kHeading) + 0.5 * eta);

    const double sign = step < 0.0 ? -1.0 : 1.0;
    const Eigen::Vector2d bySpeed = r * Eigen::Vector2d(1.0, d * kappa);
    const Eigen::Vector2d left = r.col(1);
    const Influence speed{sign * Eigen::Vector3d(bySpeed.x(), bySpeed.y(), kappa),
                          Eigen::Vector3d::Zero()};
    const Influence curvature{sign * v * Eigen::Vector3d(d * left.x(), d * left.y(), 1.0),
                              0.5 * v * v * Eigen::Vector3d(left.x(), left.y(), 0.0)};

    // Steering is bounded by the steering wheel's rate when slow and by lateral jerk when fast; a
    // vehicle that stands shows nothing of it, so its uncertainty must not grow there. The longer
    // the wheelbase, the less the same steering turns it.
    constexpr double kLongestCar = 5.5;  // m
    const double rate =
        std::min(options.maxCurvatureRate, options.lateralJerk / std::max(v * v, 1e-6)) *
        std::min(1.0, kLongestCar / x(kLength));
    const double moving = std::min(1.0, std::abs(v) / 0.5);

    StateMatrix q =
        std::pow(options.accelerationSigma, 2) * kHold * accumulated(speed, kSpeed, dt) +
        rate * rate * moving * kHold * accumulated(curvature, kCurvature, dt);
    q(kX, kX) += options.slipSigma * options.slipSigma * dt;
    q(kY, kY) += options.slipSigma * options.slipSigma * dt;
    q(kHeading, kHeading) += options.headingSigma * options.headingSigma * dt;
    q(kAxis, kAxis) += options.axisSigma * options.axisSigma * dt;
    q(kLength, kLength) += options.sizeSigma * options.sizeSigma * dt;
    return q;
}

StateVector withinBounds(const StateVector& x, const MotionOptions& options)
{
    const double v = x(kSpeed);
    const double kappa =
        std::min(options.maxCurvature, options.maxLateralAcceleration / std::max(v * v, 1e-6));
    StateVector y = x;
    constexpr double kLeastSize = 0.2;  // m
    y(kLength) = std::max(kLeastSize, x(kLength));
    y(kHeading) = wrapAngle(x(kHeading));
    y(kCurvature) = std::clamp(x(kCurvature), -kappa, kappa);
    y(kAxis) = std::clamp(x(kAxis), -0.1 * y(kLength), 0.45 * y(kLength));
    return y;
}

}  // namespace vdamf
