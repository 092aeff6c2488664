// SPDX-License-Identifier: BSD-3-Clause
#include "preprocessing/plane_cells.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr float kUsefulRange = 1000.0F;  // hits farther than this from the sensor are no use, m

// The hits above ground from the sensor, with the places of their cells on a grid around it.
struct PlaneHits
{
    std::vector<float> x, y;           // m
    std::vector<std::uint32_t> place;  // row in the upper half, column in the lower; or kNone

    std::size_t size() const { return place.size(); }
};

PlaneHits placesOf(const LadarFrame& frame, const AboveGround& above)
{
    const std::size_t size = above.index.size();
    PlaneHits hits{std::vector<float>(size), std::vector<float>(size),
                   std::vector<std::uint32_t>(size)};
    const Eigen::Vector2f shift = (frame.origin - frame.sensor).head<2>().cast<float>();
    inWideLanes([
        =, index = above.index.data(), px = frame.points.x.data(), py = frame.points.y.data(),
        dx = shift.x(), dy = shift.y(), hx = hits.x.data(), hy = hits.y.data(),
        place = hits.place.data()
    ]() __attribute__((always_inline)) {
        VDAMF_INDEPENDENT_LANES
        for (std::size_t i = 0; i < size; ++i)
        {
            const float x = px[index[i]] + dx;
            const float y = py[index[i]] + dy;
            hx[i] = x;
            hy[i] = y;
            const bool inX = std::abs(x) < kUsefulRange;
            const bool inY = std::abs(y) < kUsefulRange;
            const bool used = inX & inY;
            constexpr float kPerMetre = 1.0F / PlaneCells::kSize;
            const auto column =
                static_cast<std::int32_t>((used ? x + kUsefulRange : 0.0F) * kPerMetre);
            const auto row =
                static_cast<std::int32_t>((used ? y + kUsefulRange : 0.0F) * kPerMetre);
            place[i] = used ? static_cast<std::uint32_t>(row << 16 | column) : PlaneCells::kNone;
        }
    });
    return hits;
}

struct Bounds
{
    std::int32_t minColumn = 0xFFFF, maxColumn = -1;
    std::int32_t minRow = 0xFFFF, maxRow = -1;
};

Bounds boundsOf(const PlaneHits& hits)
{
    Bounds bounds;
    inWideLanes([ size = hits.size(), place = hits.place.data(), all = &bounds ]()
                    __attribute__((always_inline)) {
                        Bounds b;
                        for (std::size_t i = 0; i < size; ++i)
                        {
                            const bool used = place[i] != PlaneCells::kNone;
                            const auto column = static_cast<std::int32_t>(place[i] & 0xFFFFU);
                            const auto row = static_cast<std::int32_t>(place[i] >> 16);
                            b.minColumn = std::min(b.minColumn, column);
                            b.minRow = std::min(b.minRow, row);
                            b.maxColumn = std::max(b.maxColumn, used ? column : -1);
                            b.maxRow = std::max(b.maxRow, used ? row : -1);
                        }
                        *all = b;
                    });
    return bounds;
}

// The hits of a cell.
struct Sum
{
    float x = 0.0F, y = 0.0F;
    std::uint32_t hits = 0;
    std::uint32_t place = 0;
};

// Also turns the places of the hits into the numbers of their cells.
std::vector<Sum> sumsOf(PlaneHits& hits, CellBitmap& bitmap, std::uint32_t first)
{
    for (std::uint32_t& place : hits.place)
    {
        if (place == PlaneCells::kNone) continue;
        place -= first;
        bitmap.occupy(static_cast<int>(place & 0xFFFFU), static_cast<int>(place >> 16));
    }
    std::vector<Sum> sums(bitmap.enumerate());
    // No lanes, but those processors have an instruction that counts bits.
    inWideLanes([
        &bitmap = std::as_const(bitmap), size = hits.size(), x = hits.x.data(), y = hits.y.data(),
        places = hits.place.data(), all = sums.data()
    ]() __attribute__((always_inline)) {
        for (std::size_t i = 0; i < size; ++i)
        {
            const std::uint32_t place = places[i];
            if (place == PlaneCells::kNone) continue;
            const std::uint32_t number =
                bitmap.number(static_cast<int>(place & 0xFFFFU), static_cast<int>(place >> 16));
            places[i] = number;
            Sum& sum = all[number];
            sum.x += x[i];
            sum.y += y[i];
            ++sum.hits;
            sum.place = place;
        }
    });
    return sums;
}
}  // namespace

PlaneCells sortIntoCells(const LadarFrame& frame, const AboveGround& above)
{
    PlaneHits hits = placesOf(frame, above);
    const Bounds b = boundsOf(hits);
    if (b.minColumn > b.maxColumn) return {CellBitmap(0, 0), {}, {}, {}, {}, {}, {}};
    PlaneCells cells{
        CellBitmap(b.maxColumn - b.minColumn + 1, b.maxRow - b.minRow + 1), {}, {}, {}, {}, {}, {}};
    const std::vector<Sum> sums =
        sumsOf(hits, cells.bitmap, static_cast<std::uint32_t>(b.minRow << 16 | b.minColumn));
    cells.ofHit = std::move(hits.place);
    cells.x.resize(sums.size() + PlaneCells::kPadding);
    cells.y.resize(sums.size() + PlaneCells::kPadding);
    cells.hits.resize(sums.size());
    cells.column.resize(sums.size());
    cells.row.resize(sums.size());
    for (std::size_t n = 0; n < sums.size(); ++n)
    {
        const auto count = static_cast<float>(sums[n].hits);
        cells.x[n] = sums[n].x / count;
        cells.y[n] = sums[n].y / count;
        cells.hits[n] = sums[n].hits;
        cells.column[n] = static_cast<std::uint16_t>(sums[n].place & 0xFFFFU);
        cells.row[n] = static_cast<std::uint16_t>(sums[n].place >> 16);
    }
    return cells;
}

}  // namespace vdamf
