// SPDX-License-Identifier: BSD-3-Clause
// Profiles of vehicles as stacks of tapered layers.
#pragma once

#include "vdamf/simulation/body.h"

namespace vdamf
{
/// A box around the origin's z axis, shifted; its faces all of one material.
ConvexSolid boxSolid(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, Material material);

// Solids of a vehicle in the body's frame.
std::vector<ConvexSolid> carSolids(const BodySize& size);
std::vector<ConvexSolid> vanSolids(const BodySize& size);

}  // namespace vdamf
