// SPDX-License-Identifier: BSD-3-Clause
// The hot loop: sums over hits of the response and its derivatives, for any width of registers.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>

#include "matched_filter/gaussian_lanes.h"
#include "matched_filter/match_kernel.h"

namespace vdamf
{
/// The filter as the loop reads it, in halving lengths (gaussian_lanes.h). Along each axis the
/// edges run from the hidden face to the visible one: 0 and 4 the surround, 1 and 3 the box, 2 the
/// inner edge of the visible strip. Where that is against the axis, differences of edges change
/// their sign, and the heights make up for it.
struct KernelFilter
{
    /// Each strip reaches over its whole face; their shared corner loses the lower of the two.
    struct Heights
    {
        float surround, interior, side, end, corner;
    };
    std::array<float, 5> edgesX, edgesY;
    Heights c, c1, c2;                    ///< and derivatives by theta
    std::array<float, 3> toBoxX, toBoxY;  ///< from (x, y, 1) of the hits to the axes of the box
};

/// Sums over the hits of weight times f, df and ddf, in halving lengths. x, y, t stand for t_x,
/// t_y, theta; a and b for length and width, with edges 0 and 1 moving by -1 and the others by +1.
/// f_aa = f_xx and f_bb = f_yy.
template <class Real>
struct KernelSums
{
    std::array<Real, 6> first{};    ///< f, x, y, t, a, b
    std::array<Real, 13> second{};  ///< xx, xy, yy, xt, yt, tt, xa, xb, ya, yb, ta, tb, ab
};

/// One quantity on the three intervals of an axis: surround, whole box, strip.
template <class Real>
struct Intervals
{
    Real surround, whole, strip;
};

/// As AxisIntegrals: the integral v, its derivatives d and s by the coordinate, -a by the size,
/// -aq by both.
template <class Real>
struct AxisLanes
{
    Intervals<Real> v, d, s, a, aq;
};

template <int kWidth, class Real = typename Lanes<kWidth>::Real>
[[gnu::always_inline]] inline AxisLanes<Real> axisLanes(const Real& x,
                                                        const std::array<float, 5>& edges)
{
    const auto e0 = edgeLanes<kWidth>(x - edges[0]);
    const auto e1 = edgeLanes<kWidth>(x - edges[1]);
    const auto e2 = edgeLanes<kWidth>(x - edges[2]);
    const auto e3 = edgeLanes<kWidth>(x - edges[3]);
    const auto e4 = edgeLanes<kWidth>(x - edges[4]);
    AxisLanes<Real> r;
    r.v = {e0.step - e4.step, e1.step - e3.step, e2.step - e3.step};
    r.d = {e0.density - e4.density, e1.density - e3.density, e2.density - e3.density};
    r.s = {e0.curve - e4.curve, e1.curve - e3.curve, e2.curve - e3.curve};
    r.a = {-e0.density - e4.density, -e1.density - e3.density, r.d.strip};
    r.aq = {-e0.curve - e4.curve, -e1.curve - e3.curve, r.s.strip};
    return r;
}

/// The heights applied to one axis; the product with the other axis sums over the regions.
template <class Real>
[[gnu::always_inline]] inline Intervals<Real> weighted(const KernelFilter::Heights& c,
                                                       const Intervals<Real>& y)
{
    return {c.surround * y.surround, c.interior * y.whole + c.side * y.strip,
            c.end * y.whole - c.corner * y.strip};
}

/// The same for derivatives of the heights by theta: those of the strips alone.
template <class Real>
[[gnu::always_inline]] inline Intervals<Real> weightedStrips(const KernelFilter::Heights& c,
                                                             const Intervals<Real>& y)
{
    return {Real{}, c.side * y.strip, c.end * y.whole - c.corner * y.strip};
}

template <class Real>
[[gnu::always_inline]] inline Real dot(const Intervals<Real>& x, const Intervals<Real>& z)
{
    return x.surround * z.surround + x.whole * z.whole + x.strip * z.strip;
}

template <class Real>
[[gnu::always_inline]] inline Real dotStrips(const Intervals<Real>& x, const Intervals<Real>& z)
{
    return x.whole * z.whole + x.strip * z.strip;
}

/// f of each hit with its derivatives; see HitTerms of match_response.cpp.
template <class Real>
[[gnu::always_inline]] inline KernelSums<Real> hitTerms(const Real& x, const Real& y,
                                                        const AxisLanes<Real>& X,
                                                        const AxisLanes<Real>& Y,
                                                        const KernelFilter& filter)
{
    const Intervals<Real> zv = weighted(filter.c, Y.v);
    const Intervals<Real> zd = weighted(filter.c, Y.d);
    const Intervals<Real> za = weighted(filter.c, Y.a);
    const Intervals<Real> tv = weightedStrips(filter.c1, Y.v);
    const Intervals<Real> td = weightedStrips(filter.c1, Y.d);
    const Real fx = dot(X.d, zv);
    const Real fy = dot(X.v, zd);
    const Real fxx = dot(X.s, zv);
    const Real fxy = dot(X.d, zd);
    const Real fyy = dot(X.v, weighted(filter.c, Y.s));
    const Real fvx = dotStrips(X.d, tv);
    const Real fvy = dotStrips(X.v, td);
    const Real fxt = y * fxx - x * fxy + fvx;
    const Real fyt = y * fxy - x * fyy + fvy;
    const Real ftt = y * (fxt + fvx - fy) - x * (fyt + fvy + fx) +
                     dotStrips(X.v, weightedStrips(filter.c2, Y.v));
    const Real fxa = dot(X.aq, zv);
    const Real fxb = dot(X.d, za);
    const Real fya = dot(X.a, zd);
    const Real fyb = dot(X.v, weighted(filter.c, Y.aq));
    const Real fta = x * fya - y * fxa - dotStrips(X.a, tv);
    const Real ftb = x * fyb - y * fxb - dotStrips(X.v, weightedStrips(filter.c1, Y.a));
    return {{dot(X.v, zv), -fx, -fy, y * fx - x * fy + dotStrips(X.v, tv), -dot(X.a, zv),
             -dot(X.v, za)},
            {fxx, fxy, fyy, -fxt, -fyt, ftt, fxa, fxb, fya, fyb, fta, ftb, dot(X.a, za)}};
}

template <int kWidth>
[[gnu::always_inline]] inline double laneSum(const typename Lanes<kWidth>::Real& lanes)
{
    if constexpr (kWidth == 4)
    {
        return (static_cast<double>(lanes[0]) + lanes[1]) +
               (static_cast<double>(lanes[2]) + lanes[3]);
    }
    else
    {
        std::array<typename Lanes<kWidth / 2>::Real, 2> half;
        std::memcpy(&half, &lanes, sizeof lanes);
        return laneSum<kWidth / 2>(half[0] + half[1]);
    }
}

template <int kWidth, class Real = typename Lanes<kWidth>::Real>
[[gnu::always_inline]] inline Real lanesFrom(const float* from)
{
    Real lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// Sums over up to 16 blocks: so many terms in single precision add no error that matters.
template <int kWidth>
[[gnu::always_inline]] inline KernelSums<double> runOfBlocks(const KernelHits::Block* begin,
                                                             const KernelHits::Block* end,
                                                             const KernelFilter& filter)
{
    using Real = typename Lanes<kWidth>::Real;
    KernelSums<Real> sums;
    for (const KernelHits::Block* block = begin; block != end; ++block)
        for (int k = 0; k < KernelHits::Block::kHits; k += kWidth)
        {
            const Real px = lanesFrom<kWidth>(block->x.data() + k);
            const Real py = lanesFrom<kWidth>(block->y.data() + k);
            const Real weight = lanesFrom<kWidth>(block->weight.data() + k);
            const auto& toX = filter.toBoxX;
            const auto& toY = filter.toBoxY;
            const Real x = toX[0] * px + (toX[1] * py + toX[2]);
            const Real y = toY[0] * px + (toY[1] * py + toY[2]);
            const KernelSums<Real> terms = hitTerms(x, y, axisLanes<kWidth>(x, filter.edgesX),
                                                    axisLanes<kWidth>(y, filter.edgesY), filter);
            for (std::size_t i = 0; i < sums.first.size(); ++i)
                sums.first[i] += weight * terms.first[i];
            for (std::size_t i = 0; i < sums.second.size(); ++i)
                sums.second[i] += weight * terms.second[i];
        }
    KernelSums<double> total;
    for (std::size_t i = 0; i < sums.first.size(); ++i)
        total.first[i] = laneSum<kWidth>(sums.first[i]);
    for (std::size_t i = 0; i < sums.second.size(); ++i)
        total.second[i] = laneSum<kWidth>(sums.second[i]);
    return total;
}

/// Sums over all hits: runs in single precision, their total in double.
template <int kWidth>
[[gnu::always_inline]] inline KernelSums<double> kernelSums(const KernelHits& hits,
                                                            const KernelFilter& filter)
{
    constexpr std::size_t kRun = 16;
    KernelSums<double> total;
    const KernelHits::Block* blocks = hits.blocks.data();
    for (std::size_t begin = 0; begin < hits.blocks.size(); begin += kRun)
    {
        const std::size_t end = std::min(begin + kRun, hits.blocks.size());
        const KernelSums<double> run = runOfBlocks<kWidth>(blocks + begin, blocks + end, filter);
        for (std::size_t i = 0; i < run.first.size(); ++i) total.first[i] += run.first[i];
        for (std::size_t i = 0; i < run.second.size(); ++i) total.second[i] += run.second[i];
    }
    return total;
}

}  // namespace vdamf
