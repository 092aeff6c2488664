// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
// Four little-endian floats a point: x, y, z, reflectance.
PointCloud readKittiScan(const std::filesystem::path& path)
{
    constexpr std::size_t kPointBytes = 16;
    const std::string bytes = readBytes(path);
    if (bytes.empty() || bytes.size() % kPointBytes != 0)
    {
        throw std::runtime_error(path.string() + ": has " + std::to_string(bytes.size()) +
                                 " bytes; expected 16 a point: the file is cut short");
    }
    const std::size_t count = bytes.size() / kPointBytes;
    PointCloud scan;
    for (auto* values : {&scan.x, &scan.y, &scan.z, &scan.intensity}) values->reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        float point[4] = {};
        std::memcpy(point, bytes.data() + i * kPointBytes, kPointBytes);
        for (const float value : point)
        {
            if (std::isfinite(value)) continue;
            throw std::runtime_error(path.string() + ": point " + std::to_string(i) +
                                     " is not finite; the file is damaged");
        }
        scan.x.push_back(point[0]);
        scan.y.push_back(point[1]);
        scan.z.push_back(point[2]);
        scan.intensity.push_back(point[3]);
    }
    return scan;
}

}  // namespace vdamf
