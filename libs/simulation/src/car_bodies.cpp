// SPDX-License-Identifier: BSD-3-Clause
// Cars and vans.
//
// Seen from above, bumpers are bowed: corners are cut back by about 0.3 m lengthwise and 0.6 m
// across. Seen from the side, the ends are full-length only at bumper height (0.45 to 0.65 m):
// sill, bonnet and boot lid are 0.1 to 0.3 m shorter, and the cabin is much shorter. Wheels stand
// in wheel houses.
#include <algorithm>

#include "bodies.h"
#include "layers.h"

namespace vdamf
{
namespace
{
constexpr double kBumperZ = 0.45;   ///< height at which it is longest and widest, m
constexpr double kArchWidth = 0.3;  ///< depth of the wheel houses, m

/// Where the profile of a car turns, as shares of its length or height.
struct CarProfile
{
    double belt;        ///< height of the windows' lower edge
    double bonnet;      ///< length of the bonnet
    double boot;        ///< length of the boot lid
    double windscreen;  ///< from the front to the roof
    double rearWindow;  ///< from the rear to the roof
    double clearance;   ///< m
    double wheel;       ///< radius, m
};

CarProfile profileOf(ObjectClass style)
{
    switch (style)
    {
        case ObjectClass::Hatchback:
            return {0.62, 0.21, 0.03, 0.40, 0.13, 0.20, 0.31};
        case ObjectClass::Suv:
            return {0.63, 0.22, 0.02, 0.38, 0.09, 0.26, 0.36};
        case ObjectClass::Van:
            return {0.56, 0.14, 0.01, 0.29, 0.03, 0.22, 0.33};
        default:
            return {0.62, 0.24, 0.12, 0.42, 0.27, 0.20, 0.32};
    }
}

struct Axles
{
    double front;  ///< x, m
    double rear;   ///< x, m
    double radius;
};

Axles axlesOf(const BodySize& size, const CarProfile& profile)
{
    return {0.30 * size.length, -0.28 * size.length,
            std::min({profile.wheel, 0.085 * size.length, 0.24 * size.height})};
}

/// A layer with gaps for the wheels.
void addBetweenWheels(std::vector<ConvexSolid>& solids, const ConvexSolid& whole,
                      const BodySize& size, const Axles& axles)
{
    const double gap = axles.radius + 0.07;
    solids.push_back(slice(whole, axles.front + gap, size.length));
    solids.push_back(slice(whole, axles.rear + gap, axles.front - gap));
    solids.push_back(slice(whole, -size.length, axles.rear - gap));
}

/// Sill to the top of the wheel houses.
std::vector<ConvexSolid> underbody(const BodySize& size, const CarProfile& profile,
                                   const Axles& axles, const Corners& corners)
{
    const Level sill{profile.clearance, 0.18, 0.12, 0.06};
    const Level bumper{kBumperZ, 0.0, 0.0, 0.0};
    const Level arch{2.1 * axles.radius, 0.04, 0.02, 0.0};
    Level spineTop = arch;
    Level spine = sill;
    spine.side = spineTop.side = std::min(kArchWidth, 0.3 * size.width);
    spine.front = spineTop.front = 0.3;
    spine.rear = spineTop.rear = 0.3;
    const LayerMaterials dark{Material::Rubber, Material::Rubber, Material::Rubber,
                              Material::Rubber};
    std::vector<ConvexSolid> solids{layer(size, spine, spineTop, {}, dark)};
    addBetweenWheels(solids, layer(size, sill, bumper, corners), size, axles);
    addBetweenWheels(solids, layer(size, bumper, arch, corners), size, axles);
    return solids;
}

void addWheels(Body& body, const BodySize& size, const Axles& axles)
{
    const double y = 0.5 * size.width - 0.13;
    for (const double x : {axles.front, axles.rear})
    {
        body.wheels.push_back({{x, y, axles.radius}, axles.radius, 0.2, Material::Rubber});
        body.wheels.push_back({{x, -y, axles.radius}, axles.radius, 0.2, Material::Rubber});
    }
}

/// What cars and vans share: all up to the belt line.
Body lowerBody(const BodySize& size, const CarProfile& profile, const Corners& corners)
{
    const double h = size.height;
    const double l = size.length;
    const Axles axles = axlesOf(size, profile);
    const Level arch{2.1 * axles.radius, 0.04, 0.02, 0.0};
    const Level nose{std::max(0.54 * h, arch.z + 0.02), 0.16, 0.06, 0.01};
    const Level belt{std::max(profile.belt * h, nose.z + 0.02), profile.bonnet * l, 0.06 + 0.01 * l,
                     0.05};
    Body body;
    body.solids = underbody(size, profile, axles, corners);
    body.solids.push_back(layer(size, arch, nose, corners));
    body.solids.push_back(layer(size, nose, belt, corners));
    addWheels(body, size, axles);
    return body;
}
}  // namespace

Body carBody(ObjectClass style, const BodySize& size)
{
    const CarProfile profile = profileOf(style);
    const double h = size.height;
    const double l = size.length;
    Body body = lowerBody(size, profile, {0.30, 0.60, 0.20, 0.50});
    const Level base{profile.belt * h - 0.01, profile.bonnet * l, profile.boot * l, 0.06};
    const Level roof{h, profile.windscreen * l, profile.rearWindow * l, 0.11 * size.width};
    const LayerMaterials cabin{Material::Glass, Material::Glass, Material::Glass, Material::Paint};
    body.solids.push_back(layer(size, base, roof, {0.15, 0.45, 0.10, 0.30}, cabin));
    return body;
}

Body vanBody(const BodySize& size)
{
    const CarProfile profile = profileOf(ObjectClass::Van);
    const double h = size.height;
    const double l = size.length;
    Body body = lowerBody(size, profile, {0.22, 0.55, 0.06, 0.15});
    const Level base{0.50 * h, profile.bonnet * l, profile.boot * l, 0.02};
    const Level roof{h, profile.windscreen * l, profile.rearWindow * l, 0.06 * size.width};
    const LayerMaterials upper{Material::Glass, Material::Paint, Material::Paint, Material::Paint};
    body.solids.push_back(layer(size, base, roof, {0.12, 0.45, 0.06, 0.12}, upper));
    return body;
}

}  // namespace vdamf
