// SPDX-License-Identifier: BSD-3-Clause
// What all subcommands of vdamf-train read: a list of recordings, and the tracker's configuration.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "vdamf/files/ini.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
struct TrainingInputs
{
    std::filesystem::path list;
    std::filesystem::path config;
    std::vector<std::string> set;
};

/// `name`, `meaning`: of the list on the command line.
void declareInputs(CLI::App& command, TrainingInputs& inputs, const std::string& name,
                   const std::string& meaning);

/// The list, with what the command line sets over it. Throws std::runtime_error.
IniDocument readList(const TrainingInputs& inputs);

/// All files that are read, which no output may replace. `recordings` have a rawlog and a truth.
template <class Recordings>
std::vector<NamedInput> namedInputs(const TrainingInputs& inputs,
                                    const Configuration& configuration,
                                    const Recordings& recordings)
{
    std::vector<NamedInput> named = filesNamedBy(configuration);
    named.push_back({inputs.list, "the list of what to train on"});
    named.push_back({inputs.config, "the configuration"});
    for (const auto& recording : recordings)
    {
        named.push_back({recording.rawlog, "an input"});
        named.push_back({recording.truth, "an input"});
    }
    return named;
}

}  // namespace vdamf
