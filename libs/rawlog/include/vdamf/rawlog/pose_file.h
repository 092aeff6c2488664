// SPDX-License-Identifier: BSD-3-Clause
// Poses and times as other programs write them.
#pragma once

#include <mrpt/core/Clock.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <vector>

namespace vdamf
{
struct FilePose
{
    std::optional<double> time;  ///< s (UNIX); nothing in KITTI's format
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< in the file's world, m
};

/// One pose a line, the first one tells the format:
///  - TUM: `time tx ty tz qx qy qz qw`;
///  - KITTI: the twelve numbers of a 3x4 matrix, by rows.
/// Blank lines and those that begin with `#` do not count. Throws std::runtime_error that names
/// file and line: bad number, another count of numbers, what is no rotation, TUM times that do not
/// rise, are before 0 or not in seconds; and for a file without any pose.
std::vector<FilePose> readPoseFile(const std::filesystem::path& path);

/// One time a line: seconds, or `2011-09-26 13:02:25.963999987`. Throws std::runtime_error that
/// names file and line, also where they do not rise, are before 0 or in another unit.
std::vector<double> readTimeFile(const std::filesystem::path& path);

}  // namespace vdamf
