// SPDX-License-Identifier: BSD-3-Clause
// The command line of `vdamf-train classifier`.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "classifier.h"

namespace vdamf
{
struct ClassifierCommandLine
{
    std::filesystem::path recordings;
    std::filesystem::path config;
    std::vector<std::string> set;
    ClassifierJob job;
};

void declareClassifier(CLI::App& command, ClassifierCommandLine& line);

/// Reads what the command line names. Throws std::runtime_error.
ClassifierJob prepared(const ClassifierCommandLine& line);

}  // namespace vdamf
