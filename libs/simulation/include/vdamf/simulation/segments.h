// SPDX-License-Identifier: BSD-3-Clause
// Motion segments as text in a scenario file.
#pragma once

#include <string_view>
#include <vector>

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
/// "duration_s acceleration_mps2 curvature_1pm, ...": three numbers with blanks between them a
/// segment, segments separated by commas. Empty: none. Throws std::runtime_error that says which
/// segment is wrong and what was expected.
std::vector<MotionSegment> parseSegments(std::string_view text);

}  // namespace vdamf
