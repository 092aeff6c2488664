// SPDX-License-Identifier: BSD-3-Clause
// The job of `vdamf-train filter`.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "filter_sources.h"
#include "vdamf/learning/train_filter.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
struct FilterJob
{
    FilterSources sources;
    Configuration configuration;
    FilterTrainingOptions training;
    std::filesystem::path filters;  ///< to write
    std::filesystem::path table;    ///< of held-out errors to write (CSV); empty: none
    bool overwrite = false;
    bool quiet = false;
    std::string version;
};

/// Runs the job and prints what came out. Throws std::runtime_error.
/// All files that the job writes.
std::vector<std::filesystem::path> outputsOf(const FilterJob& job);

void trainFilter(const FilterJob& job, const std::atomic<bool>& stop);

}  // namespace vdamf
