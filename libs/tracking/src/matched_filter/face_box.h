// SPDX-License-Identifier: BSD-3-Clause
// A box and its covariance from what is known of each face.
#pragma once

#include "matched_filter/face_lines.h"
#include "vdamf/tracking/matched_filter/measure.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// A box with the covariance of (x, y, heading, length, width), m and rad.
struct FaceBox
{
    OrientedBox box;
    Matrix5d covariance = Matrix5d::Zero();
};

/// The near faces where the lines say, the others where the rows of hits along the seen faces end.
/// Bodies (bodyDepth > 0) reach on round their far corners, out of view; the fewer hits there are
/// in a row, the more of that is not seen. Faces that nothing shows stay where the fit put them and
/// get a variance of hiddenFaceSigma^2. Sizes out of the bounds of the fit are brought back by
/// moving the far face.
FaceBox boxFromFaces(const Hits& hits, const OrientedBox& fitted, FaceSet seen,
                     const Eigen::Vector2d& sensor, const FaceLines& lines,
                     const MeasureOptions& options);

}  // namespace vdamf
