// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/box_overlap.h"

#include <algorithm>
#include <vector>

namespace vdamf
{
namespace
{
using Polygon = std::vector<Eigen::Vector2d>;

// The part of a convex polygon where the coordinate along an axis is at most `limit`
// (Sutherland and Hodgman, 1974).
Polygon clipped(const Polygon& polygon, Eigen::Index axis, double sign, double limit)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Eigen::Vector2d& from = polygon[i];
        const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()];
        const double fromOutside = sign * from[axis] - limit;
        const double toOutside = sign * to[axis] - limit;
        if (fromOutside <= 0.0) kept.push_back(from);
        if ((fromOutside < 0.0 && toOutside > 0.0) || (fromOutside > 0.0 && toOutside < 0.0))
        {
            kept.push_back(from + (to - from) * (fromOutside / (fromOutside - toOutside)));
        }
    }
    return kept;
}

double areaOf(const Polygon& polygon)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Eigen::Vector2d& a = polygon[i];
        const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * twice;
}

bool isEmpty(const OrientedBox& box)
{
    return !(box.length > 0.0 && box.width > 0.0);
}

bool areFarApart(const OrientedBox& a, const OrientedBox& b)
{
    const double reach = 0.5 * (std::hypot(a.length, a.width) + std::hypot(b.length, b.width));
    return (a.centre() - b.centre()).squaredNorm() > reach * reach;
}
}  // namespace

double intersectionArea(const OrientedBox& a, const OrientedBox& b)
{
    if (isEmpty(a) || isEmpty(b) || areFarApart(a, b)) return 0.0;
    // In the coordinates of b its sides are lines of constant x or y, and numbers stay small
    // however far from the world's origin the boxes are.
    Polygon polygon;
    for (const Eigen::Vector2d& corner : corners(a)) polygon.push_back(toBoxFrame(b, corner));
    for (const double sign : {1.0, -1.0})
    {
        polygon = clipped(polygon, 0, sign, 0.5 * b.length);
        polygon = clipped(polygon, 1, sign, 0.5 * b.width);
    }
    return std::max(0.0, areaOf(polygon));
}

double birdsEyeIou(const OrientedBox& a, const OrientedBox& b)
{
    const double common = intersectionArea(a, b);
    const double areaOfA = isEmpty(a) ? 0.0 : a.length * a.width;
    const double areaOfB = isEmpty(b) ? 0.0 : b.length * b.width;
    const double all = areaOfA + areaOfB - common;
    return all > 0.0 ? std::clamp(common / all, 0.0, 1.0) : 0.0;
}

}  // namespace vdamf
