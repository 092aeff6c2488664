// SPDX-License-Identifier: BSD-3-Clause
// Faces that seem to lie inside of where they are known to be.
#pragma once

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
struct Inside
{
    double metres = 0.0;
    double sigma = 0.0;  ///< m
};

/// How far inside of the box foretold the face of `box` at an end of an axis lies beside the hits
/// (their middle, m), and how far that box may err there, its heading aside, which edges taken for
/// faces have made uncertain. Unlike outsideOf(), it tells of the place beside the hits, which
/// differs where the boxes are turned.
Inside insideOf(const VehicleState& foretold, const OrientedBox& box, int axis, int end,
                const Eigen::Vector2d& hits);

}  // namespace vdamf
