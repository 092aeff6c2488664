// SPDX-License-Identifier: BSD-3-Clause
#include "filter_command.h"

#include "vdamf/files/ini.h"
#include "vdamf/files/output_file.h"

namespace vdamf
{
void declareFilter(CLI::App& command, FilterCommandLine& line)
{
    FilterTrainingOptions& training = line.job.training;
    command
        .add_option("sources", line.sources,
                    "what to train and test on (ini, sections [recording NAME], [simulated NAME])")
        ->required();
    command.add_option("-o,--output", line.job.filters, "filters to write")->required();
    command.add_option("--held-out", line.job.table, "table of held-out errors to write (CSV)");
    command.add_option("-c,--config", line.config, "configuration of the tracker (ini)");
    command.add_option("--set", line.set, "section.key=value over the sources (repeatable)")
        ->allow_extra_args(false);
    command.add_flag("--bank", training.bank, "also a filter for each type of vehicle");
    command
        .add_option("--global", training.globalEvaluations,
                    "evaluations of the global search, for each filter")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command
        .add_option("--local", training.localEvaluations,
                    "evaluations of each local search; there are two or three for each filter")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command.add_option("--folds", training.folds, "of the cross-validation by vehicles; 0: none")
        ->check(CLI::Range(0, 50))
        ->capture_default_str();
    command.add_option("--seed", training.seed, "of the split into folds")->capture_default_str();
    command.add_flag("--overwrite", line.job.overwrite, "replace existing outputs");
    command.add_flag("-q,--quiet", line.job.quiet, "no progress");
}

FilterJob prepared(const FilterCommandLine& line)
{
    FilterJob job = line.job;
    IniDocument document = IniDocument::load(line.sources);
    for (const std::string& assignment : line.set) document.set(assignment);
    job.sources = readFilterSources(document);
    if (!line.config.empty()) job.configuration = readConfiguration(IniDocument::load(line.config));
    job.version = VDAMF_VERSION;
    std::vector<NamedInput> inputs = {{line.sources, "the list of sources"},
                                      {line.config, "the configuration"}};
    for (const FilterRecording& recording : job.sources.recordings)
    {
        inputs.push_back({recording.rawlog, "an input"});
        inputs.push_back({recording.truth, "an input"});
    }
    std::vector<std::filesystem::path> outputs = {job.filters};
    if (!job.table.empty()) outputs.push_back(job.table);
    checkOutputPaths(outputs, inputs);
    return job;
}

}  // namespace vdamf
