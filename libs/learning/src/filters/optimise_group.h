// SPDX-License-Identifier: BSD-3-Clause
// One run of nlopt over a group of parameters.
#pragma once

#include <functional>

#include "filters/parameter_groups.h"

namespace vdamf
{
struct GroupSearch
{
    bool global = false;
    int evaluations = 0;
};

/// The better of the start and what was found from it. Every parameter is searched from 0.4 to 2.5
/// times its start, inside of its bounds; a weak pull to the start keeps what the clusters do not
/// tell of where it is. `cost` is called `evaluations` times at most; its exceptions pass through.
FilterParameters optimiseGroup(const FilterParameters& start, const ParameterGroup& group,
                               const GroupSearch& search,
                               const std::function<double(const FilterParameters&)>& cost);

}  // namespace vdamf
