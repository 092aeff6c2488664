// SPDX-License-Identifier: BSD-3-Clause
// The recordings of a sweep, each with its truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
struct SweepRecording
{
    std::string name;              ///< in tables: as much of the path as tells it from the others
    std::filesystem::path rawlog;  ///< absolute
    std::filesystem::path truth;   ///< absolute
    std::size_t group = 0;         ///< in SweepFile::groups
    std::uint64_t bytes = 0;       ///< of the rawlog
};

/// What the groups' patterns find, group by group, by name. Throws std::runtime_error that lists
/// every pattern without a file, every rawlog without its truth, and every rawlog that is found
/// twice.
std::vector<SweepRecording> findRecordings(const SweepFile& file);

}  // namespace vdamf
