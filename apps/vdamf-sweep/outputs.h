// SPDX-License-Identifier: BSD-3-Clause
// The files that a sweep leaves beside its runs, and what it says at the end.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/experiments/results.h"
#include "vdamf/experiments/sweep.h"
#include "vdamf/files/output_file.h"

namespace vdamf
{
constexpr const char* kSweepCopy = "sweep.ini";

/// What writeSweepCopy() and writeOutputs() write.
std::vector<std::string> outputNames();

/// The sweep's file, its configuration, the models and filters that these name, the recordings and
/// their truth.
std::vector<NamedInput> inputsOf(const PreparedSweep& sweep);

/// Throws std::runtime_error where an output would replace an input.
void checkOutputs(const PreparedSweep& sweep, const std::filesystem::path& folder);

/// The sweep's file as it was at the start.
void writeSweepCopy(const PreparedSweep& sweep, const std::filesystem::path& folder);

/// table.csv, times.csv, report.html and, where a setting is the best, best.ini. Those of an
/// earlier sweep in the folder are replaced.
void writeOutputs(const PreparedSweep& sweep, const SweepResults& results,
                  const std::filesystem::path& folder);

/// The best setting and where to look further, on stdout.
void printOutcome(const PreparedSweep& sweep, const SweepResults& results, std::size_t skipped,
                  const std::filesystem::path& folder);

}  // namespace vdamf
