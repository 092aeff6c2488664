// SPDX-License-Identifier: BSD-3-Clause
// Which parameters are optimised together.
#pragma once

#include <string>
#include <vector>

#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
struct ParameterBound
{
    double* value;
    double min;
    double max;
};

/// Names a group and lists its members in a set of parameters.
struct ParameterGroup
{
    std::string name;
    bool global = false;  ///< worth a global search: its objective has several valleys
    std::vector<ParameterBound> (*of)(FilterParameters&) = nullptr;
};

/// In the order in which they are learned.
std::vector<ParameterGroup> parameterGroups(FilterKind kind);

}  // namespace vdamf
