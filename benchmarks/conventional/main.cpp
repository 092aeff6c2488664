// SPDX-License-Identifier: BSD-3-Clause
// The conventional tracker on a rawlog, called as vdamf-track is: for `vdamf_regression --tracker`.
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "conventional/conventional_tracker.h"
#include "program.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace
{
using Clock = std::chrono::steady_clock;

struct Cli
{
    std::string config;
    std::string input;
    std::string tracks;
    std::vector<std::string> set;
    bool overwrite = false;
};

void declare(CLI::App& app, Cli& cli)
{
    app.add_option("-c,--config", cli.config,
                   "configuration of vdamf-track; what counts is [scan], [ins], [ground], "
                   "[clustering] and [lifecycle]");
    app.add_option("-i,--input", cli.input, "rawlog to read")->required();
    app.add_option("--tracks", cli.tracks, "table of all tracks to write (CSV)")->required();
    app.add_option("--set", cli.set, "section.key=value over the configuration (repeatable)")
        ->allow_extra_args(false);
    app.add_flag("--overwrite", cli.overwrite, "replace existing outputs");
}

vdamf::TrackRawlogJob jobOf(const Cli& cli)
{
    vdamf::TrackRawlogJob job;
    job.configuration = vdamf::loadConfiguration(cli.config, cli.set);
    job.input = cli.input;
    job.otherOutputs = {cli.tracks};
    job.configurationFile = cli.config;
    vdamf::checkPaths(job);
    return job;
}

// The frames are those that vdamf-track sees; what that makes of them is passed over.
int track(const Cli& cli, const vdamf::TrackRawlogJob& job)
{
    using vdamf::OutputFile;
    OutputFile table(cli.tracks,
                     cli.overwrite ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse,
                     OutputFile::Unfinished::Discard);
    table.write(vdamf::tracksHeader());
    vdamf::ConventionalTracker tracker(job.configuration.tracker);
    std::chrono::duration<double, std::milli> spent{};
    const auto take =
        [&](const vdamf::LadarFrame& frame, const vdamf::FrameResult& /*ours*/, double /*progress*/)
    {
        const Clock::time_point begin = Clock::now();
        const vdamf::FrameResult result = tracker.process(frame);
        spent += Clock::now() - begin;
        table.write(vdamf::toCsv(result));
    };
    const vdamf::TrackRawlogSummary summary = vdamf::trackRawlog(job, vdamf::catchSignals(), take);
    if (summary.interrupted || !summary.readError.empty())
        throw std::runtime_error(job.input.string() + ": not read to its end");
    table.commit();
    const double frames = std::max<double>(1.0, static_cast<double>(summary.frames));
    std::printf("frames %llu\ntracking, all %.2f ms\n",
                static_cast<unsigned long long>(summary.frames), spent.count() / frames);
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    vdamf::TrackRawlogJob job;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf_conventional_tracker",
         "Tracks by L-shape fitting, nearest neighbours and a bicycle model, to compare with.",
         "Example:\n  vdamf_regression --tracker build/dev/benchmarks/vdamf_conventional_tracker",
         [&](CLI::App& app) { declare(app, cli); }, [&] { job = jobOf(cli); },
         [&] { return track(cli, job); }});
}
