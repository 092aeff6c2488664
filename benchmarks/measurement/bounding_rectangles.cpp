// SPDX-License-Identifier: BSD-3-Clause
// Minimum-area rectangle and principal axes.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "measurement/baselines.h"

namespace vdamf
{
namespace
{
using Polygon = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Counter-clockwise, without collinear corners (Andrew's monotone chain).
Polygon convexHull(const PlanePoints& points)
{
    Polygon sorted;
    for (Eigen::Index i = 0; i < points.cols(); ++i) sorted.emplace_back(points.col(i));
    std::sort(sorted.begin(), sorted.end(),
              [](const Eigen::Vector2d& a, const Eigen::Vector2d& b)
              { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    Polygon hull;
    const auto extend = [&hull](const Eigen::Vector2d& p, std::size_t least)
    {
        while (hull.size() > least &&
               cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Eigen::Vector2d& p : sorted) extend(p, 1);
    const std::size_t lower = hull.size();
    for (auto p = sorted.rbegin() + 1; p != sorted.rend(); ++p) extend(*p, lower);
    if (hull.size() > 1) hull.pop_back();
    return hull;
}

// The corner farthest along a direction, searched onwards from a corner: on a convex polygon the
// distance along a direction has one maximum.
std::size_t farthestFrom(const Polygon& hull, std::size_t from, const Eigen::Vector2d& direction)
{
    std::size_t corner = from;
    for (std::size_t tried = 0; tried < hull.size(); ++tried)
    {
        const std::size_t next = (corner + 1) % hull.size();
        if ((hull[next] - hull[corner]).dot(direction) < 0.0) break;
        corner = next;
    }
    return corner;
}
}  // namespace

OrientedBox minimumAreaBox(const PlanePoints& points)
{
    const Polygon hull = convexHull(points);
    if (hull.size() < 3)
    {
        const Eigen::Vector2d along = hull.back() - hull.front();
        return boundingBox(points, std::atan2(along.y(), along.x()));
    }
    double bestArea = 1e300;
    double bestHeading = 0.0;
    std::array<std::size_t, 3> calipers = {0, 0, 0};  // farthest ahead, opposite, and behind
    for (std::size_t i = 0; i < hull.size(); ++i)
    {
        const Eigen::Vector2d along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
        const Eigen::Vector2d inwards(-along.y(), along.x());
        calipers[0] = farthestFrom(hull, i == 0 ? 1 : calipers[0], along);
        calipers[1] = farthestFrom(hull, i == 0 ? calipers[0] : calipers[1], inwards);
        calipers[2] = farthestFrom(hull, i == 0 ? calipers[1] : calipers[2], -along);
        const double area = (hull[calipers[0]] - hull[calipers[2]]).dot(along) *
                            (hull[calipers[1]] - hull[i]).dot(inwards);
        if (area >= bestArea) continue;
        bestArea = area;
        bestHeading = std::atan2(along.y(), along.x());
    }
    return boundingBox(points, bestHeading);
}

OrientedBox principalAxisBox(const PlanePoints& points)
{
    const PlanePoints centred = points.colwise() - points.rowwise().mean();
    const Eigen::Matrix2d scatter = centred * centred.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(scatter);
    const Eigen::Vector2d along = eigen.eigenvectors().col(1);
    return boundingBox(points, std::atan2(along.y(), along.x()));
}

}  // namespace vdamf
