// SPDX-License-Identifier: BSD-3-Clause
#include "filter_command.h"

namespace vdamf
{
void declareFilter(CLI::App& command, FilterCommandLine& line)
{
    FilterTrainingOptions& training = line.job.training;
    declareInputs(command, line.inputs, "sources",
                  "what to train and test on (ini, sections [recording NAME], [simulated NAME])");
    command.add_option("-o,--output", line.job.filters, "filters to write")->required();
    command.add_option("--held-out", line.job.table, "table of held-out errors to write (CSV)");
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
        ->check(CLI::IsMember({0}) | CLI::Range(2, 50))
        ->capture_default_str();
    command.add_option("--seed", training.seed, "of the split into folds")
        ->check(CLI::Range(0, 2147483647))
        ->capture_default_str();
    command.add_flag("--overwrite", line.job.overwrite, "replace existing outputs");
    command.add_flag("-q,--quiet", line.job.quiet, "no progress");
}

FilterJob prepared(const FilterCommandLine& line)
{
    FilterJob job = line.job;
    job.sources = readFilterSources(readList(line.inputs));
    job.configuration = loadConfiguration(line.inputs.config);
    job.version = VDAMF_VERSION;
    checkOutputPaths(outputsOf(job),
                     namedInputs(line.inputs, job.configuration, job.sources.recordings));
    return job;
}

}  // namespace vdamf
