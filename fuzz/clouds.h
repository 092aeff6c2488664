// SPDX-License-Identifier: BSD-3-Clause
// What holds of a point cloud from any file.
#pragma once

#include "require.h"
#include "vdamf/rawlog/cloud_file.h"

namespace vdamf::fuzz
{
inline void check(const FileCloud& cloud)
{
    const PointCloud& points = cloud.points;
    require(points.y.size() == points.size() && points.z.size() == points.size(),
            "coordinates are equal in number");
    require(points.intensity.empty() || points.intensity.size() == points.size(),
            "each point has an intensity or none has");
    require(cloud.times.empty() || cloud.times.size() == points.size(),
            "each point has a time or none has");
}

}  // namespace vdamf::fuzz
