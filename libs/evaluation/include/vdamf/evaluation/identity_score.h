// SPDX-License-Identifier: BSD-3-Clause
// IDF1: how long objects keep one identity (Ristani et al. 2016).
#pragma once

#include <cstddef>
#include <limits>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// A share of nothing is not a number: the recall without truth, the precision without tracks, IDF1
/// without both.
struct IdentityScore
{
    double idf1 = std::numeric_limits<double>::quiet_NaN();  ///< 2 IDTP / (2 IDTP + IDFP + IDFN)
    double idPrecision = std::numeric_limits<double>::quiet_NaN();  ///< IDTP / (IDTP + IDFP)
    double idRecall = std::numeric_limits<double>::quiet_NaN();     ///< IDTP / (IDTP + IDFN)
    std::size_t idtp = 0;  ///< rows of a track on the one object that it stands for
    std::size_t idfp = 0;  ///< other rows of tracks
    std::size_t idfn = 0;  ///< other rows of objects
};

/// Over the whole sequence every track stands for at most one object and the reverse, such that
/// IDTP is highest; a row is right where the overlap is at least `minOverlap`. Don't-care objects
/// take no part: withoutDontCare().
IdentityScore identityScore(const Sequence& sequence, double minOverlap);

}  // namespace vdamf
