// SPDX-License-Identifier: BSD-3-Clause
// Recorded traffic as objects of a scene.
#pragma once

#include <string>
#include <vector>

#include "vdamf/simulation/recording.h"
#include "vdamf/simulation/scene.h"

namespace vdamf
{
struct TrafficObjects
{
    std::vector<SceneObject> objects;
    std::vector<std::string> warnings;  ///< how many are not as they are labelled, and which
};

/// Objects exist from their first to their last label; those with fewer than 5 labels are left out.
/// What is smaller than its class allows is a box in the scene. Throws std::runtime_error that
/// names the object whose labels are wrong.
TrafficObjects trafficOf(const Recording& recording, double smoothing);

}  // namespace vdamf
