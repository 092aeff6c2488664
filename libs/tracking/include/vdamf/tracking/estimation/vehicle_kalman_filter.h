// SPDX-License-Identifier: BSD-3-Clause
// The extended Kalman filter of section 2, on MRPT's template.
#pragma once

#include <memory>

#include "vdamf/tracking/estimation/box_measurement.h"
#include "vdamf/tracking/estimation/motion_model.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// mrpt::bayes::CKalmanFilterCapable (kfEKFNaive, the only one of its methods that is right) with
/// the motion model that a state is meant for. One object serves all tracks: MRPT's filter is 600
/// kB large and cannot be copied, so it is loaded with a track's Gaussian, updated and read.
/// Predictions do not need it: the template's would work out an innovation as well. Not thread
/// safe.
class VehicleKalmanFilter
{
public:
    explicit VehicleKalmanFilter(const MotionOptions& options);
    ~VehicleKalmanFilter();
    VehicleKalmanFilter(VehicleKalmanFilter&&) noexcept;
    VehicleKalmanFilter& operator=(VehicleKalmanFilter&&) noexcept;

    /// The state `dt` seconds later. `calm`: see optionsOf().
    VehicleState predict(const VehicleState& state, double dt, double calm = 1.0);
    /// The state after a measurement of what it will be `measurement.lag` seconds later.
    VehicleState update(const VehicleState& state, const BoxMeasurement& measurement);
    const MotionOptions& options() const;

private:
    class Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace vdamf
