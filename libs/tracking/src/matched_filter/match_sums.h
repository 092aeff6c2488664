// SPDX-License-Identifier: BSD-3-Clause
// Eq. (10): from sums over the hits to the normalised response.
#pragma once

#include <cmath>

#include "matched_filter/filter_regions.h"
#include "vdamf/tracking/matched_filter/match_response.h"

namespace vdamf
{
/// F, the response before normalisation, with its derivatives in (t_x, t_y, theta, l, w).
struct MatchSums
{
    double f = 0.0;
    Vector5d g = Vector5d::Zero();
    Matrix5d h = Matrix5d::Zero();  ///< whole, not a triangle alone
};

/// alpha = E^(-1/2) of Eq. (3) with its derivatives in (t_x, t_y, theta, l, w).
struct Normalisation
{
    Normalisation(const FilterRegions& regions, const OrientedBox& box)
    {
        const FilterEnergy e(regions, box.length, box.width);
        value = 1.0 / std::sqrt(e.value);
        Vector5d g;
        g << 0.0, 0.0, e.t, e.l, e.w;
        Matrix5d h = Matrix5d::Zero();
        h(2, 2) = e.tt;
        h(2, 3) = h(3, 2) = e.tl;
        h(2, 4) = h(4, 2) = e.tw;
        h(3, 4) = h(4, 3) = e.lw;
        gradient = -0.5 * value / e.value * g;
        hessian =
            0.75 * value / (e.value * e.value) * g * g.transpose() - 0.5 * value / e.value * h;
    }
    double value = 0.0;
    Vector5d gradient;
    Matrix5d hessian;
};

/// M = alpha F with its derivatives.
inline MatchResponse normalised(const MatchSums& sums, const Normalisation& a)
{
    MatchResponse m;
    m.value = a.value * sums.f;
    m.gradient = a.value * sums.g + sums.f * a.gradient;
    m.hessian = a.value * sums.h + a.gradient * sums.g.transpose() +
                sums.g * a.gradient.transpose() + sums.f * a.hessian;
    return m;
}

}  // namespace vdamf
