// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/field_of_view.h"

#include <algorithm>
#include <cmath>

#include "preprocessing/bearing.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kSample = 4000;  // hits are enough to tell

// By the share of a turn from bearing -pi on.
std::size_t sectorOf(double turn, std::size_t sectors)
{
    return std::min(sectors - 1, static_cast<std::size_t>(turn * static_cast<double>(sectors)));
}
}  // namespace

FieldOfView::FieldOfView(const LadarFrame& frame)
{
    const PointCloud& points = frame.points;
    const Eigen::Vector2f sensor = (frame.sensor - frame.origin).head<2>().cast<float>();
    const std::size_t step = 1 + points.size() / kSample;
    for (std::size_t i = 0; i < points.size(); i += step)
    {
        const float x = points.x[i] - sensor.x();
        const float y = points.y[i] - sensor.y();
        // From bearing -pi on: of the opposite direction from 0 on.
        if (std::isfinite(x) && std::isfinite(y))
            seen_.set(sectorOf(turns(-x, -y, FineArc()), kSectors));
    }
}

bool FieldOfView::has(double bearing) const
{
    return seen_.test(sectorOf((wrapAngle(bearing) + kPi) / (2.0 * kPi), kSectors));
}

}  // namespace vdamf
