// SPDX-License-Identifier: BSD-3-Clause
// The variable-axis (Ackermann) steering model that the paper's tracker uses.
//
// The equations of the paper's reference [12] were not available to us; this is our reading of its
// idea. All wheels that do not steer share one axle line; the point A where it crosses the body
// moves along the heading. Where that line lies on a stranger's vehicle is unknown, so its offset
// d behind the tracked centre is part of the state.
#pragma once

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/options.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
struct MotionOptions
{
    double accelerationSigma = 4.0;  ///< m/s^2, held for 0.1 s
    double maxCurvatureRate = 0.25;  ///< 1/(m s)
    double lateralJerk = 8.0;        ///< m/s^3
    double steadyShare = 0.04;
    double slipSigma = 0.02;                  ///< m/sqrt(s)
    double headingSigma = 0.2 * kPi / 180.0;  ///< rad/sqrt(s)
    double axisSigma = 0.03;                  ///< m/sqrt(s)
    double axisTime = 45.0;                   ///< s
    double axisFraction = 0.28;               ///< of the length
    double axisFractionSigma = 0.1;           ///< of the length
    double sizeSigma = 0.02;                  ///< m/sqrt(s)
    double maxCurvature = 0.25;               ///< 1/m
    double maxLateralAcceleration = 6.0;      ///< m/s^2
    bool independent = false;
    double independentAcceleration = 2.0;                    ///< m/s^2, held for 0.1 s
    double independentYawAcceleration = 35.0 * kPi / 180.0;  ///< rad/s^2, held for 0.1 s

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.accelerationSigma, "acceleration_sigma_mps2", 0.01, 20.0,
              "acceleration along the heading");
        field(self.maxCurvatureRate, "max_curvature_rate", 1e-4, 5.0,
              "steering at low speed, 1/(m s)");
        field(self.lateralJerk, "lateral_jerk_mps3", 0.01, 50.0,
              "steering at high speed: the curvature rate is this over speed^2");
        field(self.steadyShare, "steady_share", 0.001, 1.0,
              "what is left of acceleration while a vehicle holds its speed, and of steering while "
              "it "
              "keeps its course");
        field(self.slipSigma, "slip_sigma", 0.0, 1.0, "side slip and model error, m / sqrt(s)");
        field(self.headingSigma, "heading_sigma_deg", 0.0, 30.0,
              "model error of the heading, deg / sqrt(s)");
        field(self.axisSigma, "axis_sigma", 0.0, 1.0,
              "wander of the offset of the axle, m / sqrt(s)");
        field(self.axisTime, "axis_time_s", 1.0, 1000.0,
              "time in which that offset returns to its prior");
        field(self.axisFraction, "axis_fraction", -0.1, 0.5,
              "prior of the offset of the axle behind the centre, in lengths");
        field(self.axisFractionSigma, "axis_fraction_sigma", 0.001, 0.5,
              "standard deviation of that prior, in lengths");
        field(self.sizeSigma, "size_sigma", 0.0, 1.0,
              "drift that the average of measured sizes allows, m / sqrt(s)");
        field(self.maxCurvature, "max_curvature", 0.01, 1.0, "largest curvature of a path, 1/m");
        field(self.maxLateralAcceleration, "max_lateral_acceleration_mps2", 0.5, 30.0,
              "limit of the curvature at speed");
        field(self.independent, "independent",
              "beside the variable axis a model that moves and turns freely, weighed by how well "
              "it foretells");
        field(self.independentAcceleration, "independent_acceleration_sigma_mps2", 0.01, 20.0,
              "its acceleration, in any direction");
        field(self.independentYawAcceleration, "independent_yaw_acceleration_sigma_deg", 0.1,
              1000.0, "its yaw acceleration, deg / s^2");
    }
};

/// State after dt seconds: closed form in the arc length, valid at standstill and in reverse. The
/// axis offset returns to a prior that goes with the length; the size stays.
StateVector predictState(const StateVector& state, double dt, const MotionOptions& options);

/// d predictState / d state.
StateMatrix transitionJacobian(const StateVector& state, double dt, const MotionOptions& options);

/// Covariance of the process noise over dt seconds from `state` (negative: of what led there). Of
/// white changes of speed and curvature, so that many short steps add up to a long one. The
/// curvature of what is longer than 5.5 m changes less, by that over its length.
StateMatrix processNoise(const StateVector& state, double dt, const MotionOptions& options);

/// The state with its heading wrapped and curvature, axis offset and size within their bounds:
/// |kappa| at most max_curvature and a_lat / v^2, d within [-0.1, 0.45] lengths.
StateVector withinBounds(const StateVector& state, const MotionOptions& options);

}  // namespace vdamf
