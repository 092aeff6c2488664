// SPDX-License-Identifier: BSD-3-Clause
// What is usual of the lengths and widths of vehicles.
#pragma once

namespace vdamf
{
/// How far hits reach along a face.
struct FaceExtent
{
    double metres = 0.0;
    double whole = 0.0;  ///< probability that no more of the face is there
    /// What was beside it is left out: longer ones before may have held it.
    bool isCut = false;
};

/// Log odds that a face is a vehicle's end rather than its side, by the widths and lengths that
/// vehicles of that height (m) have. `isHeightSeen`: it is no higher; else rows of a LADAR may have
/// missed its roof.
double endOverSide(const FaceExtent& face, double height, bool isHeightSeen = false);

}  // namespace vdamf
