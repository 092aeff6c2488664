// SPDX-License-Identifier: BSD-3-Clause
// The sensors of a scenario file.
#pragma once

#include <vector>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// Sections [sensor] and [sensor NAME] in the order of the file; one with defaults where there is
/// none. What is wrong becomes a problem of the reader.
std::vector<SimulatedSensor> readSensors(const IniDocument& document, IniReader& reader,
                                         const RunOptions& run);

}  // namespace vdamf
