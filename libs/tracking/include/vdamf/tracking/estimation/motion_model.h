// SPDX-License-Identifier: BSD-3-Clause
// What a motion model must offer to the Kalman filter. docs/motion-models.md says what every one of
// them has to fulfil, and one test holds all of them to it.
#pragma once

#include <memory>

#include "vdamf/tracking/estimation/variable_axis_model.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
class MotionModel
{
public:
    virtual ~MotionModel() = default;

    /// The state `dt` seconds later; negative: before.
    virtual StateVector predicted(const StateVector& state, double dt) const = 0;
    /// d predicted / d state.
    virtual StateMatrix jacobian(const StateVector& state, double dt) const = 0;
    /// Covariance of the process noise over dt seconds from `state`.
    virtual StateMatrix noise(const StateVector& state, double dt) const = 0;
    /// The state with its heading wrapped and every row within what the model allows.
    virtual StateVector bounded(const StateVector& state) const = 0;
};

/// Steering::VariableAxis.
class VariableAxisModel final : public MotionModel
{
public:
    explicit VariableAxisModel(const MotionOptions& options) : options_(options) {}
    StateVector predicted(const StateVector& state, double dt) const override;
    StateMatrix jacobian(const StateVector& state, double dt) const override;
    StateMatrix noise(const StateVector& state, double dt) const override;
    StateVector bounded(const StateVector& state) const override;

private:
    MotionOptions options_;
};

/// Steering::Independent: constant velocity and yaw rate but for white accelerations. For what does
/// not follow wheels: pedestrians, skids, boxes that were started across.
class IndependentModel final : public MotionModel
{
public:
    explicit IndependentModel(const MotionOptions& options) : options_(options) {}
    StateVector predicted(const StateVector& state, double dt) const override;
    StateMatrix jacobian(const StateVector& state, double dt) const override;
    StateMatrix noise(const StateVector& state, double dt) const override;
    StateVector bounded(const StateVector& state) const override;

private:
    MotionOptions options_;
};

/// Options of a steering that follows wheels: those of Steering::VariableAxis, with weaker changes
/// of what it hardly changes. `calm`: share that is left of the variance of speeds that are held.
MotionOptions optionsOf(Steering steering, MotionOptions options, double calm = 1.0);

/// The model that a state's rows are meant for.
std::unique_ptr<MotionModel> modelOf(Steering steering, const MotionOptions& options);

/// What is known of the state `dt` seconds later (or, where negative, earlier).
VehicleState stateAt(const VehicleState& state, double dt, const MotionOptions& options);

/// A state of a vehicle that follows its wheels as one that moves freely.
VehicleState independentOf(const VehicleState& variableAxis);

/// The other way round: speed along the heading, curvature of its path; what is known of the axle
/// is taken from `axle`.
VehicleState variableAxisOf(const VehicleState& independent, const VehicleState& axle,
                            const MotionOptions& options);

}  // namespace vdamf
