// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/match_response.h"

#include <cmath>

#include "matched_filter/filter_regions.h"
#include "matched_filter/hit_integrals.h"
#include "matched_filter/match_sums.h"

namespace vdamf
{
namespace
{
using Weights = std::array<double, FilterRegions::kRegions>;

// Sum over the regions of weight * x * y: one entry of the response per hit.
double sum(const Weights& c, const Weights& x, const Weights& y)
{
    return c[0] * x[0] * y[0] + c[1] * x[1] * y[1] + c[2] * x[2] * y[2] + c[3] * x[3] * y[3];
}

// Hits in the axes of the box, Eq. (9) with m_0 at the box centre.
struct BoxAxes
{
    explicit BoxAxes(const OrientedBox& box)
        : x0(box.x), y0(box.y), forward(directionOf(box.heading))
    {
    }
    double x(double px, double py) const
    {
        return forward.cos * (px - x0) + forward.sin * (py - y0);
    }
    double y(double px, double py) const
    {
        return -forward.sin * (px - x0) + forward.cos * (py - y0);
    }

    double x0, y0;
    Direction forward;
};

// f of one hit (the un-normalised response F is the sum over hits) and its derivatives.
struct HitTerms
{
    HitTerms(double px, double py, const FilterRegions& regions, const AxisIntegrals& ax,
             const AxisIntegrals& ay)
        : x(px), y(py), r(regions), X(ax), Y(ay)
    {
    }
    double f() const { return sum(r.c, X.v, Y.v); }
    double fx() const { return sum(r.c, X.d, Y.v); }
    double fy() const { return sum(r.c, X.v, Y.d); }
    double fxx() const { return sum(r.c, X.s, Y.v); }
    double fyy() const { return sum(r.c, X.v, Y.s); }
    double fxy() const { return sum(r.c, X.d, Y.d); }
    double fxl() const { return -sum(r.c, X.aq, Y.v); }
    double fxw() const { return -sum(r.c, X.d, Y.a); }
    double fyl() const { return -sum(r.c, X.a, Y.d); }
    double fyw() const { return -sum(r.c, X.v, Y.aq); }
    // The derivatives by theta at fixed hit coordinates in the box: through the weights alone.
    double fv() const { return sum(r.c1, X.v, Y.v); }
    double fvx() const { return sum(r.c1, X.d, Y.v); }
    double fvy() const { return sum(r.c1, X.v, Y.d); }

    Vector5d gradient() const
    {
        Vector5d g;
        g << -fx(), -fy(), y * fx() - x * fy() + fv(), -sum(r.c, X.a, Y.v), -sum(r.c, X.v, Y.a);
        return g;
    }

    Matrix5d hessian() const
    {
        Matrix5d h;
        h(0, 0) = fxx();
        h(0, 1) = fxy();
        h(1, 1) = fyy();
        h(0, 2) = -(y * fxx() - x * fxy() + fvx());
        h(1, 2) = -(y * fxy() - x * fyy() + fvy());
        h(2, 2) = y * y * fxx() + x * x * fyy() - 2.0 * x * y * fxy() - x * fx() - y * fy() +
                  2.0 * (y * fvx() - x * fvy()) + sum(r.c2, X.v, Y.v);
        h(0, 3) = -fxl();
        h(0, 4) = -fxw();
        h(1, 3) = -fyl();
        h(1, 4) = -fyw();
        h(2, 3) = y * fxl() - x * fyl() - sum(r.c1, X.a, Y.v);
        h(2, 4) = y * fxw() - x * fyw() - sum(r.c1, X.v, Y.a);
        h(3, 3) = sum(r.c, X.aaq, Y.v);
        h(3, 4) = sum(r.c, X.a, Y.a);
        h(4, 4) = sum(r.c, X.v, Y.aaq);
        return h;  // upper triangle
    }

    // d gradient / d (x, y): Eq. (13) before normalisation.
    Eigen::Matrix<double, 5, 2> gradientByPosition() const
    {
        Eigen::Matrix<double, 5, 2> b;
        b << -fxx(), -fxy(),                       //
            -fxy(), -fyy(),                        //
            y * fxx() - fy() - x * fxy() + fvx(),  //
            fx() + y * fxy() - x * fyy() + fvy(),  //
            fxl(), fyl(),                          //
            fxw(), fyw();
        return b;
    }

