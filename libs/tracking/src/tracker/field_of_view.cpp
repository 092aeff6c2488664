// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/field_of_view.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kSample = 4000;  // hits are enough to tell

std::size_t sectorOf(double bearing, std::size_t sectors)
{
    const double turns = (wrapAngle(bearing) + kPi) / (2.0 * kPi);
    return std::min(sectors - 1, static_cast<std::size_t>(turns * static_cast<double>(sectors)));
}
}  // namespace

FieldOfView::FieldOfView(const LadarFrame& frame)
{
    const PointCloud& points = frame.points;
    const Eigen::Vector2d sensor = (frame.sensor - frame.origin).head<2>();
    const std::size_t step = 1 + points.size() / kSample;
    for (std::size_t i = 0; i < points.size(); i += step)
    {
        const double x = points.x[i] - sensor.x();
        const double y = points.y[i] - sensor.y();
        if (std::isfinite(x) && std::isfinite(y)) seen_.set(sectorOf(std::atan2(y, x), kSectors));
    }
}

bool FieldOfView::has(double bearing) const
{
    return seen_.test(sectorOf(bearing, kSectors));
}

}  // namespace vdamf
