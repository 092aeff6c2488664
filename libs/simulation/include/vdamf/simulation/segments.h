// SPDX-License-Identifier: BSD-3-Clause
// Motion as text in a scenario file: segments and manoeuvres, one after another.
#pragma once

#include <string_view>
#include <vector>

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
/// Items separated by commas, words by blanks. Empty: none. An item is numbers,
///
///     duration_s acceleration_mps2 curvature_1pm [curvature_at_the_end_1pm]
///
/// or a manoeuvre (manoeuvres.h). `speed` is that at the begin, m/s. Throws std::runtime_error that
/// says which item is wrong and what was expected.
std::vector<MotionSegment> parseSegments(std::string_view text, double speed = 0.0);

}  // namespace vdamf
