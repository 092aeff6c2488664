// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/matched_filter/filter_bank.h"

#include <algorithm>

namespace vdamf
{
const TypedFilter& commonFilter(const FilterBank& bank)
{
    const auto any =
        std::find_if(bank.filters.begin(), bank.filters.end(),
                     [](const TypedFilter& filter) { return filter.type == VehicleType::Any; });
    return any != bank.filters.end() ? *any : bank.filters.front();
}

}  // namespace vdamf
