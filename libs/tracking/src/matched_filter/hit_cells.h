// SPDX-License-Identifier: BSD-3-Clause
// Hits that share a small cell of the plane.
#pragma once

#include <vector>

#include "vdamf/tracking/types/cluster.h"

namespace vdamf
{
/// The hits of one cell: sums about its first one, because far from the origin squares would lose
/// their digits.
struct HitCell
{
    float x, y;  // the first hit
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;

    void add(float px, float py)
    {
        const double dx = static_cast<double>(px) - x;
        const double dy = static_cast<double>(py) - y;
        n += 1.0;
        sx += dx;
        sy += dy;
        sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
};

/// The cells of `size` (m, 0: each hit has one of its own) that hits lie in, by their first hits.
/// Hits that are not finite are in none.
std::vector<HitCell> hitCells(const Cluster& cluster, double size);

}  // namespace vdamf
