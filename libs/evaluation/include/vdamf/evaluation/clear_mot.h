// SPDX-License-Identifier: BSD-3-Clause
// The CLEAR MOT metrics (Bernardin and Stiefelhagen 2008).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "vdamf/evaluation/matching.h"
#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// A share or mean of nothing is not a number: recall and MOTA without truth, precision without
/// tracks, both MOTP without pairs.
struct ClearMot
{
    double mota = std::numeric_limits<double>::quiet_NaN();  ///< (TP - FP - switches) / (TP + FN)
    double motp = std::numeric_limits<double>::quiet_NaN();  ///< mean overlap of pairs, 0..1
    double motpDistance = std::numeric_limits<double>::quiet_NaN();  ///< mean between centres, m
    double recall = std::numeric_limits<double>::quiet_NaN();        ///< TP / (TP + FN)
    double precision = std::numeric_limits<double>::quiet_NaN();     ///< TP / (TP + FP)
    std::size_t truePositives = 0;
    std::size_t falsePositives = 0;
    std::size_t falseNegatives = 0;
    /// An object is found by another track than the last that found it, however long ago.
    std::size_t identitySwitches = 0;
    /// An object is found again after frames in which it was missed. Frames in which it is absent
    /// or does not count do not interrupt it (TrackEval counts those too).
    std::size_t fragmentations = 0;
    std::size_t mostlyTracked = 0;  ///< objects found in more than 80 % of their frames
    std::size_t partlyTracked = 0;
    std::size_t mostlyLost = 0;  ///< in less than 20 %
    std::size_t objects = 0;     ///< that count in at least one frame
};

/// `matches` of the same sequence: matchFrames(). Definitions as in TrackEval, but for the
/// undefined values, which are 0 there, and fragmentations.
ClearMot clearMot(const Sequence& sequence, const std::vector<FrameMatches>& matches);

}  // namespace vdamf
