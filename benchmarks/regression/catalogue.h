// SPDX-License-Identifier: BSD-3-Clause
// All scenarios that the regression bench can run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vdamf
{
struct RegressionScenario
{
    std::string name;                ///< of its row and its folder
    std::vector<std::string> make;   ///< program and arguments, to which -o and --truth are added
    std::vector<std::string> track;  ///< arguments of vdamf-track
    std::vector<std::string> score;  ///< arguments of vdamf-evaluate
    bool fast = false;               ///< one of the few that `--fast` runs
};

struct Catalogue
{
    std::vector<RegressionScenario> scenarios;
    std::vector<std::string> notes;  ///< what is left out, and what it needs
};

/// The scenarios below `datasets`, and where `data` (empty: none) has them, KITTI's drives
/// (`<day>/<day>_drive_NNNN_sync`) and logs of Argoverse 2 (`av2_samples/<log>`). Throws
/// std::runtime_error where a folder or a scenario cannot be read.
Catalogue catalogueOf(const std::filesystem::path& datasets, const std::filesystem::path& data);

/// Those of the names, or the fast ones, or all. Throws std::invalid_argument for a name that does
/// not exist.
std::vector<RegressionScenario> chosenFrom(const Catalogue& catalogue,
                                           const std::vector<std::string>& names, bool fastOnly);

}  // namespace vdamf
