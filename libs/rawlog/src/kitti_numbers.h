// SPDX-License-Identifier: BSD-3-Clause
// Rows of numbers and calibration matrices of KITTI's text files.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
/// Exactly `count` numbers between blanks; throws std::runtime_error "where: ...".
std::vector<double> numbersOf(std::string_view text, const std::string& where, std::size_t count);

/// The lines `R:` (9 numbers, by rows) and `T:` (3, m) of a calibration file. Throws
/// std::runtime_error that names file and line, also where R is not a rotation.
Eigen::Isometry3d readRigidTransform(const std::filesystem::path& path);

}  // namespace vdamf
