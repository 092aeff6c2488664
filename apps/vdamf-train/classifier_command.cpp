// SPDX-License-Identifier: BSD-3-Clause
#include "classifier_command.h"

#include "program.h"

namespace vdamf
{
void declareClassifier(CLI::App& command, ClassifierCommandLine& line)
{
    TrainingOptions& training = line.job.training;
    declareInputs(command, line.inputs, "recordings",
                  "what to train and test on (ini, a section [recording NAME] each)");
    command.add_option("-o,--output", line.job.model, "model to write")->required();
    command.add_option("--plots", line.job.plots, "folder for pictures (SVG)");
    command.add_option("--held-out", line.job.heldOut,
                       "table of the held-out frames with their probabilities to write (CSV)");
    command
        .add_option("--leave-out", line.job.leaveOut,
                    "recording or scene: told is also how a model trained without it does there "
                    "(repeatable)")
        ->allow_extra_args(false);
    command.add_option("--folds", training.folds, "of the cross-validation")
        ->check(CLI::Range(2, 50))
        ->capture_default_str();
    command.add_option("--seed", training.seed, "of the split into folds")
        ->check(CLI::Range(0, 2147483647))
        ->capture_default_str();
    command
        .add_option("--cost", training.costs,
                    "costs of errors (C) to try; the best by cross-validation is taken")
        ->check(within(1e-6, 1e6))
        ->expected(1, 100)
        ->capture_default_str();
    command
        .add_option("--frames-per-track", training.framesPerTrack,
                    "most frames of a track that are trained on")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command
        .add_option("--vehicle-share", training.vehicleShare,
                    "share of vehicles in the frames of all objects where the model will be used "
                    "(default: that of the recordings)")
        ->check(within(0.001, 0.999));
    command.add_option("--threads", training.threads, "folds that are trained at a time")
        ->check(CLI::Range(1, 64))
        ->capture_default_str();
    command.add_flag("--overwrite", line.job.overwrite, "replace existing outputs");
    command.add_flag("-q,--quiet", line.job.quiet, "no progress");
}

ClassifierJob prepared(const ClassifierCommandLine& line)
{
    ClassifierJob job = line.job;
    job.recordings = readRecordings(readList(line.inputs));
    job.configuration = loadConfiguration(line.inputs.config);
    checkLeaveOut(job);
    job.version = VDAMF_VERSION;
    checkOutputPaths(outputsOf(job), namedInputs(line.inputs, job.configuration, job.recordings));
    return job;
}

}  // namespace vdamf