    double x, y;
    const FilterRegions& r;
    const AxisIntegrals& X;
    const AxisIntegrals& Y;
};

// Calls visit(weight, terms) for every hit.
template <class Visit>
void forEachHit(const Hits& hits, const FilterShape& shape, const FilterRegions& regions,
                const OrientedBox& box, Visit&& visit)
{
    const BoxAxes axes(box);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double x = axes.x(hits.x[i], hits.y[i]);
        const double y = axes.y(hits.x[i], hits.y[i]);
        const AxisIntegrals ax =
            axisIntegrals(x, shape.sigma, box.length, regions.edgesX, regions.spanX);
        const AxisIntegrals ay =
            axisIntegrals(y, shape.sigma, box.width, regions.edgesY, regions.spanY);
        visit(i, HitTerms(x, y, regions, ax, ay));
    }
}

// Upper triangle only, see whole().
void add(const HitTerms& hit, double weight, MatchSums& sums)
{
    sums.f += weight * hit.f();
    sums.g += weight * hit.gradient();
    sums.h.triangularView<Eigen::Upper>() += weight * hit.hessian();
}

MatchSums whole(MatchSums sums)
{
    sums.h.triangularView<Eigen::StrictlyLower>() = sums.h.transpose();
    return sums;
}
}  // namespace

double bearingToSensor(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    return std::atan2(sensor.y() - box.y, sensor.x() - box.x);
}

double matchValue(const Hits& hits, const FilterShape& shape, const OrientedBox& box, double phi)
{
    const FilterRegions regions(shape, box.heading - phi);
    double f = 0.0;
    forEachHit(hits, shape, regions, box,
               [&](std::size_t i, const HitTerms& hit) { f += hits.weight[i] * hit.f(); });
    return f / std::sqrt(FilterEnergy(regions, box.length, box.width).value);
}

MatchResponse matchResponse(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                            double phi)
{
    const FilterRegions regions(shape, box.heading - phi);
    MatchSums sums;
    forEachHit(hits, shape, regions, box,
               [&](std::size_t i, const HitTerms& hit) { add(hit, hits.weight[i], sums); });
    return normalised(whole(sums), Normalisation(regions, box));
}

ResponseByHit responseByHit(const Hits& hits, const FilterShape& shape, const OrientedBox& box,
                            double phi)
{
    const FilterRegions regions(shape, box.heading - phi);
    const Normalisation a(regions, box);
    MatchSums sums;
    ResponseByHit result;
    result.gradientByHit.reserve(hits.size());
    forEachHit(
        hits, shape, regions, box,
        [&](std::size_t i, const HitTerms& hit)
        {
            add(hit, hits.weight[i], sums);
            result.gradientByHit.push_back(a.value * hit.gradientByPosition() +
                                           a.gradient * Eigen::RowVector2d(hit.fx(), hit.fy()));
        });
    result.all = normalised(whole(sums), a);
    return result;
}

double filterEnergy(const FilterShape& shape, const OrientedBox& box, double phi)
{
    return FilterEnergy(FilterRegions(shape, box.heading - phi), box.length, box.width).value;
}

double filterHeight(const FilterShape& shape, const OrientedBox& box, double phi,
                    const Eigen::Vector2d& p)
{
    const FilterRegions r(shape, box.heading - phi);
    const auto inside = [](double v, double size, const std::array<RegionEdge, 5>& edges,
                           const std::array<int, 2>& span)
    {
        const RegionEdge& a = edges[static_cast<std::size_t>(span[0])];
        const RegionEdge& b = edges[static_cast<std::size_t>(span[1])];
        return v >= a.slope * size + a.offset && v < b.slope * size + b.offset;
    };
    double height = 0.0;
    for (std::size_t k = 0; k < FilterRegions::kRegions; ++k)
    {
        if (inside(p.x(), box.length, r.edgesX, r.spanX[k]) &&
            inside(p.y(), box.width, r.edgesY, r.spanY[k]))
            height += r.c[k];
    }
    return height;
}

}  // namespace vdamf
