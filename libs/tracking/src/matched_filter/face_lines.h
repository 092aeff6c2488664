// SPDX-License-Identifier: BSD-3-Clause
// The last step of a fit: robust lines through the hits on the faces seen, at right angles, and
// from there to the hull.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "vdamf/tracking/matched_filter/filter_parameters.h"
#include "vdamf/tracking/matched_filter/hits.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
struct FaceLineOptions
{
    double gate = 0.35;        ///< hits farther from a face are not on it, m
    double sigma = 0.12;       ///< scale of the first weights, m
    int iterations = 6;        ///< of reweighting
    double corner = 0.25;      ///< along a face from the corner of both: bumpers are round there, m
    double rangeNoise = 0.02;  ///< of the sensor, standard deviation, m; 0: estimated
    HullParameters hull;
    ErrorParameters errors;
    double bodyDepth = 0.0;   ///< of a car's sill or nose behind its bumper, m; 0: walls
    double minHits = 4.0;     ///< on a face, for a line
    bool toHull = true;       ///< else lines through the hits alone, without covariance
    bool tellPlanes = false;  ///< treat faces that scatter no more than the noise as planes
};

/// One of the two near faces.
struct FaceLine
{
    bool exists = false;
    double at = 0.0;       ///< signed, along its axis of the turned box, from its middle, m
    double outside = 0.0;  ///< of that what lies outside of the hits, m
    double shape = 0.0;    ///< how far the surface departs from a plane, standard deviation, m
};

/// The near faces after the box has turned by `turn` about its middle.
struct FaceLines
{
    double turn = 0.0;  ///< rad
    FaceLine end;       ///< across the heading
    FaceLine side;      ///< along it
    /// Of (turn, end.at, side.at): rad, m. Rows without a line are zero.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double rangeNoise = 0.0;  ///< that was reckoned with, m
    bool arePlanes = false;   ///< hits scatter no more than that
};

/// The matched filter's response in the limit of a narrow strip centred on the face is an
/// M-estimator with Welsch's weights; this is that estimator, with a scale taken from the hits
/// themselves. Linear in its three parameters, so a few reweighted least squares end at the
/// optimum.
///
/// Vehicles are round and tapered: their hits lie inside of the hull that a box stands for, and the
/// outermost ones tell of it best. So hits inside of a line weigh less than those outside, and the
/// line goes outwards by what the scatter of the latter exceeds the sensor's noise, and by what is
/// usual of vehicles at the heights that were seen (face_hull.h, body_profile.h; `bodyDepth`). On
/// plane faces both cancel; where the scatter is that of the noise, hits on both sides weigh the
/// same and the heading is the better for it. Nothing where no face has hits enough.
std::optional<FaceLines> fitFaceLines(const Hits& hits, const OrientedBox& box, FaceSet seen,
                                      const Eigen::Vector2d& sensor,
                                      const FaceLineOptions& options);

/// The same lines where the hits are, not where the hull is.
FaceLines throughHits(const FaceLines& lines);

/// The box with its near faces on the lines; far faces stay where they are along their axes.
OrientedBox onFaceLines(const OrientedBox& box, const FaceLines& lines);

}  // namespace vdamf
