// SPDX-License-Identifier: BSD-3-Clause
// vdamf-train: learns from recordings with truth.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "classifier.h"
#include "filter_command.h"
#include "pictures.h"
#include "vdamf/files/output_file.h"

namespace
{
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadUse = 2;

std::atomic<bool> interrupted{false};

void onSignal(int)
{
    interrupted = true;
}

struct CommandLine
{
    std::filesystem::path recordings;
    std::filesystem::path config;
    std::vector<std::string> set;
    vdamf::ClassifierJob job;
    vdamf::FilterCommandLine filter;
    bool isFilter = false;
};

void declareClassifier(CLI::App& app, CommandLine& line)
{
    vdamf::TrainingOptions& training = line.job.training;
    app.add_option("recordings", line.recordings,
                   "what to train and test on (ini, a section [recording NAME] each)")
        ->required();
    app.add_option("-o,--output", line.job.model, "model to write")->required();
    app.add_option("--plots", line.job.plots, "folder for pictures (SVG)");
    app.add_option("--held-out", line.job.heldOut,
                   "table of the held-out frames with their probabilities to write (CSV)");
    app.add_option("--leave-out", line.job.leaveOut,
                   "recording or scene: told is also how a model trained without it does there "
                   "(repeatable)")
        ->allow_extra_args(false);
    app.add_option("-c,--config", line.config, "configuration of the tracker (ini)");
    app.add_option("--set", line.set, "section.key=value over the recordings (repeatable)")
        ->allow_extra_args(false);
    app.add_option("--folds", training.folds, "of the cross-validation")
        ->check(CLI::Range(2, 50))
        ->capture_default_str();
    app.add_option("--seed", training.seed, "of the split into folds")->capture_default_str();
    app.add_option("--cost", training.costs,
                   "costs of errors (C) to try; the best by cross-validation is taken")
        ->check(CLI::Range(1e-6, 1e6))
        ->expected(1, 100)
        ->capture_default_str();
    app.add_option("--frames-per-track", training.framesPerTrack,
                   "most frames of a track that are trained on")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    app.add_flag("--overwrite", line.job.overwrite, "replace existing outputs");
    app.add_flag("-q,--quiet", line.job.quiet, "no progress");
}

void declare(CLI::App& app, CommandLine& line)
{
    app.set_version_flag("--version", std::string("vdamf-train ") + VDAMF_VERSION);
    app.require_subcommand(1);
    app.failure_message(
        [](const CLI::App*, const CLI::Error& error)
        {
            return "vdamf-train: " + std::string(error.what()) +
                   "\nRun with --help for more information.\n";
        });
    declareClassifier(*app.add_subcommand("classifier", "trains the vehicle discriminator"), line);
    CLI::App* filter = app.add_subcommand("filter", "learns filters from labelled clusters");
    vdamf::declareFilter(*filter, line.filter);
    filter->callback([&line] { line.isFilter = true; });
    app.footer("Example:\n  vdamf-train classifier recordings.ini -o vehicle.txt --plots plots");
}

void prepare(CommandLine& line)
{
    if (line.isFilter)
    {
        line.filter.job = vdamf::prepared(line.filter);
        return;
    }
    vdamf::IniDocument document = vdamf::IniDocument::load(line.recordings);
    for (const std::string& assignment : line.set) document.set(assignment);
    line.job.recordings = vdamf::readRecordings(document);
    if (!line.config.empty())
        line.job.configuration = vdamf::readConfiguration(vdamf::IniDocument::load(line.config));
    vdamf::checkLeaveOut(line.job);
    line.job.version = VDAMF_VERSION;
    std::vector<vdamf::NamedInput> inputs = {{line.recordings, "the list of recordings"},
                                             {line.config, "the configuration"}};
    for (const vdamf::Recording& recording : line.job.recordings)
    {
        inputs.push_back({recording.rawlog, "an input"});
        inputs.push_back({recording.truth, "an input"});
    }
    std::vector<std::filesystem::path> outputs = {line.job.model};
    if (!line.job.heldOut.empty()) outputs.push_back(line.job.heldOut);
    if (!line.job.plots.empty())
        for (const std::string& name : vdamf::classifierPictureNames())
            outputs.push_back(line.job.plots / (name + ".svg"));
    vdamf::checkOutputPaths(outputs, inputs);
}

int mainOf(int argc, char** argv)
{
    CLI::App app("Learns from recordings with truth.");
    CommandLine line;
    declare(app, line);
    try
    {
        app.parse(argc, argv);
        prepare(line);
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? kDone : kBadUse;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-train: %s\n", error.what());
        return kBadUse;
    }
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    if (line.isFilter)
        vdamf::trainFilter(line.filter.job, interrupted);
    else
        vdamf::trainClassifier(line.job, interrupted);
    return kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    try
    {
        return mainOf(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-train: %s\n", error.what());
        return kFailed;
    }
}
