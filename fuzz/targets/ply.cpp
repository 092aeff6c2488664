// SPDX-License-Identifier: BSD-3-Clause
// A point cloud in a PLY file.
#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/cloud_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    fuzz::mayRefuse(
        [&]
        {
            const FileCloud cloud = parsePly(fuzz::textOf(data, size), "fuzz.ply");
            const PointCloud& points = cloud.points;
            fuzz::require(points.y.size() == points.size() && points.z.size() == points.size(),
                          "coordinates are equal in number");
            fuzz::require(points.intensity.empty() || points.intensity.size() == points.size(),
                          "each point has an intensity or none has");
            fuzz::require(cloud.times.empty() || cloud.times.size() == points.size(),
                          "each point has a time or none has");
        });
    return 0;
}
