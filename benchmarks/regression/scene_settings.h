// SPDX-License-Identifier: BSD-3-Clause
// The same scenarios before other sensors.
#pragma once

#include <string>
#include <vector>

#include "regression/catalogue.h"

namespace vdamf
{
/// The simulated ones alone, with settings (section.key=value) for vdamf-simulate; those of
/// `sensor` are for each sensor of a scenario.
std::vector<RegressionScenario> withSceneSettings(const std::vector<RegressionScenario>& scenarios,
                                                  const std::vector<std::string>& settings);

}  // namespace vdamf
