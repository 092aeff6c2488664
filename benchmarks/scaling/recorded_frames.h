// SPDX-License-Identifier: BSD-3-Clause
// The frames of recorded drives, in memory.
#pragma once

#include <filesystem>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// Folders of KITTI raw drives below a folder, by name. Throws std::runtime_error where there are
/// none.
std::vector<std::filesystem::path> recordedDrives(const std::filesystem::path& folder);

/// The scans of a KITTI raw drive in world axes, without labels.
std::vector<LadarFrame> recordedFrames(const std::filesystem::path& drive);

}  // namespace vdamf
