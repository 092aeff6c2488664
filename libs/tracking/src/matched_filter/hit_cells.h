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
    float n = 0.0F, sx = 0.0F, sy = 0.0F, sxx = 0.0F, sxy = 0.0F, syy = 0.0F;
    float heights = 0.0F;  // sum

    void add(float px, float py, float height)
    {
        const float dx = px - x;
        const float dy = py - y;
        n += 1.0F;
        heights += height;
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
