// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/field_of_view.h"

#include <algorithm>
#include <cmath>

#include "preprocessing/bearing.h"
#include "preprocessing/sample.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLeastGap = 4;  // sectors that the sensor does not look at
constexpr float kFarthest = 1e6F;     // m

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
    first_.fill(1.0F);
    last_.fill(0.0F);
    const std::size_t step = sampleStep(points.size());
    for (std::size_t i = 0; i < points.size(); i += step)
    {
        const float x = points.x[i] - sensor.x();
        const float y = points.y[i] - sensor.y();
        // From bearing -pi on: of the opposite direction from 0 on.
        if (!(x * x + y * y < kFarthest * kFarthest)) continue;  // nor what is no number
        const float turn = turns(-x, -y, FineArc());
        const std::size_t sector = sectorOf(turn, kSectors);
        seen_.set(sector);
        first_[sector] = std::min(first_[sector], turn);
        last_[sector] = std::max(last_[sector], turn);
    }
    // Narrow gaps are where nothing was hit.
    const auto emptyFrom = [this](std::size_t sector)
    {
        std::size_t count = 0;
        while (count < kSectors && !seen_.test((sector + count) % kSectors)) ++count;
        return count;
    };
    for (std::size_t sector = 0; sector < kSectors; ++sector)
    {
        if (!seen_.test(sector)) continue;
        const std::size_t gap = emptyFrom((sector + 1) % kSectors);
        for (std::size_t k = 1; gap < kLeastGap && k <= gap; ++k)
            seen_.set((sector + k) % kSectors);
    }
}

bool FieldOfView::has(double bearing) const
{
    const double turn = (wrapAngle(bearing) + kPi) / (2.0 * kPi);
    const std::size_t sector = sectorOf(turn, kSectors);
    if (!seen_.test(sector)) return false;
    // The view ends with the outermost hit before a sector without any.
    const bool goesOnBefore = seen_.test((sector + kSectors - 1) % kSectors);
    const bool goesOnBehind = seen_.test((sector + 1) % kSectors);
    return (goesOnBefore || turn >= static_cast<double>(first_[sector])) &&
           (goesOnBehind || turn <= static_cast<double>(last_[sector]));
}

RangeProfile withinView(RangeProfile profile, const FieldOfView& view)
{
    const auto size = static_cast<double>(profile.nearest.size());
    double middle = 0.5;
    for (float& nearest : profile.nearest)
    {
        if (!view.has(middle / size * 2.0 * kPi - kPi)) nearest = 0.0F;
        middle += 1.0;
    }
    return profile;
}

}  // namespace vdamf
