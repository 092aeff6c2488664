// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
inline double rangeOf(const PointCloud& cloud, std::size_t i)
{
    return std::hypot(cloud.x[i], cloud.y[i], cloud.z[i]);
}

}  // namespace vdamf
