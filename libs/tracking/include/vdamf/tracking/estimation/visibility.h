// SPDX-License-Identifier: BSD-3-Clause
// Section 4.5: what a partly seen vehicle says about its pose and size.
#pragma once

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/options.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
enum class VisibilityCorrection
{
    Corner,  ///< 4.5: where a size falls clearly short, the corner nearest to the sensor holds
    Faces    ///< each face holds by an error of its own, those that fall short by less
};

template <>
struct EnumNames<VisibilityCorrection>
{
    static std::vector<std::pair<VisibilityCorrection, const char*>> names()
    {
        return {{VisibilityCorrection::Corner, "corner"}, {VisibilityCorrection::Faces, "faces"}};
    }
};

struct VisibilityOptions
{
    VisibilityCorrection correction = VisibilityCorrection::Faces;
    double positionFloor = 0.04;                     ///< m
    double headingFloor = 0.2 * kPi / 180.0;         ///< rad
    double endOnlyHeadingFloor = 1.5 * kPi / 180.0;  ///< rad
    double unseenSigma = 0.5;                        ///< m
    double sizeSigma = 0.15;                         ///< m
    double shortfallSigma = 0.4;                     ///< m
    double lastingPosition = 0.02;                   ///< m
    double lastingHeading = 0.15 * kPi / 180.0;      ///< rad
    double lastingSize = 0.1;                        ///< m
    bool assumeVehicleSize = true;
    double carLength = 4.3;        ///< m
    double carLengthSigma = 0.45;  ///< m
    double carWidth = 1.75;        ///< m
    double carWidthSigma = 0.15;   ///< m

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.correction, "correction",
              "of sizes that fall short of those known: the nearest corner alone holds (paper, "
              "4.5), or each face by its own error");
        field(self.positionFloor, "position_floor_m", 0.0, 1.0,
              "model error of the place of a face seen, beside Eq. 14");
        field(self.headingFloor, "heading_floor_deg", 0.0, 30.0,
              "model error of a measured heading");
        field(self.endOnlyHeadingFloor, "end_only_heading_floor_deg", 0.0, 90.0,
              "model error of a measured heading where no side is seen");
        field(self.unseenSigma, "unseen_sigma_m", 0.01, 5.0,
              "error of a position measured without any face seen");
        field(self.sizeSigma, "size_sigma_m", 0.01, 2.0,
              "model error of a far end that only a row of hits tells");
        field(self.shortfallSigma, "shortfall_sigma_m", 0.01, 5.0,
              "the same where that end falls short of the one known");
        field(self.lastingPosition, "lasting_position_m", 0.0, 1.0,
              "error of the position that lasts as long as the view: frames do not average it out, "
              "so it is added to the covariance that is told, and not to the filter's");
        field(self.lastingHeading, "lasting_heading_deg", 0.0, 30.0, "the same of the heading");
        field(self.lastingSize, "lasting_size_m", 0.0, 2.0,
              "the same of length and width; at least a fiftieth of a length");
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

/// Whether a measurement locates both ends of the vehicle's length or width: the ends of a face
/// seen are where its hits end, so a side tells the length and an end the width, unless something
/// hides an end, or all but its upper part, which may recede.
inline bool locatesLength(const Measurement& m)
{
    return m.facesSeen.seesSide() && !m.hiddenEnds.seesEnd() && !m.upperEnds.seesEnd();
}
inline bool locatesWidth(const Measurement& m)
{
    return m.facesSeen.seesEnd() && !m.hiddenEnds.seesSide() && !m.upperEnds.seesSide();
}

/// Where on the box the point nearest to the sensor lies: +-1 at the faces, 0 in the middle, along
/// the length (x) and the width (y). A corner of the box but for a sensor abreast of it.
Eigen::Vector2d nearestPoint(const OrientedBox& box, const Eigen::Vector2d& sensor);

/// Faces whose place a measurement tells: those seen, and those where the row of hits along a face
/// seen ends, unless something hides that end.
FaceSet locatedFaces(const Measurement& measurement);

/// Standard deviation of the place of each face, m: by axis (length, width) and end (low, high).
struct FaceErrors
{
    double sigma[2][2] = {};
    /// Whether the row of hits along a face is as long as the vehicle is known to be, from one
    /// end to the other: then its middle is the vehicle's, to 5 cm.
    bool isAsKnown[2] = {};

    static constexpr double kNotTold = 100.0;  ///< of a face that a measurement does not tell, m
    bool tells(int axis, int end) const { return sigma[axis][end] < kNotTold; }
};

/// Model errors of the faces, beside what the measurement's covariance says: of those seen, of
/// those where a row of hits ends, and of the others.
FaceErrors faceErrors(const Measurement& measurement, const VisibilityOptions& options);

/// The same with what the predicted state tells of visibility (4.5). Rows of hits end short of the
/// vehicle rather than beyond it, so a face that falls behind the one known counts less, by as
/// much as the whole box is too small (widths by less, where they are short by less than rows
/// err). One that is hidden is no nearer than the hits: it counts where they reach beyond the one
/// known.
FaceErrors faceErrors(const Measurement& measurement, const VehicleState& predicted,
                      const VisibilityOptions& options);

/// The same for what stands, or has a row inside of it, and whose size is known: where a row of
/// hits ends behind where the predicted face is, it is cut short there, and that end counts less by
/// as much.
FaceErrors withShortRows(const FaceErrors& errors, const Measurement& measurement,
                         const VehicleState& predicted);

/// Whether a row of hits along the length, neither end of which is known to be hidden, lies inside
/// of where the vehicle surely is (by two sigmas), at both ends.
bool isInside(const Measurement& measurement, const VehicleState& predicted);

/// The predicted state, less certain of its size where the measurement shows clearly more than it
/// knew: hits never add to a vehicle, so the face that is ahead most is news. Speed is not touched:
/// centre, axle and size move as that face does. Where it `mayBeLonger`, hits beyond an end whose
/// place is hidden are news as well, if the measurement tells its heading to 0.04 rad.
VehicleState openToGrowth(const VehicleState& predicted, const Measurement& measurement,
                          bool mayBeLonger, const VisibilityOptions& options);

/// What the faces say of the whole box: a face that is not told is where the `known` length and
/// width put it, and counts for nothing; the other one is the fixed point. Covariance through the
/// faces (Eq. 15), with their model errors. Measurement and sensor share their origin.
BoxMeasurement boxThrough(const Measurement& measurement, const FaceErrors& errors,
                          const Eigen::Vector2d& known, const Eigen::Vector2d& sensor,
                          const VisibilityOptions& options);

/// The same measurement with its front turned counter-clockwise by quarter turns: odd ones exchange
/// length and width.
Measurement turnedBy(const Measurement& measurement, int quarters);

/// The same measurement with its front on the side of `heading`.
Measurement alignedWith(const Measurement& measurement, double heading);

/// Whether it lies across the heading (rad) rather than along it: its faces are others then.
bool liesAcross(const Measurement& measurement, double heading);

}  // namespace vdamf
