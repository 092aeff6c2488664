// SPDX-License-Identifier: BSD-3-Clause
// Solids that bodies are made of: boxes, and tapered layers with rounded corners in plan.
#pragma once

#include <vector>

#include "vdamf/simulation/object_class.h"
#include "vdamf/simulation/shapes.h"

namespace vdamf
{
/// A horizontal cut at a height, by how far it is inside the box of the body.
struct Level
{
    double z = 0.0;      ///< m
    double front = 0.0;  ///< m
    double rear = 0.0;   ///< m
    double side = 0.0;   ///< m
};

/// Quarter ellipses at the corners of a cut: a bumper bowed in plan is a wide, short one.
struct Corners
{
    double frontLength = 0.0;  ///< along the heading, m
    double frontWidth = 0.0;   ///< across, m
    double rearLength = 0.0;
    double rearWidth = 0.0;
};

struct LayerMaterials
{
    Material front = Material::Paint;
    Material rear = Material::Paint;
    Material sides = Material::Paint;
    Material caps = Material::Paint;
};

/// The solid between two cuts. It is nowhere outside the hull of the two.
ConvexSolid layer(const BodySize& size, const Level& low, const Level& high, const Corners& corners,
                  const LayerMaterials& materials = {});

/// The part of a solid with x from `rear` to `front`.
ConvexSolid slice(ConvexSolid solid, double rear, double front);

/// A box with its faces along the axes, all of one material.
ConvexSolid boxSolid(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, Material material);

/// The same by its lowest and highest corner.
ConvexSolid boxBetween(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Material material);

}  // namespace vdamf
