// SPDX-License-Identifier: BSD-3-Clause
// The bodies of simulated objects.
#include "vdamf/simulation/body.h"

#include <cmath>
#include <stdexcept>

#include "vehicle_bodies.h"

namespace vdamf
{
namespace
{
constexpr double kTrunkRadius = 0.15;  ///< m

void requireRoomForProfile(const BodySize& size)
{
    if (size.length < 2.0 || size.width < 1.0 || size.height < 1.0)
    {
        throw std::runtime_error(
            "a vehicle is at least 2 m long, 1 m wide and 1 m high, so that its profile fits");
    }
}

/// Leaves from the ground up to the size's height, widest at 40 % of it. The part of the
/// ellipsoid below the ground is out of reach.
Foliage bush(const BodySize& size)
{
    const Eigen::Vector3d radii(0.5 * size.length, 0.5 * size.width, 0.6 * size.height);
    return {{Eigen::Vector3d(0.0, 0.0, 0.4 * size.height), radii}, 0.3};
}

/// A crown over the upper two thirds of the height.
Foliage crown(const BodySize& size)
{
    const double half = size.height / 3.0;
    const Eigen::Vector3d radii(0.5 * size.length, 0.5 * size.width, half);
    return {{Eigen::Vector3d(0.0, 0.0, size.height - half), radii}, 0.8};
}

void keepNearer(std::optional<SurfaceHit>& nearest, const std::optional<SurfaceHit>& hit)
{
    if (hit && (!nearest || hit->range < nearest->range)) nearest = hit;
}

std::optional<SurfaceHit> leafHit(const Foliage& foliage, const Ray& ray, RandomStream& random)
{
    const std::optional<RayInterval> inside = passage(foliage.volume, ray);
    if (!inside) return std::nullopt;
    const double range = inside->enter + random.exponential(foliage.meanFreePath);
    if (range >= inside->leave) return std::nullopt;
    return SurfaceHit{range, 1.0, Material::Foliage};
}
}  // namespace

bool isVehicle(ObjectClass objectClass)
{
    return objectClass == ObjectClass::Car || objectClass == ObjectClass::Van ||
           objectClass == ObjectClass::Truck;
}

BodySize typicalSize(ObjectClass objectClass)
{
    switch (objectClass)
    {
        case ObjectClass::Car:
            return {4.5, 1.8, 1.5};
        case ObjectClass::Van:
            return {5.4, 2.0, 2.1};
        case ObjectClass::Truck:
            return {9.0, 2.5, 3.3};
        case ObjectClass::Bush:
            return {2.0, 1.5, 1.2};
        case ObjectClass::Tree:
            return {4.0, 4.0, 7.0};
        case ObjectClass::Pole:
            return {0.2, 0.2, 5.0};
        case ObjectClass::Wall:
            return {20.0, 0.3, 2.0};
        case ObjectClass::Box:
            return {1.0, 1.0, 1.0};
    }
    return {1.0, 1.0, 1.0};
}

Body makeBody(ObjectClass objectClass, const BodySize& size)
{
    if (!(size.length > 0.0 && size.width > 0.0 && size.height > 0.0))
    {
        throw std::runtime_error("length, width and height of an object must be above 0");
    }
    if (isVehicle(objectClass)) requireRoomForProfile(size);
    const Eigen::Vector3d extent(size.length, size.width, size.height);
    const Eigen::Vector3d middle(0.0, 0.0, 0.5 * size.height);
    const Eigen::Vector2d axis = Eigen::Vector2d::Zero();
    Body body;
    body.radius = 0.5 * std::hypot(size.length, size.width);
    body.height = size.height;
    switch (objectClass)
    {
        case ObjectClass::Car:
            body.solids = carSolids(size);
            break;
        case ObjectClass::Van:
        case ObjectClass::Truck:
            body.solids = vanSolids(size);
            break;
        case ObjectClass::Bush:
            body.foliage = {bush(size)};
            break;
        case ObjectClass::Tree:
            body.foliage = {crown(size)};
            body.cylinders = {{axis, kTrunkRadius, 0.0, 0.6 * size.height, Material::Wood}};
            break;
        case ObjectClass::Pole:
            body.cylinders = {{axis, 0.5 * size.width, 0.0, size.height, Material::Metal}};
            break;
        case ObjectClass::Wall:
            body.solids = {boxSolid(middle, extent, Material::Concrete)};
            break;
        case ObjectClass::Box:
            body.solids = {boxSolid(middle, extent, Material::Metal)};
            break;
    }
    return body;
}

std::optional<SurfaceHit> firstHit(const Body& body, const Ray& ray, RandomStream& random)
{
    std::optional<SurfaceHit> nearest;
    for (const ConvexSolid& solid : body.solids) keepNearer(nearest, intersect(solid, ray));
    for (const UprightCylinder& cylinder : body.cylinders)
    {
        keepNearer(nearest, intersect(cylinder, ray));
    }
    for (const Foliage& foliage : body.foliage) keepNearer(nearest, leafHit(foliage, ray, random));
    return nearest;
}

}  // namespace vdamf
