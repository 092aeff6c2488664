// SPDX-License-Identifier: BSD-3-Clause
// The extended Kalman filter of section 2, on MRPT's template.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "vdamf/tracking/estimation/variable_axis_model.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// A measured pose (x, y, heading) of the box centre with its covariance: world, m and rad.
struct PoseMeasurement
{
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// A state after an update, and how the measurement sat with the prediction.
struct UpdatedState
{
    VehicleState state;
    Eigen::Vector3d innovation = Eigen::Vector3d::Zero();  ///< heading wrapped
    double nis = 0.0;  ///< normalised innovation squared, 3 degrees of freedom
};

/// mrpt::bayes::CKalmanFilterCapable (kfEKFNaive, the only one of its methods that is right) with
/// the variable-axis model. One object serves all tracks: MRPT's filter is 600 kB large and cannot
/// be copied, so it is loaded with a track's Gaussian, stepped and read. Not thread safe.
class VehicleKalmanFilter
{
public:
    explicit VehicleKalmanFilter(const MotionOptions& options);
    ~VehicleKalmanFilter();
    VehicleKalmanFilter(VehicleKalmanFilter&&) noexcept;
    VehicleKalmanFilter& operator=(VehicleKalmanFilter&&) noexcept;

    /// The state `dt` seconds later; `length` (m) is that of the vehicle.
    VehicleState predict(const VehicleState& state, double dt, double length);
    UpdatedState update(const VehicleState& state, const PoseMeasurement& measurement,
                        double length);

private:
    class Engine;
    std::unique_ptr<Engine> engine_;
};

/// Innovation of a measurement against a predicted state, heading wrapped, and its NIS.
Eigen::Vector3d innovationOf(const VehicleState& state, const PoseMeasurement& measurement);
double nisOf(const VehicleState& state, const PoseMeasurement& measurement);

}  // namespace vdamf
