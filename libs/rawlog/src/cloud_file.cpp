// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/cloud_file.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "vdamf/files/text_file.h"

namespace vdamf
{
FileCloud readCloudFile(const std::filesystem::path& path, PointTime unit)
{
    constexpr std::size_t kLargestFile = std::size_t{1} << 30;
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".bin") return parseBin(readBytes(path, kLargestFile), path.string());
    if (ending == ".pcd") return parsePcd(readTextFile(path, kLargestFile), path.string(), unit);
    if (ending == ".ply") return parsePly(readTextFile(path, kLargestFile), path.string(), unit);
    throw std::runtime_error(path.string() + ": no file of points: expected .pcd, .ply or .bin");
}

}  // namespace vdamf
