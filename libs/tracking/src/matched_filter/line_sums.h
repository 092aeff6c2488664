// SPDX-License-Identifier: BSD-3-Clause
// The hot loop of the face lines: weighted sums over the hits of a face.
#pragma once

#include "matched_filter/match_kernel.h"
#include "matched_filter/near_faces.h"

namespace vdamf
{
/// Welsch's weight exp(-r^2 / (2 k^2 sigma^2)) with this k has 95 % efficiency on Gaussian hits.
inline constexpr double kLineTuning = 2.11;
/// Weight of hits inside of a line against those outside.
inline constexpr double kInsideWeight = 0.3;

/// Where a line runs: a hit's residual is outwards + slope turn along - place.
struct LineState
{
    double turn = 0.0;   ///< rad
    double place = 0.0;  ///< outwards, m
    double sigma = 0.1;  ///< scale of the weights, m
};

/// Over the hits of a face, with r the residual and a = slope * along: sums of the weights, of
/// weight times a, a^2, r, a r; and, with the same weight on both sides of the line, of weight
/// times the scatter and of the weights.
struct LineSums
{
    double w = 0.0, wa = 0.0, waa = 0.0, wr = 0.0, war = 0.0;
    double squares = 0.0, count = 0.0;
};

LineSums lineSums(const NearFace& face, const LineState& line, KernelPath path);

/// The same on the fastest path of this processor.
LineSums lineSums(const NearFace& face, const LineState& line);

}  // namespace vdamf
