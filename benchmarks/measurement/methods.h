// SPDX-License-Identifier: BSD-3-Clause
// The rows of the tables: our fits and the baselines behind one signature.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_errors.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
struct Method
{
    std::string name;
    bool isBaseline = false;
    std::function<Estimate(const LabelledCluster&)> estimate;
};

/// Our fits: every filter, and Table 1 with every other optimizer, to compare with `paper`; each
/// from the sample's start ("+start") and from startBox() alone. The rows "+sizes" are told the
/// start's length and width as known sizes, too; "noise_untold" has to estimate the range noise.
/// "learned" is the bank's common filter in place of the hand-set parameters and "bank" the one
/// that it chooses for each cluster; both where there is a bank. Then the baselines.
std::vector<Method> allMethods(const MeasureOptions& options,
                               const std::shared_ptr<const FilterBank>& bank = nullptr);

}  // namespace vdamf
