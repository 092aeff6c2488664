// SPDX-License-Identifier: BSD-3-Clause
// Trucks, trailers, buses and trams. Trucks and trailers carry a box with upright walls and
// square corners above an open chassis; buses and trams are closed down to their skirts.
#include <algorithm>

#include "bodies.h"
#include "layers.h"

namespace vdamf
{
namespace
{
constexpr double kTruckWheel = 0.5;  ///< radius, m
constexpr double kDeck = 1.05;       ///< height of a loading floor, m

void addTruckWheels(Body& body, const BodySize& size, double x, double tyres)
{
    const double y = 0.5 * (size.width - tyres) - 0.03;
    const double radius = std::min(kTruckWheel, 0.15 * size.height);
    body.wheels.push_back({{x, y, radius}, radius, tyres, Material::Rubber});
    body.wheels.push_back({{x, -y, radius}, radius, tyres, Material::Rubber});
}

/// The loading floor's box, its frame, and the bar that keeps cars from driving under it.
void addLoad(Body& body, const BodySize& size, double rear, double front)
{
    const double y = 0.5 * size.width;
    const double deck = std::min(kDeck, 0.35 * size.height);
    body.solids.push_back(boxBetween({rear, -y, deck}, {front, y, size.height}, Material::Paint));
    body.solids.push_back(
        boxBetween({rear + 0.4, -0.45, 0.4}, {front, 0.45, deck}, Material::Metal));
    body.solids.push_back(
        boxBetween({rear + 0.1, 0.1 - y, 0.42}, {rear + 0.2, y - 0.1, 0.56}, Material::Metal));
}

/// A layer with gaps for wheels at two axles.
void addSkirts(Body& body, const ConvexSolid& whole, const BodySize& size, double frontAxle,
               double rearAxle, double gap)
{
    body.solids.push_back(slice(whole, frontAxle + gap, size.length));
    body.solids.push_back(slice(whole, rearAxle + gap, frontAxle - gap));
    body.solids.push_back(slice(whole, -size.length, rearAxle - gap));
}
}  // namespace

Body truckBody(const BodySize& size)
{
    const double front = 0.5 * size.length;
    const double cabLength = std::min(2.1, 0.35 * size.length);
    const double cabRear = size.length - cabLength;
    const double h = std::min(0.9 * size.height, 3.0);
    const Corners corners{0.12, 0.35, 0.0, 0.0};
    const LayerMaterials glass{Material::Glass, Material::Paint, Material::Glass, Material::Paint};
    Body body;
    addLoad(body, size, -front, front - cabLength - 0.15);
    body.solids.push_back(boxBetween({front - cabLength - 0.15, -0.45, 0.4},
                                     {front - 0.3, 0.45, 0.35 * size.height}, Material::Metal));
    body.solids.push_back(
        layer(size, {0.35, 0.05, cabRear, 0.06}, {0.5 * h, 0.0, cabRear, 0.03}, corners));
    body.solids.push_back(layer(size, {0.5 * h, 0.02, cabRear, 0.03},
                                {0.85 * h, 0.15, cabRear, 0.08}, corners, glass));
    body.solids.push_back(
        layer(size, {0.85 * h, 0.15, cabRear, 0.08}, {h, 0.35, cabRear, 0.15}, corners));
    addTruckWheels(body, size, front - 0.65 * cabLength, 0.3);
    addTruckWheels(body, size, -rearAxleOffsetOf(ObjectClass::Truck, size.length), 0.55);
    return body;
}

Body trailerBody(const BodySize& size)
{
    Body body;
    addLoad(body, size, -0.5 * size.length, 0.5 * size.length);
    const double middle = -rearAxleOffsetOf(ObjectClass::Trailer, size.length);
    const double apart = std::min(0.65, 0.15 * size.length);
    addTruckWheels(body, size, middle - apart, 0.4);
    addTruckWheels(body, size, middle + apart, 0.4);
    return body;
}

Body busBody(const BodySize& size)
{
    const double h = size.height;
    const Corners corners{0.25, 0.45, 0.15, 0.30};
    const LayerMaterials glass{Material::Glass, Material::Glass, Material::Glass, Material::Paint};
    const Level floor{0.25, 0.08, 0.08, 0.04};
    const Level skirt{0.30 * h, 0.0, 0.0, 0.0};
    const Level window{0.36 * h, 0.0, 0.0, 0.0};
    const Level head{0.80 * h, 0.12, 0.05, 0.05};
    const double frontAxle = 0.27 * size.length;
    const double rearAxle = -rearAxleOffsetOf(ObjectClass::Bus, size.length);
    const double inside = 0.18 * size.width;
    Body body;
    body.solids.push_back(
        layer(size, {0.25, 0.3, 0.3, inside}, {skirt.z, 0.3, 0.3, inside}, {},
              {Material::Rubber, Material::Rubber, Material::Rubber, Material::Rubber}));
    addSkirts(body, layer(size, floor, skirt, corners), size, frontAxle, rearAxle, 0.6);
    body.solids.push_back(layer(size, skirt, window, corners));
    body.solids.push_back(layer(size, window, head, corners, glass));
    body.solids.push_back(layer(size, head, {h, 0.25, 0.12, 0.12}, corners));
    addTruckWheels(body, size, frontAxle, 0.3);
    addTruckWheels(body, size, rearAxle, 0.5);
    return body;
}

Body tramBody(const BodySize& size)
{
    const double h = size.height;
    const Corners corners{0.8, 0.7, 0.8, 0.7};
    const LayerMaterials glass{Material::Glass, Material::Glass, Material::Glass, Material::Paint};
    const Level window{0.36 * h, 0.0, 0.0, 0.0};
    const Level head{0.78 * h, 0.5, 0.5, 0.06};
    Body body;
    body.solids.push_back(layer(size, {0.2, 0.2, 0.2, 0.05}, {0.25 * h, 0.0, 0.0, 0.0}, corners));
    body.solids.push_back(layer(size, {0.25 * h, 0.0, 0.0, 0.0}, window, corners));
    body.solids.push_back(layer(size, window, head, corners, glass));
    body.solids.push_back(layer(size, head, {h, 0.9, 0.9, 0.15}, corners));
    return body;
}

}  // namespace vdamf
