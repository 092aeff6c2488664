// SPDX-License-Identifier: BSD-3-Clause
// vdamf-sweep: many recordings with many settings.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "folder_lock.h"
#include "outputs.h"
#include "own_folder.h"
#include "program.h"
#include "progress.h"
#include "vdamf/experiments/digest.h"
#include "vdamf/experiments/metric_names.h"
#include "vdamf/experiments/setting_configuration.h"
#include "vdamf/experiments/sweep.h"
#include "vdamf/files/folder.h"
#include "worker.h"

namespace
{
namespace fs = std::filesystem;

struct CommandLine
{
    fs::path config;
    fs::path folder;
    fs::path task;
    std::string engine = "local";
    unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
    bool resume = true;
    bool dryRun = false;
    bool quiet = false;
    bool printMetrics = false;
};

void declare(CLI::App& app, CommandLine& line)
{
    app.add_option("-c,--config", line.config, "what to sweep (ini)");
    app.add_option("-o,--output", line.folder,
                   "folder of the sweep; default: results/<name of the ini file>");
    app.add_option("--engine", line.engine, "what carries out the runs")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    app.add_option("-j,--jobs", line.jobs, "local: runs at a time")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    app.add_flag("--resume,!--no-resume", line.resume,
                 "skip the runs that are done (default), or do them again");
    app.add_flag("--dry-run", line.dryRun, "check everything, print the plan and exit");
    app.add_flag("--print-metrics", line.printMetrics, "print the names of all metrics and exit");
    app.add_flag("-q,--quiet", line.quiet, "no progress, no summary");
    app.add_option("--task", line.task)->group("");  // what its own workers are called with
}

fs::path ownProgram()
{
    return fs::read_symlink("/proc/self/exe");
}

vdamf::Engine engineOf(const CommandLine& line, const vdamf::PreparedSweep& sweep,
                       const vdamf::SweepProgress& progress)
{
    const vdamf::WorkerCommand worker = {ownProgram().string(), "--task"};
    if (line.engine == "slurm")
        return vdamf::slurmEngine(worker, sweep.file.slurm, line.folder / "slurm",
                                  [&progress](const std::string& text) { progress.tell(text); });
    return vdamf::localEngine(worker, line.jobs);
}

vdamf::SweepProgress::Style styleOf(const CommandLine& line)
{
    using Style = vdamf::SweepProgress::Style;
    if (line.quiet) return Style::Quiet;
    return vdamf::isTerminal() ? Style::Bar : Style::Lines;
}

int dryRun(const CommandLine& line, const vdamf::PreparedSweep& sweep,
           const vdamf::SweepProgram& program)
{
    std::printf("recordings\n");
    for (const vdamf::SweepRecording& recording : sweep.recordings)
        std::printf("  %s  (%s, truth %s)\n", recording.name.c_str(), recording.rawlog.c_str(),
                    recording.truth.c_str());
    std::printf("settings\n");
    if (sweep.file.sweep.plan == vdamf::PlanKind::Optimise)
        std::printf("  %d at most, chosen on the way\n", sweep.file.sweep.count);
    for (std::size_t s = 0; s < sweep.settings.size(); ++s)
        std::printf("  %zu  %s\n", s + 1, inWords(sweep.file, sweep.settings[s]).c_str());
    std::size_t done = 0;
    for (const vdamf::PlannedRun& run : plannedRuns(sweep, sweep.settings, 0, program, line.folder))
        done += run.isDone ? 1 : 0;
    std::printf("%zu runs, %zu of them done, in %s\n", sweep.runs, done, line.folder.c_str());
    return vdamf::kDone;
}

int interruptedExit(const vdamf::SweepProgress& progress, const fs::path& folder)
{
    progress.end();
    std::fprintf(stderr,
                 "interrupted: the runs that are done stay in %s; the same command goes on\n",
                 folder.c_str());
    return vdamf::kFailed;
}

int sweepAll(const CommandLine& line, const vdamf::PreparedSweep& sweep,
             const vdamf::SweepProgram& program)
{
    const std::atomic<bool>& interrupted = vdamf::catchSignals();
    vdamf::makeFolder(line.folder);
    const vdamf::FolderLock lock(line.folder);
    vdamf::claimFolder(line.folder);
    if (!line.resume) vdamf::forgetRuns(line.folder);
    vdamf::writeSweepCopy(sweep, line.folder);
    vdamf::SweepProgress progress(sweep, styleOf(line));
    vdamf::SweepListener listener;
    listener.planned = [&](const auto& runs) { progress.planned(runs); };
    listener.finished = [&](const auto& one, const std::string& failure)
    { progress.finished(one, failure); };
    listener.impossible = [&](const std::string& why)
    { progress.tell(why + "; it counts as worse than the worst"); };
    const vdamf::SweepResults results = vdamf::runSweep(
        sweep, program, line.folder, engineOf(line, sweep, progress), interrupted, listener);
    if (interrupted) return interruptedExit(progress, line.folder);
    progress.end();
    vdamf::writeOutputs(sweep, results, line.folder);
    if (!line.quiet) vdamf::printOutcome(sweep, results, progress.skipped(), line.folder);
    if (progress.failures() == 0) return vdamf::kDone;
    std::fprintf(stderr, "%zu runs failed; their logs are in %s\n", progress.failures(),
                 (line.folder / "tasks").c_str());
    return vdamf::kFailed;
}

std::optional<vdamf::PreparedSweep> prepared(CommandLine& line)
{
    if (!line.task.empty() || line.printMetrics) return {};
    if (line.config.empty()) throw std::invalid_argument("-c is required: what to sweep");
    if (line.folder.empty()) line.folder = fs::path("results") / line.config.stem();
    vdamf::PreparedSweep sweep = vdamf::prepareSweep(line.config);
    vdamf::checkOutputs(sweep, line.folder);
    vdamf::checkFolder(line.folder);
    vdamf::checkRemoved(line.folder, !line.resume, vdamf::inputsOf(sweep));
    return sweep;
}

int printMetrics()
{
    for (const std::string& name : vdamf::metricNames()) std::printf("%s\n", name.c_str());
    return vdamf::kDone;
}

int run(const CommandLine& line, const std::optional<vdamf::PreparedSweep>& sweep)
{
    if (!line.task.empty()) return vdamf::work(line.task);
    if (line.printMetrics) return printMetrics();
    const vdamf::SweepProgram program{VDAMF_VERSION, vdamf::digestOfFile(ownProgram())};
    return line.dryRun ? dryRun(line, *sweep, program) : sweepAll(line, *sweep, program);
}
}  // namespace

int main(int argc, char** argv)
{
    CommandLine line;
    std::optional<vdamf::PreparedSweep> sweep;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-sweep", "Runs the tracker on many recordings with many settings and compares them.",
         "Example:\n  vdamf-sweep -c datasets/sweeps/street.ini -o results/street_sweep",
         [&](CLI::App& app) { declare(app, line); }, [&] { sweep = prepared(line); },
         [&] { return run(line, sweep); }});
}
