// SPDX-License-Identifier: BSD-3-Clause
// Times of recorded traffic.
#pragma once

#include <cmath>
#include <string>

#include "vdamf/files/numbers.h"
#include "vdamf/simulation/scenario_options.h"

namespace vdamf
{
/// What is wrong with a time so many seconds from that of the first row; empty: nothing. Motion
/// takes memory for all of its span.
inline std::string spanProblem(double seconds)
{
    if (std::abs(seconds) <= kLongestScene) return "";
    return "it is " + toFixedText(seconds, 1) + " s from the first row's, and a scene lasts " +
           toText(kLongestScene) + " s at most";
}

}  // namespace vdamf
