// SPDX-License-Identifier: BSD-3-Clause
#include "conventional/bicycle_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
enum Row
{
    kRowX,
    kRowY,
    kRowHeading,
    kRowSpeed,
    kRowSlip
};

constexpr double kGravity = 9.81;

constexpr double square(double x)
{
    return x * x;
}

// Along and across the heading.
Eigen::Matrix2d turned(double along, double across, double heading)
{
    const Eigen::Matrix2d axes = rotation(heading);
    return axes * Eigen::Vector2d(along, across).asDiagonal() * axes.transpose();
}

BicycleFilter::Covariance processNoise(const BicycleFilter::State& state, double dt,
                                       double rearAxle)
{
    constexpr double kAlong = 0.35 * kGravity;                                // m/s^2
    constexpr double kAcross = 0.15 * kGravity;                               // m/s^2
    constexpr double kLeastTurn = 1.5 * kDegree, kMostTurn = 15.0 * kDegree;  // 1/s
    constexpr double kLeastSlip = 0.3 * kDegree, kMostSlip = 10.0 * kDegree;  // 1/s
    constexpr double kMaxSlip = 30.0 * kDegree;
    constexpr double kStands = 0.01;  // m/s
    const double v = state(kRowSpeed);
    double turn = kLeastTurn;
    double slip = kLeastSlip;
    if (v > kStands)
    {
        turn = std::clamp(std::min(kAcross / v, v * std::sin(kMaxSlip) / rearAxle), kLeastTurn,
                          kMostTurn);
        const double sine = std::sin(state(kRowSlip));
        slip = std::clamp(std::hypot(kAcross * sine / v, 1.5 * sine), kLeastSlip, kMostSlip);
    }
    const double dt2 = dt * dt;
    BicycleFilter::Covariance q = BicycleFilter::Covariance::Zero();
    q.topLeftCorner<2, 2>() = turned(0.25 * square(kAlong) * dt2 * dt2,
                                     0.25 * square(kAcross) * dt2 * dt2, state(kRowHeading));
    q(kRowHeading, kRowHeading) = square(turn) * dt2;
    q(kRowSpeed, kRowSpeed) = square(kAlong) * dt2;
    q(kRowSlip, kRowSlip) = square(slip) * dt2;
    return q;
}
}  // namespace

BicycleFilter::BicycleFilter(const OrientedBox& box)
{
    constexpr double kAnySpeed = 1000.0 / 3.6;  // m/s
    state_ << box.x, box.y, box.heading, 0.0, 0.0;
    covariance_.setZero();
    covariance_.topLeftCorner<2, 2>() = turned(square(1.0), square(0.3), box.heading);
    covariance_(kRowHeading, kRowHeading) = square(25.0 * kDegree);
    covariance_(kRowSpeed, kRowSpeed) = square(kAnySpeed);
    covariance_(kRowSlip, kRowSlip) = square(5.0 * kDegree);
    setLength(box.length);
}

void BicycleFilter::setLength(double length)
{
    rearAxle_ = std::max(1.0, 0.25 * length);
}

double BicycleFilter::yawRate() const
{
    return state_(kRowSpeed) * std::sin(state_(kRowSlip)) / rearAxle_;
}

BicycleFilter::State BicycleFilter::next(const State& state, double dt, double rearAxle)
{
    const double v = state(kRowSpeed);
    const double turn = v * std::sin(state(kRowSlip)) / rearAxle * dt;
    const double course = state(kRowHeading) + state(kRowSlip);
    State later = state;
    later(kRowX) += v * dt * std::cos(course) - 0.5 * turn * v * dt * std::sin(course);
    later(kRowY) += v * dt * std::sin(course) + 0.5 * turn * v * dt * std::cos(course);
    later(kRowHeading) += turn;
    return later;
}

BicycleFilter::Covariance BicycleFilter::jacobian(const State& state, double dt, double rearAxle)
{
    const double v = state(kRowSpeed);
    const double turnBySpeed = std::sin(state(kRowSlip)) / rearAxle * dt;
    const double turnBySlip = v * std::cos(state(kRowSlip)) / rearAxle * dt;
    const double turn = v * turnBySpeed;
    const double course = state(kRowHeading) + state(kRowSlip);
    const Eigen::Vector2d ahead(std::cos(course), std::sin(course));
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const Eigen::Vector2d byCourse = v * dt * (left - 0.5 * turn * ahead);
    Covariance f = Covariance::Identity();
    f.block<2, 1>(kRowX, kRowHeading) = byCourse;
    f.block<2, 1>(kRowX, kRowSpeed) = dt * (ahead + turn * left);
    f.block<2, 1>(kRowX, kRowSlip) = byCourse + 0.5 * v * dt * turnBySlip * left;
    f(kRowHeading, kRowSpeed) = turnBySpeed;
    f(kRowHeading, kRowSlip) = turnBySlip;
    return f;
}

void BicycleFilter::predict(double dt)
{
    constexpr double kLongestStep = 0.11;  // s
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / kLongestStep)));
    for (int k = 0; k < steps; ++k) predictStep(dt / steps);
}

void BicycleFilter::predictStep(double dt)
{
    const Covariance f = jacobian(state_, dt, rearAxle_);
    covariance_ = f * covariance_ * f.transpose() + processNoise(state_, dt, rearAxle_);
    state_ = next(state_, dt, rearAxle_);
}

void BicycleFilter::update(const Eigen::Vector2d& centre, double heading)
{
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    noise.topLeftCorner<2, 2>() = turned(square(0.5), square(0.4), state_(kRowHeading));
    noise(kRowHeading, kRowHeading) = square(20.0 * kDegree);
    const Eigen::Vector3d innovation(centre.x() - state_(kRowX), centre.y() - state_(kRowY),
                                     std::remainder(heading - state_(kRowHeading), kPi));
    const Eigen::Matrix3d s = covariance_.topLeftCorner<3, 3>() + noise;
    const Eigen::Matrix<double, 5, 3> gain = covariance_.leftCols<3>() * s.inverse();
    state_ += gain * innovation;
    covariance_ -= gain * covariance_.topRows<3>();
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
    keepWithinLimits();
}

void BicycleFilter::keepWithinLimits()
{
    constexpr double kFastest = 140.0 / 3.6;       // m/s
    constexpr double kFastestReverse = 5.0 / 3.6;  // m/s
    constexpr double kMostSlip = 30.0 * kDegree;
    if (state_(kRowSpeed) < -kFastestReverse)
    {
        state_(kRowSpeed) = -state_(kRowSpeed);
        state_(kRowHeading) += kPi;
    }
    state_(kRowSpeed) = std::min(state_(kRowSpeed), kFastest);
    state_(kRowSlip) = std::clamp(state_(kRowSlip), -kMostSlip, kMostSlip);
    state_(kRowHeading) = wrapAngle(state_(kRowHeading));
}

}  // namespace vdamf
