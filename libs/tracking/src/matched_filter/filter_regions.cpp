// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/filter_regions.h"

#include <cmath>

#include "vdamf/tracking/types/direction.h"

namespace vdamf
{
namespace
{
// Edges along one axis: `visiblePositive` when the strip lies at the positive face.
std::array<RegionEdge, 5> axisEdges(double margin, double strip, bool visiblePositive)
{
    const RegionEdge inner = visiblePositive ? RegionEdge{0.5, -strip} : RegionEdge{-0.5, strip};
    return {RegionEdge{-0.5, -margin}, RegionEdge{-0.5, 0.0}, inner, RegionEdge{0.5, 0.0},
            RegionEdge{0.5, margin}};
}
}  // namespace

FilterRegions::FilterRegions(const FilterShape& shape, double beta)
{
    const auto [cosBeta, sinBeta] = directionOf(beta);
    const bool front = cosBeta > 0.0;  // the sensor lies ahead of the target
    const bool left = sinBeta < 0.0;   // and to its left: the bearing in the box frame is -beta
    edgesX = axisEdges(shape.endMargin, shape.endStrip, front);
    edgesY = axisEdges(shape.sideMargin, shape.sideStrip, left);

    const std::array<int, 2> endX = front ? std::array<int, 2>{2, 3} : std::array<int, 2>{1, 2};
    const std::array<int, 2> notEndX = front ? std::array<int, 2>{1, 2} : std::array<int, 2>{2, 3};
    const std::array<int, 2> sideY = left ? std::array<int, 2>{2, 3} : std::array<int, 2>{1, 2};
    const std::array<int, 2> notSideY = left ? std::array<int, 2>{1, 2} : std::array<int, 2>{2, 3};
    const std::array<int, 2> surround{0, 4};
    const std::array<int, 2> whole{1, 3};
    // The heavier edge spans the whole length or width, the other one ends at it.
    const bool sideIsHeavier = std::abs(sinBeta) >= std::abs(cosBeta);
    spanX = {surround, whole, sideIsHeavier ? whole : notEndX, endX};
    spanY = {surround, whole, sideY, sideIsHeavier ? notSideY : whole};

    const double signEnd = front ? 1.0 : -1.0;
    const double signSide = left ? -1.0 : 1.0;
    c = {shape.surroundWeight, shape.interiorWeight - shape.surroundWeight, signSide * sinBeta,
         signEnd * cosBeta};
    c1 = {0.0, 0.0, signSide * cosBeta, -signEnd * sinBeta};
    c2 = {0.0, 0.0, -signSide * sinBeta, -signEnd * cosBeta};
}

FilterEnergy::FilterEnergy(const FilterRegions& r, double length, double width)
{
    // Regions nest: strips in the interior, the interior in the surround, strips side by side. So
    // s^2 is c_0^2 on the surround, rises by e_1 on the interior and by e_2, e_3 on the strips.
    const double ring = r.c[0];
    const double inside = r.c[0] + r.c[1];
    for (std::size_t k = 0; k < FilterRegions::kRegions; ++k)
    {
        double e = 0.0;
        double e1 = 0.0;
        double e2 = 0.0;
        if (k == 0)
            e = ring * ring;
        else if (k == 1)
            e = inside * inside - ring * ring;
        else
        {
            e = r.c[k] * (r.c[k] + 2.0 * inside);
            e1 = 2.0 * r.c1[k] * (r.c[k] + inside);
            e2 = 2.0 * (r.c2[k] * (r.c[k] + inside) + r.c1[k] * r.c1[k]);
        }
        const auto first = [](const auto& edges, const auto& span)
        { return edges[static_cast<std::size_t>(span[0])]; };
        const auto last = [](const auto& edges, const auto& span)
        { return edges[static_cast<std::size_t>(span[1])]; };
        const double slopeX = last(r.edgesX, r.spanX[k]).slope - first(r.edgesX, r.spanX[k]).slope;
        const double slopeY = last(r.edgesY, r.spanY[k]).slope - first(r.edgesY, r.spanY[k]).slope;
        const double sizeX = slopeX * length + last(r.edgesX, r.spanX[k]).offset -
                             first(r.edgesX, r.spanX[k]).offset;
        const double sizeY =
            slopeY * width + last(r.edgesY, r.spanY[k]).offset - first(r.edgesY, r.spanY[k]).offset;
        value += e * sizeX * sizeY;
        t += e1 * sizeX * sizeY;
        tt += e2 * sizeX * sizeY;
        l += e * slopeX * sizeY;
        w += e * sizeX * slopeY;
        tl += e1 * slopeX * sizeY;
        tw += e1 * sizeX * slopeY;
        lw += e * slopeX * slopeY;
    }
}

}  // namespace vdamf
