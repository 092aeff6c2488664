// SPDX-License-Identifier: BSD-3-Clause
// Section 4.5: what a partly seen vehicle says about its pose and size.
#pragma once

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
struct VisibilityOptions
{
    double positionFloor = 0.05;                     ///< m
    double headingFloor = 0.5 * kPi / 180.0;         ///< rad
    double endOnlyHeadingFloor = 3.0 * kPi / 180.0;  ///< rad
    double unseenSigma = 0.5;                        ///< m
    double sizeSigma = 0.15;                         ///< m
    double sizeDriftSigma = 0.01;                    ///< m/sqrt(frame)
    bool assumeVehicleSize = true;
    double carLength = 4.2;       ///< m
    double carLengthSigma = 0.5;  ///< m
    double carWidth = 1.75;       ///< m
    double carWidthSigma = 0.15;  ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.positionFloor, "position_floor_m", 0.0, 1.0,
              "model error of a measured position, beside Eq. 14");
        field(self.headingFloor, "heading_floor_deg", 0.0, 30.0,
              "model error of a measured heading");
        field(self.endOnlyHeadingFloor, "end_only_heading_floor_deg", 0.0, 90.0,
              "model error of a measured heading where no side is seen");
        field(self.unseenSigma, "unseen_sigma_m", 0.01, 5.0,
              "error of a position measured without any face seen");
        field(self.sizeSigma, "size_sigma_m", 0.01, 2.0, "error of one measured length or width");
        field(self.sizeDriftSigma, "size_drift_sigma", 0.0, 1.0,
              "drift that the average of measured sizes allows, m / sqrt(frame)");
        field(self.assumeVehicleSize, "assume_vehicle_size",
              "sizes start from a car's where a seen end or side fits a car");
        field(self.carLength, "car_length_m", 2.0, 8.0, "length of an assumed car");
        field(self.carLengthSigma, "car_length_sigma_m", 0.05, 3.0,
              "standard deviation of that length");
        field(self.carWidth, "car_width_m", 1.0, 3.0, "width of an assumed car");
        field(self.carWidthSigma, "car_width_sigma_m", 0.02, 1.0,
              "standard deviation of that width");
    }
};

/// Long-term robust average of one dimension.
struct SizeEstimate
{
    double mean = 0.0;      ///< m
    double variance = 0.0;  ///< m^2
};

/// Length and width of a track. Kept beside the kinematic state.
struct SizeMemory
{
    SizeEstimate length;
    SizeEstimate width;
};

/// Whether a measurement locates both ends of the vehicle's length or width: the ends of a face
/// seen are where its hits end, so a side tells the length and an end the width, unless something
/// hides an end.
inline bool locatesLength(const Measurement& m)
{
    return m.facesSeen.seesSide() && !m.hiddenEnds.seesEnd();
}
inline bool locatesWidth(const Measurement& m)
{
    return m.facesSeen.seesEnd() && !m.hiddenEnds.seesSide();
}

/// Memory of a new track: what is measured, after a car's size where that fits (assumeVehicleSize).
SizeMemory initialSize(const Measurement& measurement, const VisibilityOptions& options);

/// Memory after another measurement. A size clearly below the average is a loss of visibility and
/// hardly counts; a larger one counts in full, as hits never add to a vehicle.
SizeMemory updatedSize(const SizeMemory& memory, const Measurement& measurement,
                       const VisibilityOptions& options);

/// Where on the box the point nearest to the sensor lies: +-1 at the faces, 0 in the middle, along
/// the length (x) and the width (y). A corner of the box but for a sensor abreast of it.
Eigen::Vector2d nearestPoint(const OrientedBox& box, const Eigen::Vector2d& sensor);

/// The point of the box that a measurement holds best, in the same form: the one nearest to the
/// sensor, or at the other end where that end is hidden.
Eigen::Vector2d fixedPoint(const Measurement& measurement, const Eigen::Vector2d& sensor);

/// The state after its box grew from `before` to `after` with a point of the box held (as of
/// fixedPoint). The tracked centre moves inside the body, so the axis offset, and for a move to
/// the side speed and curvature, move along.
VehicleState resized(const VehicleState& state, const SizeMemory& before, const SizeMemory& after,
                     const Eigen::Vector2d& fixedPoint);

/// Pose of the centre of a box of the remembered size that shares the fixed point with the
/// measured box. Covariance through the faces (Eq. 15): what hidden faces would add does not
/// enter; along an axis with both ends hidden the position is unknown. Measurement and sensor
/// share their origin.
PoseMeasurement anchoredPose(const Measurement& measurement, const SizeMemory& size,
                             const Eigen::Vector2d& sensor, const VisibilityOptions& options);

/// The same measurement with its front turned counter-clockwise by quarter turns: odd ones exchange
/// length and width.
Measurement turnedBy(const Measurement& measurement, int quarters);

/// The same measurement with its front on the side of `heading`.
Measurement alignedWith(const Measurement& measurement, double heading);

}  // namespace vdamf
