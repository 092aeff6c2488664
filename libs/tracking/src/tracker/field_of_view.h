// SPDX-License-Identifier: BSD-3-Clause
// Where the sensor looks: bearings with hits of any kind, on the ground too.
#pragma once

#include <array>
#include <bitset>

#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/range_profile.h"

namespace vdamf
{
class FieldOfView
{
public:
    explicit FieldOfView(const LadarFrame& frame);

    /// Whether the sensor looks along a bearing (rad, any turn): what stood there would be hit.
    bool has(double bearing) const;

private:
    static constexpr std::size_t kSectors = 72;
    std::bitset<kSectors> seen_;
    std::array<float, kSectors> first_, last_;  // share of a turn of the outermost hits in each
};

/// The profile with range zero where the sensor does not look: whatever is there is hidden.
RangeProfile withinView(RangeProfile profile, const FieldOfView& view);

}  // namespace vdamf
