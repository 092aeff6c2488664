// SPDX-License-Identifier: BSD-3-Clause
// Pedestrians and two-wheelers. A rider is there where the body is as high as one.
#include <algorithm>

#include "bodies.h"
#include "layers.h"

namespace vdamf
{
namespace
{
constexpr double kRiderHeight = 1.35;  ///< lowest height of a body with a rider, m

/// A limb or a head.
UprightCylinder stick(double x, double y, double radius, double bottom, double top)
{
    return {{x, y}, radius, bottom, top, Material::Cloth};
}

/// A torso as wide as `width`, leaning forward from (x, low) by `lean` up to `high`.
ConvexSolid torso(double width, double x, double low, double high, double lean)
{
    const BodySize size{0.24 + 2.0 * std::abs(x) + 2.0 * lean, width, high};
    const double half = 0.5 * size.length;
    const Level hips{low, half - x - 0.12, half + x - 0.12, 0.15 * width};
    const Level shoulders{high, half - x - lean - 0.12, half + x + lean - 0.12, 0.0};
    const LayerMaterials cloth{Material::Cloth, Material::Cloth, Material::Cloth, Material::Cloth};
    return layer(size, hips, shoulders, {0.08, 0.1, 0.08, 0.1}, cloth);
}

void addWheelPair(Body& body, const BodySize& size, double radius, double width)
{
    const double x = 0.5 * size.length - radius;
    body.wheels.push_back({{x, 0.0, radius}, radius, width, Material::Rubber});
    body.wheels.push_back({{-x, 0.0, radius}, radius, width, Material::Rubber});
}

/// Handlebars as wide as the body: they touch the sides of its box.
ConvexSolid handlebars(const BodySize& size, double height)
{
    return boxSolid({0.22 * size.length, 0.0, height}, {0.06, size.width, 0.06}, Material::Metal);
}

/// Sits on a saddle at a height.
void addRider(Body& body, const BodySize& size, double saddle)
{
    const double shoulders = size.height - 0.27;
    const double width = std::min(0.45, size.width);
    body.solids.push_back(torso(width, -0.12 * size.length, saddle, shoulders, 0.2));
    body.cylinders.push_back(
        stick(0.24 - 0.12 * size.length, 0.0, 0.1, shoulders + 0.02, size.height));
    const double y = std::min(0.15, 0.5 * size.width - 0.07);
    body.cylinders.push_back(stick(0.02, y, 0.07, 0.2, saddle + 0.05));
    body.cylinders.push_back(stick(0.10, -y, 0.07, 0.3, saddle + 0.1));
}
}  // namespace

Body bicycleBody(const BodySize& size)
{
    const bool isRidden = size.height >= kRiderHeight;
    const double saddle = isRidden ? 0.52 * size.height : 0.85 * size.height;
    const double radius = std::min({0.34, 0.22 * size.length, 0.45 * saddle});
    const double bar = std::min(saddle + 0.1, size.height - 0.03);
    Body body;
    addWheelPair(body, size, radius, std::min(0.05, size.width));
    body.solids.push_back(boxBetween({-0.2 * size.length, -0.02, saddle - 0.25},
                                     {0.22 * size.length, 0.02, saddle - 0.15}, Material::Metal));
    body.cylinders.push_back({{0.22 * size.length, 0.0}, 0.02, radius, bar, Material::Metal});
    body.cylinders.push_back({{-0.12 * size.length, 0.0}, 0.03, radius, saddle, Material::Metal});
    body.solids.push_back(handlebars(size, bar));
    if (isRidden) addRider(body, size, saddle);
    return body;
}

Body motorcycleBody(const BodySize& size)
{
    const bool isRidden = size.height >= kRiderHeight;
    const double saddle = isRidden ? 0.5 * size.height : 0.75 * size.height;
    const double radius = std::min({0.31, 0.16 * size.length, 0.45 * saddle});
    const double half = std::min(0.2, 0.4 * size.width);
    const double bar = std::min(saddle + 0.2, size.height - 0.03);
    Body body;
    addWheelPair(body, size, radius, std::min(0.14, size.width));
    body.solids.push_back(boxBetween({-0.25 * size.length, -half, 0.5 * saddle},
                                     {0.2 * size.length, half, saddle}, Material::Paint));
    body.solids.push_back(boxBetween({-0.42 * size.length, -0.6 * half, 0.75 * saddle},
                                     {-0.25 * size.length, 0.6 * half, saddle}, Material::Paint));
    body.cylinders.push_back({{0.24 * size.length, 0.0}, 0.06, radius, bar, Material::Metal});
    body.solids.push_back(handlebars(size, bar));
    if (isRidden) addRider(body, size, saddle);
    return body;
}

Body pedestrianBody(const BodySize& size)
{
    const double h = size.height;
    const double leg = 0.075;
    // In mid-stride: the feet reach to the box's ends, the arms to its sides.
    const double stride = std::max(0.0, 0.5 * size.length - leg);
    const double hip = std::min(0.1, std::max(0.0, 0.5 * size.width - leg));
    const double shoulders = 0.84 * h;
    Body body;
    body.cylinders.push_back(stick(stride, hip, leg, 0.0, 0.26 * h));
    body.cylinders.push_back(stick(-stride, -hip, leg, 0.0, 0.26 * h));
    body.cylinders.push_back(stick(0.5 * stride, hip, leg, 0.26 * h, 0.5 * h));
    body.cylinders.push_back(stick(-0.5 * stride, -hip, leg, 0.26 * h, 0.5 * h));
    const BodySize trunk{std::min(0.26, size.length), size.width, h};
    const LayerMaterials cloth{Material::Cloth, Material::Cloth, Material::Cloth, Material::Cloth};
    body.solids.push_back(layer(trunk, {0.45 * h, 0.0, 0.0, 0.1 * size.width},
                                {shoulders, 0.03, 0.03, 0.0}, {0.1, 0.1, 0.1, 0.1}, cloth));
    body.cylinders.push_back(stick(0.0, 0.0, std::min(0.1, 0.4 * size.width), shoulders, h));
    return body;
}

}  // namespace vdamf
