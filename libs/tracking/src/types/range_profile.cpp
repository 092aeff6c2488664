// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/types/range_profile.h"

#include <algorithm>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
std::size_t sectorAt(double bearing, std::size_t sectors)
{
    const double turn = (wrapAngle(bearing) + kPi) / (2.0 * kPi);
    return std::min(static_cast<std::size_t>(turn * static_cast<double>(sectors)), sectors - 1);
}
}  // namespace

double RangeProfile::at(double bearing) const
{
    if (nearest.empty()) return std::numeric_limits<double>::infinity();
    return static_cast<double>(nearest[sectorAt(bearing, nearest.size())]);
}

double RangeProfile::at(double bearing, double slope) const
{
    const double all = at(bearing);
    const double layer = (slope - kLowestLayer) / kLayer;
    if (all == 0.0 || nearestAbove.empty() || !(layer >= 1.0)) return all;
    const auto whole = static_cast<std::size_t>(std::min(layer, kLayers - 1.0));
    return static_cast<double>(
        nearestAbove[whole * nearest.size() + sectorAt(bearing, nearest.size())]);
}

}  // namespace vdamf
