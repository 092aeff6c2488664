// SPDX-License-Identifier: BSD-3-Clause
#include "association/plane_index.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kLeastCell = 8.0;  // m: about the reach of a vehicle

bool isFinite(const PlaneBounds& bounds)
{
    return bounds.min.allFinite() && bounds.max.allFinite();
}

PlaneBounds boundsOfAll(const std::vector<PlaneBounds>& items)
{
    const auto first = std::find_if(items.begin(), items.end(), isFinite);
    if (first == items.end()) return {};
    PlaneBounds all = *first;
    for (const PlaneBounds& item : items)
    {
        if (!isFinite(item)) continue;
        all.min = all.min.cwiseMin(item.min);
        all.max = all.max.cwiseMax(item.max);
    }
    return all;
}
}  // namespace

PlaneBounds PlaneBounds::around(const ClusterBounds& b)
{
    return {Eigen::Vector2f(b.minX, b.minY).cast<double>(),
            Eigen::Vector2f(b.maxX, b.maxY).cast<double>()};
}

PlaneIndex::PlaneIndex(std::vector<PlaneBounds> items) : items_(std::move(items))
{
    if (items_.empty()) return;
    const PlaneBounds all = boundsOfAll(items_);
    const Eigen::Vector2d extent = all.max - all.min;
    origin_ = all.min;
    // Wide things and few of them get wide cells, so that there are not many more cells than items.
    const auto count = static_cast<double>(items_.size());
    double reach = 0.0;
    for (const PlaneBounds& item : items_)
        if (isFinite(item)) reach += (item.max - item.min).maxCoeff();
    cellSize_ = std::max({kLeastCell, reach / count, extent.maxCoeff() / (4.0 * count + 16.0),
                          std::sqrt(extent.prod() / (4.0 * count + 64.0))});
    columns_ = static_cast<std::size_t>(extent.x() / cellSize_) + 1;
    rows_ = static_cast<std::size_t>(extent.y() / cellSize_) + 1;

    begin_.assign(columns_ * rows_ + 1, 0);
    for (const PlaneBounds& item : items_)
        visitCells(item, [&](std::size_t cell) { ++begin_[cell + 1]; });
    for (std::size_t cell = 0; cell + 1 < begin_.size(); ++cell) begin_[cell + 1] += begin_[cell];
    inCell_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t k = 0; k < items_.size(); ++k)
        visitCells(items_[k], [&](std::size_t cell)
                   { inCell_[next[cell]++] = static_cast<std::uint32_t>(k); });
}

PlaneIndex::Cells PlaneIndex::cellsOf(const PlaneBounds& bounds) const
{
    const auto at = [&](double value, double origin, std::size_t count)
    {
        const double cell = (value - origin) / cellSize_;
        // What is not a number is nowhere, and overlaps nothing: in any cell.
        return cell > 0.0 ? static_cast<std::size_t>(std::min(cell, static_cast<double>(count - 1)))
                          : 0;
    };
    return {at(bounds.min.x(), origin_.x(), columns_), at(bounds.max.x(), origin_.x(), columns_),
            at(bounds.min.y(), origin_.y(), rows_), at(bounds.max.y(), origin_.y(), rows_)};
}

template <class Visitor>
void PlaneIndex::visitCells(const PlaneBounds& bounds, const Visitor& visit) const
{
    const Cells cells = cellsOf(bounds);
    for (std::size_t row = cells.firstRow; row <= cells.lastRow; ++row)
        for (std::size_t column = cells.firstColumn; column <= cells.lastColumn; ++column)
            visit(row * columns_ + column);
}

std::vector<std::size_t> PlaneIndex::overlapping(const PlaneBounds& bounds) const
{
    std::vector<std::size_t> found;
    if (items_.empty()) return found;
    constexpr std::size_t kUsual = 16;
    found.reserve(kUsual);
    visitCells(bounds,
               [&](std::size_t cell)
               {
                   for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k)
                       if (items_[inCell_[k]].overlaps(bounds)) found.push_back(inCell_[k]);
               });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace vdamf
