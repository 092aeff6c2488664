// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/preprocessing/range_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vdamf
{
RangeProfile rangeProfile(const LadarFrame& frame, const AboveGround& aboveGround)
{
    constexpr std::size_t kSectors = 720;
    constexpr float kHidingHeight = 0.6F;  // m
    constexpr float kPerRadian = static_cast<float>(kSectors) / 6.2831853F;
    RangeProfile profile;
    profile.nearest.assign(kSectors, std::numeric_limits<float>::infinity());
    const Eigen::Vector2f sensor = (frame.sensor - frame.origin).head<2>().cast<float>();
    for (std::size_t k = 0; k < aboveGround.index.size(); ++k)
    {
        if (aboveGround.height[k] < kHidingHeight) continue;
        const float dx = frame.points.x[aboveGround.index[k]] - sensor.x();
        const float dy = frame.points.y[aboveGround.index[k]] - sensor.y();
        const auto sector =
            static_cast<std::size_t>((std::atan2(dy, dx) + 3.1415927F) * kPerRadian);
        float& nearest = profile.nearest[std::min(sector, kSectors - 1)];
        nearest = std::min(nearest, std::hypot(dx, dy));
    }
    return profile;
}

}  // namespace vdamf
