// SPDX-License-Identifier: BSD-3-Clause
// The overlap of every object with every track of a frame.
#pragma once

#include <vector>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// Bird's-eye IoU, [truth][track].
std::vector<std::vector<double>> overlapsOf(const ScoredFrame& frame);

/// Whether an overlap is at least a threshold, up to the rounding of boxes far from the origin.
inline bool reaches(double overlap, double threshold)
{
    constexpr double kRounding = 1e-9;
    return overlap >= threshold - kRounding;
}

/// Whether a track lies on an object: it overlaps it by `minOverlap`, or has its centre inside.
bool isOn(const OrientedBox& object, const OrientedBox& track, double overlap, double minOverlap);

}  // namespace vdamf
