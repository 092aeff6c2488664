// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cloud_fields.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/cloud_file.h"
#include "vdamf/rawlog/kitti_drive.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kPointBytes = 16;

std::size_t countPoints(std::string_view bytes, const std::string& name)
{
    if (!bytes.empty() && bytes.size() % kPointBytes == 0) return bytes.size() / kPointBytes;
    throw std::runtime_error(name + ": has " + std::to_string(bytes.size()) +
                             " bytes; expected 16 a point: the file is cut short");
}
}  // namespace

FileCloud parseBin(std::string_view bytes, const std::string& name)
{
    const std::vector<CloudField> fields{{"x", 'F', 4, 1, 0},
                                         {"y", 'F', 4, 1, 4},
                                         {"z", 'F', 4, 1, 8},
                                         {"intensity", 'F', 4, 1, 12}};
    const std::size_t count = countPoints(bytes, name);
    CloudBuilder builder(fields, name, PointTime::None);
    builder.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const char* const point = bytes.data() + i * kPointBytes;
        builder.add([&](std::size_t f)
                    { return numberAt(point + fields[f].offset, fields[f], false); });
    }
    return std::move(builder).finish();
}

// As the data set has none, a point that is not finite is damage.
PointCloud readKittiScan(const std::filesystem::path& path)
{
    const std::string bytes = readBytes(path);
    const std::size_t count = countPoints(bytes, path.string());
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
