// SPDX-License-Identifier: BSD-3-Clause
// The four rectangles of Table 1 at one view, with the derivatives of their weights and areas.
#pragma once

#include <array>

#include "vdamf/tracking/matched_filter/filter_shape.h"

namespace vdamf
{
/// An edge of a rectangle at `slope * size + offset` along one axis of the box, size being l or w.
struct RegionEdge
{
    double slope = 0.0;
    double offset = 0.0;
};

/// Table 1 at a sensor angle. Along each axis five edges bound all rectangles: 0 and 4 the
/// surround, 1 and 3 the box, 2 the inner edge of the visible strip.
struct FilterRegions
{
    static constexpr int kRegions = 4;  ///< surround, interior, side strip, end strip

    std::array<RegionEdge, 5> edgesX;
    std::array<RegionEdge, 5> edgesY;
    // First and last edge of each region along x and y.
    std::array<std::array<int, 2>, kRegions> spanX;
    std::array<std::array<int, 2>, kRegions> spanY;
    // Height of each region and its derivatives by theta. Regions overlap; heights add up.
    std::array<double, kRegions> c, c1, c2;

    FilterRegions(const FilterShape& shape, double beta);
};

/// E = integral of s^2 (Eq. 3) with derivatives by theta, l and w.
struct FilterEnergy
{
    double value = 0.0;
    double t = 0.0, l = 0.0, w = 0.0;
    double tt = 0.0, tl = 0.0, tw = 0.0, lw = 0.0;  // l l and w w vanish: E is bilinear in l and w

    FilterEnergy(const FilterRegions& regions, double length, double width);
};

}  // namespace vdamf
