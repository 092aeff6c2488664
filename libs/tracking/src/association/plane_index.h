// SPDX-License-Identifier: BSD-3-Clause
// Which of many things in the plane are near a place: a grid over their bounds.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "types/cluster_bounds.h"

namespace vdamf
{
/// A rectangle along the axes, m.
struct PlaneBounds
{
    Eigen::Vector2d min = Eigen::Vector2d::Zero();
    Eigen::Vector2d max = Eigen::Vector2d::Zero();

    static PlaneBounds around(const Eigen::Vector2d& centre, double reach)
    {
        return {centre.array() - reach, centre.array() + reach};
    }
    static PlaneBounds around(const ClusterBounds& cluster);
    bool overlaps(const PlaneBounds& other) const
    {
        return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
    }
};

/// Building it takes time in proportion to the number of items, asking it in proportion to what is
/// near.
class PlaneIndex
{
public:
    explicit PlaneIndex(std::vector<PlaneBounds> items);

    /// Numbers of the items whose bounds overlap these, rising.
    std::vector<std::size_t> overlapping(const PlaneBounds& bounds) const;

private:
    struct Cells
    {
        std::size_t firstColumn, lastColumn, firstRow, lastRow;
    };
    Cells cellsOf(const PlaneBounds& bounds) const;
    template <class Visitor>
    void visitCells(const PlaneBounds& bounds, const Visitor& visit) const;

    std::vector<PlaneBounds> items_;
    Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
    double cellSize_ = 1.0;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> begin_;  // of each cell in `inCell_`
    std::vector<std::uint32_t> inCell_;
};

}  // namespace vdamf
