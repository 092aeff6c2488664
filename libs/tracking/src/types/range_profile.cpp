// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/range_profile.h"

#include <algorithm>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
double RangeProfile::at(double bearing) const
{
    if (nearest.empty()) return std::numeric_limits<double>::infinity();
    const double turn = (wrapAngle(bearing) + kPi) / (2.0 * kPi);
    const auto sector = static_cast<std::size_t>(turn * static_cast<double>(nearest.size()));
    return static_cast<double>(nearest[std::min(sector, nearest.size() - 1)]);
}

}  // namespace vdamf
