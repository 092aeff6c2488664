// SPDX-License-Identifier: BSD-3-Clause
// Solids that a ray can hit: convex polyhedra, cylinders, ellipsoids.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "vdamf/simulation/materials.h"

namespace vdamf
{
struct Ray
{
    Eigen::Vector3d origin;     ///< m
    Eigen::Vector3d direction;  ///< unit length
};

/// Where a ray from outside meets a surface.
struct SurfaceHit
{
    double range = 0.0;         ///< along the ray, > 0, m
    double cosIncidence = 1.0;  ///< between the ray and the normal, 0..1
    Material material = Material::Concrete;
};

/// A plane that bounds a solid: inside is normal . p <= offset.
struct SolidFace
{
    Eigen::Vector3d normal;  ///< outwards, unit length
    double offset = 0.0;     ///< m
    Material material = Material::Concrete;
};

/// The intersection of half-spaces.
struct ConvexSolid
{
    std::vector<SolidFace> faces;
};

struct UprightCylinder
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;  ///< m
    double bottom = 0.0;  ///< z, m
    double top = 0.0;     ///< z, m
    Material material = Material::Metal;
};

/// A cylinder whose axis lies along y.
struct Wheel
{
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0.3;  ///< m
    double width = 0.2;   ///< along y, m
    Material material = Material::Rubber;
};

struct Ellipsoid
{
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d radii = Eigen::Vector3d::Ones();  ///< along x, y, z, m
};

/// The stretch of a ray inside a solid.
struct RayInterval
{
    double enter = 0.0;  ///< >= 0, m
    double leave = 0.0;  ///< m
};

// The first surface that the ray meets; nothing where it misses or starts inside.
std::optional<SurfaceHit> intersect(const ConvexSolid& solid, const Ray& ray);
std::optional<SurfaceHit> intersect(const UprightCylinder& cylinder, const Ray& ray);
std::optional<SurfaceHit> intersect(const Wheel& wheel, const Ray& ray);

/// The part of the ray inside the ellipsoid, from 0 where it starts inside.
std::optional<RayInterval> passage(const Ellipsoid& ellipsoid, const Ray& ray);

}  // namespace vdamf
