// SPDX-License-Identifier: BSD-3-Clause
// When the clouds of a folder were taken.
#pragma once

#include <string>
#include <vector>

#include "vdamf/rawlog/cloud_import.h"
#include "vdamf/rawlog/pose_file.h"

namespace vdamf
{
struct CloudTimes
{
    std::vector<double> seconds;  ///< of each cloud, rising
    std::string source;           ///< for people
};

/// As importClouds() says. Throws std::runtime_error that says what is missing.
CloudTimes cloudTimes(const CloudImport& job, const std::vector<std::filesystem::path>& clouds,
                      const std::vector<FilePose>& poses);

}  // namespace vdamf
