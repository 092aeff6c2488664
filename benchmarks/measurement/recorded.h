// SPDX-License-Identifier: BSD-3-Clause
// Clusters of the labelled vehicles of real drives (KITTI raw).
#pragma once

#include <filesystem>
#include <vector>

#include "vdamf/learning/clusters/labelled_cluster.h"

namespace vdamf
{
/// Two conditions over all drives with labels below `folder`: "drive_label", the hits above ground
/// in the label's box grown by 0.3 m, and "drive_cluster", the cluster of the preprocessing with
/// most hits in the label's box. Cars, vans and trucks with ten such hits; `count` of each, evenly
/// taken from all. Throws std::runtime_error that names the folder where there is no such drive.
std::vector<LabelledClusters> recordedConditions(const std::filesystem::path& folder, int count,
                                                 std::uint64_t seed);

}  // namespace vdamf
