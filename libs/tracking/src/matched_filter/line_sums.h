// SPDX-License-Identifier: BSD-3-Clause
// The hot loop of the face lines: weighted sums over the hits of a face.
#pragma once

#include "matched_filter/match_kernel.h"
#include "matched_filter/near_faces.h"

namespace vdamf
{
/// Welsch's weight exp(-r^2 / (2 k^2 sigma^2)) with this k has 95 % efficiency on Gaussian hits.
inline constexpr double kLineTuning = 2.11;
/// How hits inside of a line weigh against those outside, and what that makes of Gaussian hits.
struct LineWeights
{
    double inside;        ///< weight of the hits inside
    double shift;         ///< the line lies so far outwards, in units of their standard deviation
    double outsideShare;  ///< of their variance the hits outside have about the line
    double insideShare;   ///< and those inside
    double efficiency;    ///< variance of the estimate times the sum of the weights, over theirs
};
inline constexpr LineWeights kTowardsHull{0.3, 0.481, 0.69, 1.48, 0.485};  ///< of bodies
inline constexpr LineWeights kThroughHits{1.0, 0.0, 1.0, 1.0, 0.56};       ///< of planes

/// Where a line runs: a hit's residual is outwards + slope turn along - place.
struct LineState
{
    double turn = 0.0;                   ///< rad
    double place = 0.0;                  ///< outwards, m
    double sigma = 0.1;                  ///< scale of the weights, m
    LineWeights weights = kTowardsHull;  ///< sides of the line
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
