// SPDX-License-Identifier: BSD-3-Clause
#include "layers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr int kCornerFacets = 3;

/// The cut as a polygon, counter-clockwise from the left of the front edge.
std::vector<Eigen::Vector2d> contour(const BodySize& size, const Level& level,
                                     const Corners& corners)
{
    const double half = 0.5 * size.width - level.side;
    std::vector<Eigen::Vector2d> points;
    for (int corner = 0; corner < 4; ++corner)  // front left, rear left, rear right, front right
    {
        const bool isFront = corner == 0 || corner == 3;
        const double sx = isFront ? 1.0 : -1.0;
        const double sy = corner < 2 ? 1.0 : -1.0;
        const double end = 0.5 * size.length - (isFront ? level.front : level.rear);
        const double length = isFront ? corners.frontLength : corners.rearLength;
        const double width = isFront ? corners.frontWidth : corners.rearWidth;
        for (int facet = 0; facet <= kCornerFacets; ++facet)
        {
            const double quarter = 0.5 * kPi * facet / kCornerFacets;
            const double angle = corner % 2 == 0 ? quarter : 0.5 * kPi - quarter;
            points.emplace_back(sx * (end - length * (1.0 - std::cos(angle))),
                                sy * (half - width * (1.0 - std::sin(angle))));
        }
    }
    return points;
}

/// Corners that leave some of each end straight at both cuts.
Corners fitted(Corners corners, const BodySize& size, const Level& low, const Level& high)
{
    const double widest = 0.8 * (0.5 * size.width - std::max(low.side, high.side));
    corners.frontWidth = std::min(corners.frontWidth, widest);
    corners.rearWidth = std::min(corners.rearWidth, widest);
    return corners;
}

Material materialOf(const Eigen::Vector3d& normal, const LayerMaterials& materials)
{
    if (std::abs(normal.y()) > std::abs(normal.x())) return materials.sides;
    return normal.x() > 0.0 ? materials.front : materials.rear;
}
}  // namespace

ConvexSolid layer(const BodySize& size, const Level& low, const Level& high, const Corners& corners,
                  const LayerMaterials& materials)
{
    const Corners rounded = fitted(corners, size, low, high);
    const std::vector<Eigen::Vector2d> bottom = contour(size, low, rounded);
    const std::vector<Eigen::Vector2d> top = contour(size, high, rounded);
    ConvexSolid solid;
    solid.faces.push_back({Eigen::Vector3d::UnitZ(), high.z, materials.caps});
    solid.faces.push_back({-Eigen::Vector3d::UnitZ(), -low.z, materials.caps});
    for (std::size_t i = 0; i < bottom.size(); ++i)
    {
        const std::size_t next = (i + 1) % bottom.size();
        const Eigen::Vector3d a(bottom[i].x(), bottom[i].y(), low.z);
        const Eigen::Vector3d b(bottom[next].x(), bottom[next].y(), low.z);
        if ((b - a).norm() < 1e-9) continue;  // a corner without rounding
        // The edges of both cuts are parallel, so one point of the upper one says the plane.
        const Eigen::Vector3d c(top[i].x(), top[i].y(), high.z);
        const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
        solid.faces.push_back({normal, normal.dot(a), materialOf(normal, materials)});
    }
    return solid;
}

ConvexSolid slice(ConvexSolid solid, double rear, double front)
{
    const Material inside = Material::Rubber;  // the dark lining of a wheel house
    solid.faces.push_back({Eigen::Vector3d::UnitX(), front, inside});
    solid.faces.push_back({-Eigen::Vector3d::UnitX(), -rear, inside});
    return solid;
}

ConvexSolid boxSolid(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, Material material)
{
    ConvexSolid solid;
    for (int axis = 0; axis < 3; ++axis)
    {
        const Eigen::Vector3d normal = Eigen::Vector3d::Unit(axis);
        solid.faces.push_back({normal, centre[axis] + 0.5 * size[axis], material});
        solid.faces.push_back({-normal, 0.5 * size[axis] - centre[axis], material});
    }
    return solid;
}

ConvexSolid boxBetween(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Material material)
{
    return boxSolid(0.5 * (low + high), high - low, material);
}

}  // namespace vdamf
