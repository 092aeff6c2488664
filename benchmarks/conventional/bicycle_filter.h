// SPDX-License-Identifier: BSD-3-Clause
// An extended Kalman filter of a bicycle that keeps its speed and its slip: the vehicle model of
// Autoware's multi-object tracker (version 0.43), with its constants for cars.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
class BicycleFilter
{
public:
    /// x, y (m), heading (rad), speed (m/s), slip at the centre (rad).
    using State = Eigen::Matrix<double, 5, 1>;
    using Covariance = Eigen::Matrix<double, 5, 5>;

    /// At a box, with any speed.
    explicit BicycleFilter(const OrientedBox& box);

    /// `dt` seconds later, in steps of at most 0.11 s.
    void predict(double dt);
    /// With a measured centre and axis (of which the end does not matter: the one that is nearer).
    void update(const Eigen::Vector2d& centre, double heading);
    /// To another centre, as the box grows on one side.
    void move(const Eigen::Vector2d& by) { state_.head<2>() += by; }
    /// The wheels stand by it.
    void setLength(double length);

    const State& state() const { return state_; }
    const Covariance& covariance() const { return covariance_; }
    double yawRate() const;  ///< rad/s

    /// Of one step, and its derivative by the state.
    static State next(const State& state, double dt, double rearAxle);
    static Covariance jacobian(const State& state, double dt, double rearAxle);

private:
    void predictStep(double dt);
    void keepWithinLimits();

    State state_;
    Covariance covariance_;
    double rearAxle_ = 1.0;  ///< behind the centre, m
};

}  // namespace vdamf
