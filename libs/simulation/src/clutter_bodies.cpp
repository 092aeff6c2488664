// SPDX-License-Identifier: BSD-3-Clause
// What stands by a road.
#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "layers.h"

namespace vdamf
{
namespace
{
constexpr double kTrunkRadius = 0.15;  ///< m
constexpr double kPostSpacing = 2.0;   ///< of a guard rail, m
}  // namespace

/// Leaves from the ground up to the size's height, widest at 40 % of it. The part of the
/// ellipsoid below the ground is out of reach.
Body bushBody(const BodySize& size)
{
    const Eigen::Vector3d radii(0.5 * size.length, 0.5 * size.width, 0.6 * size.height);
    Body body;
    body.foliage = {{{Eigen::Vector3d(0.0, 0.0, 0.4 * size.height), radii}, 0.3}};
    return body;
}

/// A trunk, and a crown over the upper two thirds of the height.
Body treeBody(const BodySize& size)
{
    const double half = size.height / 3.0;
    const Eigen::Vector3d radii(0.5 * size.length, 0.5 * size.width, half);
    Body body;
    body.foliage = {{{Eigen::Vector3d(0.0, 0.0, size.height - half), radii}, 0.8}};
    body.cylinders = {
        {Eigen::Vector2d::Zero(), kTrunkRadius, 0.0, 0.6 * size.height, Material::Wood}};
    return body;
}

Body poleBody(const BodySize& size)
{
    const double radius = 0.5 * std::min(size.width, size.length);
    Body body;
    body.cylinders = {{Eigen::Vector2d::Zero(), radius, 0.0, size.height, Material::Metal}};
    return body;
}

/// A beam along both sides of a row of posts, over the upper 40 % of the height.
Body guardRailBody(const BodySize& size)
{
    const double x = 0.5 * size.length;
    const double y = 0.5 * size.width;
    const double plate = std::min(0.08, 0.5 * size.width);
    const double low = 0.6 * size.height;
    Body body;
    body.solids = {boxBetween({-x, y - plate, low}, {x, y, size.height}, Material::Metal),
                   boxBetween({-x, -y, low}, {x, plate - y, size.height}, Material::Metal)};
    const double radius = std::min({0.06, y, x});
    const int gaps = std::max(1, static_cast<int>(std::lround(size.length / kPostSpacing)));
    for (int i = 0; i <= gaps; ++i)
    {
        const double at = (2.0 * i / gaps - 1.0) * (x - radius);
        body.cylinders.push_back({{at, 0.0}, radius, 0.0, 0.98 * size.height, Material::Metal});
    }
    return body;
}

/// A plate on a pole; it faces along the heading, and is as high as it is wide.
Body signBody(const BodySize& size)
{
    const double x = 0.5 * size.length;
    const double y = 0.5 * size.width;
    const double low = std::max(0.0, size.height - size.width);
    const double radius = std::min({0.04, x, y});
    Body body;
    body.solids = {boxBetween({-x, -y, low}, {x, y, size.height}, Material::Reflector)};
    body.cylinders = {{Eigen::Vector2d::Zero(), radius, 0.0, size.height, Material::Metal}};
    return body;
}

}  // namespace vdamf
