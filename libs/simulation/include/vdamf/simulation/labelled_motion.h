// SPDX-License-Identifier: BSD-3-Clause
// Motion from labels: a smooth curve through noisy poses, good enough to be a truth itself.
#pragma once

#include <vector>

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
struct LabelledPose
{
    double time = 0.0;     ///< scene time, s
    double x = 0.0;        ///< m
    double y = 0.0;        ///< m
    double heading = 0.0;  ///< wrapped or not, rad
};

/// A stretch of labels from something that stands.
struct Standstill
{
    double begin = 0.0;  ///< s
    double end = 0.0;    ///< s
    LabelledPose pose;   ///< the median of each coordinate
};

/// Stretches of 2 s and more that stay within 0.2 m and do not drift, or the whole of the labels
/// where they stay within 0.9 m. Drift below 0.1 m/s is taken for wander of the labels. Headings
/// unwrapped.
std::vector<Standstill> standstills(const std::vector<LabelledPose>& poses);

/// Smooths x, y and heading by uniform cubic B-splines (knots 0.25 s apart) that minimise
///     integral (curve - label)^2 + smoothing^4 integral (second derivative)^2;
/// what is faster than `smoothing` (s) is taken for noise of the labels. Speed is that along the
/// heading. Control points within a standstill are its pose, so that the curve stands still
/// exactly, and leaves with continuous acceleration. Before the first and after the last label:
/// straight on.
///
/// `poses` are in order of time, two at least, for the point that `axleOffset` (m) lies behind
/// along the heading: the motion is that of this rear axle. Throws std::runtime_error otherwise.
Trajectory smoothed(std::vector<LabelledPose> poses, double axleOffset, double smoothing);

}  // namespace vdamf
