// SPDX-License-Identifier: BSD-3-Clause
// The bodies of simulated objects.
#include "vdamf/simulation/body.h"

#include <cmath>
#include <stdexcept>

#include "bodies.h"
#include "layers.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
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

Body bodyOf(ObjectClass objectClass, const BodySize& size)
{
    const Eigen::Vector3d extent(size.length, size.width, size.height);
    const Eigen::Vector3d middle(0.0, 0.0, 0.5 * size.height);
    Body body;
    switch (objectClass)
    {
        case ObjectClass::Car:
        case ObjectClass::Hatchback:
        case ObjectClass::Suv:
            return carBody(objectClass, size);
        case ObjectClass::Van:
            return vanBody(size);
        case ObjectClass::Truck:
            return truckBody(size);
        case ObjectClass::Trailer:
            return trailerBody(size);
        case ObjectClass::Bus:
            return busBody(size);
        case ObjectClass::Tram:
            return tramBody(size);
        case ObjectClass::Motorcycle:
            return motorcycleBody(size);
        case ObjectClass::Bicycle:
            return bicycleBody(size);
        case ObjectClass::Pedestrian:
            return pedestrianBody(size);
        case ObjectClass::Bush:
            return bushBody(size);
        case ObjectClass::Tree:
            return treeBody(size);
        case ObjectClass::Pole:
            return poleBody(size);
        case ObjectClass::GuardRail:
            return guardRailBody(size);
        case ObjectClass::Sign:
            return signBody(size);
        case ObjectClass::Wall:
            body.solids = {boxSolid(middle, extent, Material::Concrete)};
            return body;
        case ObjectClass::Box:
            body.solids = {boxSolid(middle, extent, Material::Metal)};
            return body;
    }
    return body;
}
}  // namespace

Body makeBody(ObjectClass objectClass, const BodySize& size)
{
    if (!(size.length > 0.0 && size.width > 0.0 && size.height > 0.0))
    {
        throw std::runtime_error("length, width and height of an object must be above 0");
    }
    const BodySize least = leastSizeOf(objectClass);
    if (size.length < least.length || size.width < least.width || size.height < least.height)
    {
        throw std::runtime_error("a " + nameOf(objectClass) + " is at least " +
                                 toText(least.length) + " m long, " + toText(least.width) +
                                 " m wide and " + toText(least.height) +
                                 " m high, so that its profile fits");
    }
    Body body = bodyOf(objectClass, size);
    body.radius = 0.5 * std::hypot(size.length, size.width);
    body.height = size.height;
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
    for (const Wheel& wheel : body.wheels) keepNearer(nearest, intersect(wheel, ray));
    for (const Foliage& foliage : body.foliage) keepNearer(nearest, leafHit(foliage, ray, random));
    return nearest;
}

}  // namespace vdamf
