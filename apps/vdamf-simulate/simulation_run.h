// SPDX-License-Identifier: BSD-3-Clause
// A scenario from its first to its last frame into files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "vdamf/files/output_file.h"
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
struct SimulationOutputs
{
    std::filesystem::path rawlog;
    std::filesystem::path truth;  ///< empty: none
    OutputFile::Existing existing = OutputFile::Existing::Refuse;
    int gzLevel = 1;
};

struct SimulationTotals
{
    std::size_t scans = 0;
    std::size_t poses = 0;
    std::size_t returns = 0;
};

/// Scans and poses by rising time; both files appear when all is done, or neither. `goOn` is asked
/// after each frame, with the frames done and all; false is an interruption. Throws
/// std::runtime_error that names the file, or says that it was interrupted.
SimulationTotals runSimulation(const Scenario& scenario, const SimulationOutputs& outputs,
                               const std::function<bool(int, int)>& goOn);

}  // namespace vdamf
