// SPDX-License-Identifier: BSD-3-Clause
// The rows of the tables: our fits and the baselines behind one signature.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measurement/sample.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
struct Estimate
{
    OrientedBox box;
    std::optional<Measurement> measurement;  ///< of our fits
};

struct Method
{
    std::string name;
    bool isBaseline = false;
    std::function<Estimate(const Sample&)> estimate;
};

/// Our fits: every filter, and Table 1 with every other optimizer, to compare with `paper`; each
/// from the sample's start ("+start") and from startBox() alone. The rows "+sizes" are told the
/// start's length and width as known sizes, too; "noise_untold" has to estimate the range noise.
/// Then the baselines.
std::vector<Method> allMethods(const MeasureOptions& options);

}  // namespace vdamf
