// SPDX-License-Identifier: BSD-3-Clause
// Pose and size of a target as one frame shows it.
#pragma once

#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// What the matched filter makes of the hits of one target. World axes; the position's origin is
/// the caller's (the frame's origin inside the tracker).
struct Measurement
{
    OrientedBox box;  ///< m, rad
    /// Of (x, y, heading, length, width), Eq. (14): m and rad.
    Matrix5d covariance = Matrix5d::Zero();
    double match = 0.0;  ///< response per hit, 1/m
    int hits = 0;
    int iterations = 0;  ///< of the fit, all steps together
    bool converged = false;
    FaceSet facesSeen;    ///< faces towards the sensor with enough hits on them
    FaceSet hiddenEnds;   ///< faces whose place the frame does not show
    FaceSet shadowEdges;  ///< faces seen that may be where something nearer hides the rest
    FaceSet upperEnds;    ///< faces of which it shows the upper part alone, which may recede
};

}  // namespace vdamf
