// SPDX-License-Identifier: BSD-3-Clause
// The command line of `vdamf-train filter`.
#pragma once

#include <CLI/CLI.hpp>

#include "filter.h"
#include "training_inputs.h"

namespace vdamf
{
struct FilterCommandLine
{
    TrainingInputs inputs;
    FilterJob job;
};

void declareFilter(CLI::App& command, FilterCommandLine& line);

/// Reads what the command line names. Throws std::runtime_error.
FilterJob prepared(const FilterCommandLine& line);

}  // namespace vdamf
