// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "types/hit_bounds.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
namespace
{
// How closely the hits keep to the edges of their bounds (Zhang et al., IV 2017).
double closenessTo(const HitBounds& b, const Hits& hits, const Direction& along)
{
    constexpr double kClosest = 0.1;  // m; nearer to an edge than this is on it
    double closeness = 0.0;
    inWideLanes([
        b, c = along.cos, s = along.sin, size = hits.size(), px = hits.x.data(), py = hits.y.data(),
        weights = hits.weight.data(), result = &closeness
    ]() __attribute__((always_inline)) {
        Doubles sum{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Doubles hx;
            Doubles hy;
            Doubles weight;
            load(hx, px + first, count);
            load(hy, py + first, count);
            load(weight, weights + first, count);
            const Doubles x = c * hx + s * hy;
            const Doubles y = c * hy - s * hx;
            const Doubles ends = x - b.minX < b.maxX - x ? x - b.minX : b.maxX - x;
            const Doubles sides = y - b.minY < b.maxY - y ? y - b.minY : b.maxY - y;
            const Doubles edge = ends < sides ? ends : sides;
            sum += weight / (edge > kClosest ? edge : Doubles{} + kClosest);
        };
        inGroupsOf<kLanes<Doubles>>(size, add);
        *result = sumOf(sum);
    });
    return closeness;
}
}  // namespace

double widestEnd(double height)
{
    constexpr double kLow = 2.2;  // m
    return height < kLow ? 2.15 : 2.7;
}

OrientedBox startBox(const Hits& hits, const Eigen::Vector2d& sensor, double widestEnd,
                     const FitOptions& options)
{
    constexpr double kTwoFaces = 1.0;  // m; a rectangle at least this wide shows both
    constexpr int kHeadings = 30;      // over a quarter turn
    if (hits.size() == 0) return {};
    double heading = 0.0;
    HitBounds best = boundsAlong(directionOf(heading), hits);
    double closest = closenessTo(best, hits, directionOf(heading));
    for (int k = 1; k < kHeadings; ++k)
    {
        const double angle = 0.5 * kPi * k / kHeadings;
        const Direction along = directionOf(angle);
        const HitBounds b = boundsAlong(along, hits);
        const double closeness = closenessTo(b, hits, along);
        if (closeness > closest)
        {
            closest = closeness;
            best = b;
            heading = angle;
        }
    }
    const Eigen::Vector2d centre =
        rotation(heading) *
        Eigen::Vector2d(0.5 * (best.minX + best.maxX), 0.5 * (best.minY + best.maxY));
    double length = best.maxX - best.minX;
    double width = best.maxY - best.minY;
    const bool endAlone =
        std::max(length, width) < widestEnd && std::min(length, width) < kTwoFaces;
    const bool headingAlongLonger = !endAlone;
    if ((length >= width) != headingAlongLonger)
    {
        heading += 0.5 * kPi;
        std::swap(length, width);
    }
    if (rotation(heading).col(0).dot(centre - sensor) < 0.0) heading += kPi;
    return {centre.x(), centre.y(), wrapAngle(heading),
            std::clamp(length, options.minLength, options.maxLength),
            std::clamp(width, options.minWidth, options.maxWidth)};
}

OrientedBox movedOntoHits(const OrientedBox& box, const Hits& hits, const Eigen::Vector2d& sensor)
{
    if (hits.size() == 0) return box;
    const HitBounds bounds = boundsAlong(directionOf(box.heading), hits);
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    // Along each axis: the near face if the sensor is beyond it, the middle if it is abreast.
    const auto centreAlong = [](double min, double max, double size, double sensorAlong)
    {
        if (sensorAlong > 0.5 * size) return max - 0.5 * size;
        if (sensorAlong < -0.5 * size) return min + 0.5 * size;
        return 0.5 * (min + max);
    };
    const Eigen::Vector2d centre =
        rotation(box.heading) *
        Eigen::Vector2d(centreAlong(bounds.minX, bounds.maxX, box.length, view.x()),
                        centreAlong(bounds.minY, bounds.maxY, box.width, view.y()));
    OrientedBox moved = box;
    moved.x = centre.x();
    moved.y = centre.y();
    return moved;
}

}  // namespace vdamf
