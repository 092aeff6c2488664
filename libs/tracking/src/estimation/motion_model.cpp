// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/motion_model.h"

#include <cmath>

#include "estimation/transition.h"

namespace vdamf
{
StateVector VariableAxisModel::predicted(const StateVector& state, double dt) const
{
    return predictState(state, dt, options_);
}
StateMatrix VariableAxisModel::jacobian(const StateVector& state, double dt) const
{
    return transitionJacobian(state, dt, options_);
}
StateMatrix VariableAxisModel::noise(const StateVector& state, double dt) const
{
    return processNoise(state, dt, options_);
}
StateVector VariableAxisModel::bounded(const StateVector& state) const
{
    return withinBounds(state, options_);
}

MotionOptions optionsOf(Steering steering, MotionOptions options, double calm)
{
    if (steering == Steering::VariableAxis) return options;
    options.accelerationSigma *= options.steadyShare * std::sqrt(calm);
    if (steering == Steering::Turning) return options;
    options.maxCurvatureRate *= options.steadyShare;
    options.lateralJerk *= options.steadyShare;
    return options;
}

std::unique_ptr<MotionModel> modelOf(Steering steering, const MotionOptions& options)
{
    if (steering == Steering::Independent) return std::make_unique<IndependentModel>(options);
    return std::make_unique<VariableAxisModel>(optionsOf(steering, options));
}

VehicleState stateAt(const VehicleState& state, double dt, const MotionOptions& options)
{
    if (dt == 0.0) return state;
    return transitioned(*modelOf(state.steering, options), state, dt);
}

VehicleState independentOf(const VehicleState& s)
{
    const double v = s.mean(kSpeed);
    const double kappa = s.mean(kCurvature);
    const double d = s.mean(kAxis);
    const Eigen::Matrix2d r = rotation(s.mean(kHeading));
    const Eigen::Vector2d inBody(v, d * v * kappa);
    StateMatrix j = StateMatrix::Identity();
    j.block<3, 3>(kVelocityX, kSpeed).setZero();
    j.block<2, 1>(kVelocityX, kHeading) = r * Eigen::Vector2d(-inBody.y(), inBody.x());
    j.block<2, 1>(kVelocityX, kSpeed) = r * Eigen::Vector2d(1.0, d * kappa);
    j.block<2, 1>(kVelocityX, kCurvature) = r * Eigen::Vector2d(0.0, d * v);
    j.block<2, 1>(kVelocityX, kAxis) = r * Eigen::Vector2d(0.0, v * kappa);
    j(kYawRate, kSpeed) = kappa;
    j(kYawRate, kCurvature) = v;
    VehicleState free = s;
    free.steering = Steering::Independent;
    free.mean.segment<2>(kVelocityX) = r * inBody;
    free.mean(kYawRate) = v * kappa;
    free.covariance = j * s.covariance * j.transpose();
    return free;
}

VehicleState variableAxisOf(const VehicleState& s, const VehicleState& axle,
                            const MotionOptions& options)
{
    // At standstill the curvature of a path is not defined: this much speed (m/s) hides that.
    constexpr double kLeastSpeed = 1.0;
    const Eigen::Vector2d e = rotation(s.mean(kHeading)).col(0);
    const Eigen::Vector2d n = rotation(s.mean(kHeading)).col(1);
    const Eigen::Vector2d velocity = s.mean.segment<2>(kVelocityX);
    const double v = e.dot(velocity);
    const double omega = s.mean(kYawRate);
    const double square = v * v + kLeastSpeed * kLeastSpeed;
    StateMatrix j = StateMatrix::Identity();
    j.block<3, 3>(kSpeed, kVelocityX).setZero();
    j(kSpeed, kHeading) = n.dot(velocity);
    j.block<1, 2>(kSpeed, kVelocityX) = e.transpose();
    j.row(kCurvature) =
        omega * (kLeastSpeed * kLeastSpeed - v * v) / (square * square) * j.row(kSpeed);
    j(kCurvature, kYawRate) = v / square;
    VehicleState next = s;
    next.steering = Steering::VariableAxis;
    next.mean(kSpeed) = v;
    next.mean(kCurvature) = omega * v / square;
    next.mean(kAxis) = axle.mean(kAxis);
    next.mean = withinBounds(next.mean, options);
    next.covariance = j * s.covariance * j.transpose();
    next.covariance(kAxis, kAxis) = axle.covariance(kAxis, kAxis);
    return next;
}

}  // namespace vdamf
