// SPDX-License-Identifier: BSD-3-Clause
// Where the sensor looks: bearings with hits of any kind, on the ground too.
#pragma once

#include <bitset>

#include "vdamf/tracking/types/point_cloud.h"

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
};

}  // namespace vdamf
