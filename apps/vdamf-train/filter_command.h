// SPDX-License-Identifier: BSD-3-Clause
// The command line of `vdamf-train filter`.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "filter.h"

namespace vdamf
{
struct FilterCommandLine
{
    std::filesystem::path sources;
    std::filesystem::path config;
    std::vector<std::string> set;
    FilterJob job;
};

void declareFilter(CLI::App& command, FilterCommandLine& line);

/// Reads what the command line names. Throws std::runtime_error.
FilterJob prepared(const FilterCommandLine& line);

}  // namespace vdamf
