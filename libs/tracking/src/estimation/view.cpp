// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/view.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kNearest = 0.5;     // m
constexpr double kOtherSide = 0.5;   // rad, after which other parts of the body are seen
constexpr double kOtherRange = 0.5;  // of ln(range), after which other beams hit them
}  // namespace

View viewOf(const OrientedBox& box, const Eigen::Vector2d& sensor)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    return {std::atan2(view.y(), view.x()), std::max(kNearest, view.norm())};
}

double changeOfView(const View& before, const View& after)
{
    const double turned = std::abs(wrapAngle(after.bearing - before.bearing));
    const double nearer = std::abs(std::log(after.range / before.range));
    return std::min(1.0, turned / kOtherSide + nearer / kOtherRange);
}

}  // namespace vdamf
