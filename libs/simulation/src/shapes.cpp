// SPDX-License-Identifier: BSD-3-Clause
// Ray intersections in closed form.
#include "vdamf/simulation/shapes.h"

#include <cmath>
#include <limits>

namespace vdamf
{
namespace
{
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<double> sideHit(const UprightCylinder& cylinder, const Ray& ray)
{
    const Eigen::Vector2d d = ray.direction.head<2>();
    const Eigen::Vector2d o = ray.origin.head<2>() - cylinder.centre;
    const double a = d.squaredNorm();
    const double c = o.squaredNorm() - cylinder.radius * cylinder.radius;
    if (a == 0.0 || c <= 0.0) return std::nullopt;  // upright ray, or start inside the circle
    const double b = o.dot(d);
    const double discriminant = b * b - a * c;
    if (b >= 0.0 || discriminant < 0.0) return std::nullopt;
    const double range = c / (-b + std::sqrt(discriminant));
    const double z = ray.origin.z() + range * ray.direction.z();
    if (z < cylinder.bottom || z > cylinder.top) return std::nullopt;
    return range;
}

std::optional<double> capHit(const UprightCylinder& cylinder, const Ray& ray)
{
    const bool fromAbove = ray.direction.z() < 0.0;
    const double height = (fromAbove ? cylinder.top : cylinder.bottom) - ray.origin.z();
    if (ray.direction.z() == 0.0 || height / ray.direction.z() <= 0.0) return std::nullopt;
    const double range = height / ray.direction.z();
    const Eigen::Vector2d p = ray.origin.head<2>() + range * ray.direction.head<2>();
    if ((p - cylinder.centre).norm() > cylinder.radius) return std::nullopt;
    return range;
}
}  // namespace

std::optional<SurfaceHit> intersect(const ConvexSolid& solid, const Ray& ray)
{
    double enter = 0.0;
    double leave = kInfinity;
    double cosIncidence = 0.0;
    const SolidFace* entry = nullptr;
    for (const SolidFace& face : solid.faces)
    {
        const double outside = face.normal.dot(ray.origin) - face.offset;
        const double approach = -face.normal.dot(ray.direction);
        if (approach > 0.0)
        {
            const double range = outside / approach;
            if (range <= enter) continue;
            enter = range;
            entry = &face;
            cosIncidence = approach;
        }
        else if (outside > 0.0)
        {
            return std::nullopt;  // outside this face and moving along it or away
        }
        else if (approach < 0.0)
        {
            leave = std::min(leave, outside / approach);
        }
        if (enter > leave) return std::nullopt;
    }
    if (entry == nullptr) return std::nullopt;
    return SurfaceHit{enter, std::min(cosIncidence, 1.0), entry->material};
}

std::optional<SurfaceHit> intersect(const UprightCylinder& cylinder, const Ray& ray)
{
    if (const std::optional<double> range = sideHit(cylinder, ray))
    {
        const Eigen::Vector2d p = ray.origin.head<2>() + *range * ray.direction.head<2>();
        const Eigen::Vector2d normal = (p - cylinder.centre) / cylinder.radius;
        const double cosIncidence = -normal.dot(ray.direction.head<2>());
        return SurfaceHit{*range, std::min(cosIncidence, 1.0), cylinder.material};
    }
    const Eigen::Vector2d start = ray.origin.head<2>() - cylinder.centre;
    const bool startsInside = start.norm() < cylinder.radius && ray.origin.z() > cylinder.bottom &&
                              ray.origin.z() < cylinder.top;
    if (startsInside) return std::nullopt;
    if (const std::optional<double> range = capHit(cylinder, ray))
    {
        return SurfaceHit{*range, std::abs(ray.direction.z()), cylinder.material};
    }
    return std::nullopt;
}

std::optional<SurfaceHit> intersect(const Wheel& wheel, const Ray& ray)
{
    // Mirrored at the plane y = z it stands upright.
    const auto mirrored = [](const Eigen::Vector3d& v)
    { return Eigen::Vector3d(v.x(), v.z(), v.y()); };
    const double half = 0.5 * wheel.width;
    const UprightCylinder upright{{wheel.centre.x(), wheel.centre.z()},
                                  wheel.radius,
                                  wheel.centre.y() - half,
                                  wheel.centre.y() + half,
                                  wheel.material};
    return intersect(upright, Ray{mirrored(ray.origin), mirrored(ray.direction)});
}

std::optional<RayInterval> passage(const Ellipsoid& ellipsoid, const Ray& ray)
{
    // Scaled so that the ellipsoid is the unit ball.
    const Eigen::Vector3d o = (ray.origin - ellipsoid.centre).cwiseQuotient(ellipsoid.radii);
    const Eigen::Vector3d d = ray.direction.cwiseQuotient(ellipsoid.radii);
    const double a = d.squaredNorm();
    const double b = o.dot(d);
    const double discriminant = b * b - a * (o.squaredNorm() - 1.0);
    if (discriminant <= 0.0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    const double leave = (-b + root) / a;
    if (leave <= 0.0) return std::nullopt;
    return RayInterval{std::max(0.0, (-b - root) / a), leave};
}

}  // namespace vdamf
