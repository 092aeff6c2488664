// SPDX-License-Identifier: BSD-3-Clause
// Point clouds in files of their own: PCD, PLY, KITTI's .bin.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// How the field of the hits' times is to be taken.
enum class PointTime
{
    Auto,  ///< s where it is a floating-point number, ns where it is an integer
    None,  ///< not at all
    Seconds,
    Milliseconds,
    Microseconds,
    Nanoseconds
};

/// The hits of a file with the ending .pcd, .ply or .bin, in its own frame. Hits with a coordinate
/// or a time that is not finite, or at 1000 km or more, are left out. Intensities (fields
/// intensity, i, reflectivity, remission) come out as 0..1; times (fields t, time, timestamp,
/// time_offset, offset_time) as they are, in s: from any origin. Throws std::runtime_error that
/// names the file and the line or byte.
struct FileCloud
{
    PointCloud points;          ///< without times
    std::vector<double> times;  ///< s; empty: none
    std::size_t leftOut = 0;    ///< hits
};
FileCloud readCloudFile(const std::filesystem::path& path, PointTime unit = PointTime::Auto);

/// PCD 0.7: ascii, binary, binary_compressed. `name` stands in messages.
FileCloud parsePcd(std::string_view bytes, const std::string& name,
                   PointTime unit = PointTime::Auto);
/// PLY 1.0: ascii and binary of either byte order; the element `vertex`.
FileCloud parsePly(std::string_view bytes, const std::string& name,
                   PointTime unit = PointTime::Auto);
/// KITTI's .bin: four little-endian floats a point: x, y, z, intensity.
FileCloud parseBin(std::string_view bytes, const std::string& name);

}  // namespace vdamf
