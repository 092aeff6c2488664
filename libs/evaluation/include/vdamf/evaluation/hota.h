// SPDX-License-Identifier: BSD-3-Clause
// HOTA: detection and association in one number (Luiten et al. 2021).
#pragma once

#include <limits>
#include <vector>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// Shares, 0..1. A share of nothing is not a number: everything without truth and tracks, detRe
/// without truth, detPr without tracks.
struct HotaScores
{
    double hota = std::numeric_limits<double>::quiet_NaN();   ///< sqrt(detA * assA)
    double detA = std::numeric_limits<double>::quiet_NaN();   ///< TP / (TP + FN + FP)
    double assA = std::numeric_limits<double>::quiet_NaN();   ///< mean over TP of TPA/(TPA+FNA+FPA)
    double locA = std::numeric_limits<double>::quiet_NaN();   ///< mean overlap of TP
    double detRe = std::numeric_limits<double>::quiet_NaN();  ///< TP / (TP + FN)
    double detPr = std::numeric_limits<double>::quiet_NaN();  ///< TP / (TP + FP)
    double assRe = std::numeric_limits<double>::quiet_NaN();  ///< mean over TP of TPA / (TPA + FNA)
    double assPr = std::numeric_limits<double>::quiet_NaN();  ///< mean over TP of TPA / (TPA + FPA)
};

struct HotaAtAlpha : HotaScores
{
    double alpha = 0.0;  ///< overlap from which a pair is a TP
};

/// The means over all alphas, as in TrackEval: at an alpha without pairs assA, assRe and assPr
/// count 0 and locA counts 1. Without a pair at any alpha locA is not a number.
struct Hota : HotaScores
{
    std::vector<HotaAtAlpha> atAlpha;  ///< 0.05, 0.10 ... 0.95
};

/// One pairing of each frame serves all alphas: the one with the highest sum of overlap times the
/// share of time that object and track have in common. Don't-care objects take no part:
/// withoutDontCare() with `dontCareOverlap`.
Hota hotaOf(const Sequence& sequence, double dontCareOverlap = 0.5);

}  // namespace vdamf
