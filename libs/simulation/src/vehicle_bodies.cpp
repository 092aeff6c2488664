// SPDX-License-Identifier: BSD-3-Clause
// Profiles of vehicles as stacks of tapered layers.
//
// Seen from above, real bumpers are bowed: corners are cut back by about 0.2 m lengthwise and
// 0.4 m across. Seen from the side, a car is a box from sill to belt line and a much shorter
// cabin; nearly all of a van's length goes up to its roof.
#include "vehicle_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kClearance = 0.25;     ///< m
constexpr double kCornerLength = 0.20;  ///< of the rounding, along the heading, m
constexpr double kCornerWidth = 0.40;   ///< of the rounding, across, m
constexpr int kCornerFacets = 3;

/// A horizontal cut: how far it is inside the vehicle's box.
struct Inset
{
    double front = 0.0;  ///< m
    double rear = 0.0;   ///< m
    double side = 0.0;   ///< m
};

struct Level
{
    double z = 0.0;  ///< m
    Inset inset;
};

struct LayerMaterials
{
    Material ends = Material::Paint;
    Material sides = Material::Paint;
    Material caps = Material::Paint;
};

/// The cut as a polygon, counter-clockwise from the left of the front edge, with rounded corners.
std::vector<Eigen::Vector2d> contour(const BodySize& size, const Inset& inset)
{
    const double front = 0.5 * size.length - inset.front;
    const double rear = 0.5 * size.length - inset.rear;
    const double half = 0.5 * size.width - inset.side;
    const double cornerWidth = std::min(kCornerWidth, 0.8 * half);
    std::vector<Eigen::Vector2d> points;
    for (int corner = 0; corner < 4; ++corner)  // front left, rear left, rear right, front right
    {
        const double sx = corner == 0 || corner == 3 ? 1.0 : -1.0;
        const double sy = corner < 2 ? 1.0 : -1.0;
        const Eigen::Vector2d centre(sx > 0.0 ? front - kCornerLength : kCornerLength - rear,
                                     sy * (half - cornerWidth));
        for (int facet = 0; facet <= kCornerFacets; ++facet)
        {
            const double quarter = 0.5 * kPi * facet / kCornerFacets;
            const double angle = corner % 2 == 0 ? quarter : 0.5 * kPi - quarter;
            points.emplace_back(centre.x() + sx * kCornerLength * std::cos(angle),
                                centre.y() + sy * cornerWidth * std::sin(angle));
        }
    }
    return points;
}

SolidFace facePlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                    Material material)
{
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    return {normal, normal.dot(a), material};
}

/// The solid between two cuts.
ConvexSolid layer(const BodySize& size, const Level& low, const Level& high,
                  const LayerMaterials& materials)
{
    const std::vector<Eigen::Vector2d> bottom = contour(size, low.inset);
    const std::vector<Eigen::Vector2d> top = contour(size, high.inset);
    ConvexSolid solid;
    solid.faces.push_back({Eigen::Vector3d::UnitZ(), high.z, materials.caps});
    solid.faces.push_back({-Eigen::Vector3d::UnitZ(), -low.z, materials.caps});
    for (std::size_t i = 0; i < bottom.size(); ++i)
    {
        const std::size_t next = (i + 1) % bottom.size();
        const Eigen::Vector3d a(bottom[i].x(), bottom[i].y(), low.z);
        const Eigen::Vector3d b(bottom[next].x(), bottom[next].y(), low.z);
        const Eigen::Vector2d c = 0.5 * (top[i] + top[next]);
        SolidFace face = facePlane(a, b, {c.x(), c.y(), high.z}, materials.sides);
        const bool isSide = std::abs(face.normal.y()) > std::abs(face.normal.x());
        face.material = isSide ? materials.sides : materials.ends;
        solid.faces.push_back(face);
    }
    return solid;
}

void addWheels(std::vector<ConvexSolid>& solids, const BodySize& size)
{
    const Eigen::Vector3d wheel(0.6, 0.2, 0.5);
    for (const double x : {-0.28 * size.length, 0.30 * size.length})
    {
        for (const double y : {-0.5 * size.width + 0.13, 0.5 * size.width - 0.13})
        {
            solids.push_back(boxSolid({x, y, 0.5 * wheel.z()}, wheel, Material::Rubber));
        }
    }
}
}  // namespace

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

std::vector<ConvexSolid> carSolids(const BodySize& size)
{
    const double h = size.height;
    const double l = size.length;
    const Level sill{kClearance, {0.10, 0.08, 0.05}};
    const Level widest{0.30 * h, {}};
    const Level shoulder{0.50 * h, {}};
    const Level belt{0.62 * h, {0.25, 0.10, 0.05}};
    const Level cabinBase{0.62 * h, {0.26 * l, 0.06 * l, 0.07}};
    const Level roof{h, {0.42 * l, 0.14 * l, 0.20}};
    const LayerMaterials cabin{Material::Glass, Material::Glass, Material::Paint};
    std::vector<ConvexSolid> solids{
        layer(size, sill, widest, {}), layer(size, widest, shoulder, {}),
        layer(size, shoulder, belt, {}), layer(size, cabinBase, roof, cabin)};
    addWheels(solids, size);
    return solids;
}

std::vector<ConvexSolid> vanSolids(const BodySize& size)
{
    const double h = size.height;
    const double l = size.length;
    const Level sill{kClearance, {0.08, 0.05, 0.05}};
    const Level widest{0.22 * h, {}};
    const Level shoulder{0.48 * h, {}};
    const Level bonnet{0.56 * h, {0.30, 0.02, 0.02}};
    const Level boxBase{0.56 * h, {0.06 * l, 0.02, 0.02}};
    const Level roof{h, {0.20 * l, 0.08, 0.12}};
    const LayerMaterials upper{Material::Glass, Material::Paint, Material::Paint};
    std::vector<ConvexSolid> solids{
        layer(size, sill, widest, {}), layer(size, widest, shoulder, {}),
        layer(size, shoulder, bonnet, {}), layer(size, boxBase, roof, upper)};
    addWheels(solids, size);
    return solids;
}

}  // namespace vdamf
