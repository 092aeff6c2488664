// SPDX-License-Identifier: BSD-3-Clause
// Eqs. (5)-(8): integrals of one hit's Gaussian over the filter's regions along one axis, with
// their derivatives. Along an axis every region is a box function, so its integral is a difference
// of two error functions; products of the two axes give the rectangles.
#pragma once

#include <array>
#include <cmath>

#include "matched_filter/filter_regions.h"

namespace vdamf
{
/// Along one axis, per region: v the integral X, d = dX/dx, s = d2X/dx2, and the sums weighted
/// with the edges' slopes that differentiate by the size: dX/dsize = -a, d2X/dx dsize = -aq,
/// d2X/dsize2 = aaq.
struct AxisIntegrals
{
    std::array<double, FilterRegions::kRegions> v, d, s, a, aq, aaq;
};

/// Integrals at coordinate x (box frame, m) of a Gaussian of standard deviation sigma (m).
inline AxisIntegrals axisIntegrals(double x, double sigma, double size,
                                   const std::array<RegionEdge, 5>& edges,
                                   const std::array<std::array<int, 2>, 4>& spans)
{
    constexpr double kRootHalf = 0.70710678118654752440;
    constexpr double kInvRoot2Pi = 0.39894228040143267794;
    const double inv = 1.0 / sigma;
    std::array<double, 5> step;     // Eq. (5)
    std::array<double, 5> density;  // its derivative by x
    std::array<double, 5> curve;    // and the second one
    for (std::size_t k = 0; k < 5; ++k)
    {
        const double u = (x - edges[k].slope * size - edges[k].offset) * inv;
        // Beyond 8 sigma all derivatives are below 1e-14 of their scale.
        const bool far = std::abs(u) > 8.0;
        step[k] = far ? (u > 0.0 ? 1.0 : 0.0) : 0.5 * std::erfc(-kRootHalf * u);
        density[k] = far ? 0.0 : kInvRoot2Pi * inv * std::exp(-0.5 * u * u);
        curve[k] = -u * inv * density[k];
    }
    AxisIntegrals r;
    for (std::size_t k = 0; k < FilterRegions::kRegions; ++k)
    {
        const auto i = static_cast<std::size_t>(spans[k][0]);
        const auto j = static_cast<std::size_t>(spans[k][1]);
        const double ai = edges[i].slope;
        const double aj = edges[j].slope;
        r.v[k] = step[i] - step[j];
        r.d[k] = density[i] - density[j];
        r.s[k] = curve[i] - curve[j];
        r.a[k] = ai * density[i] - aj * density[j];
        r.aq[k] = ai * curve[i] - aj * curve[j];
        r.aaq[k] = ai * ai * curve[i] - aj * aj * curve[j];
    }
    return r;
}

}  // namespace vdamf
