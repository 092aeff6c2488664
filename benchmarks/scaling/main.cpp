// SPDX-License-Identifier: BSD-3-Clause
// Where the tracker's time goes, on recorded drives and on planes full of cars: how it grows with
// the number of targets, and what threads gain.
#include <cstdio>
#include <filesystem>
#include <thread>

#include "program.h"
#include "scaling/recorded_frames.h"
#include "scaling/stress_scene.h"
#include "scaling/tables.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/text_file.h"

namespace
{
namespace fs = std::filesystem;
using namespace vdamf;

struct Cli
{
    std::vector<int> targets{50, 500, 5000, 10000};
    std::vector<int> threads{1, 0};
    int frames = 13;
    std::string data;
    std::string out;
};

void declare(CLI::App& app, Cli& cli)
{
    app.add_option("--targets", cli.targets, "sizes of the made scenes, by commas; 0: none")
        ->delimiter(',')
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    app.add_option("--threads", cli.threads,
                   "numbers of threads, by commas; 0: one for each processor")
        ->delimiter(',')
        ->check(CLI::Range(0, 256))
        ->capture_default_str();
    app.add_option("--frames", cli.frames, "frames of each made scene, of which 4 do not count")
        ->check(CLI::Range(5, 1000))
        ->capture_default_str();
    app.add_option("--data", cli.data, "folder with unpacked KITTI raw drives");
    app.add_option("--out", cli.out, "folder for scaling.csv and scaling.svg");
}

TrackerOptions withThreads(int threads)
{
    TrackerOptions options;
    options.execution.threads = threads;
    return options;
}

TimedRun timedDrive(const fs::path& drive, const std::vector<LadarFrame>& frames, int threads)
{
    constexpr int kWarmUp = 5;
    const auto source = [&](int k) { return frames[static_cast<std::size_t>(k)]; };
    // 2011_09_26_drive_0005_sync -> drive_0005
    std::string name = drive.filename().string();
    if (name.rfind("2011_09_26_", 0) == 0) name = name.substr(11, 10);
    return {name, 0, threads,
            timedSequence(source, static_cast<int>(frames.size()), kWarmUp, withThreads(threads))};
}

TimedRun timedScene(int targets, int frames, int threads)
{
    constexpr int kWarmUp = 4;
    const StressScene scene{targets};
    TrackerOptions options = withThreads(threads);
    options.ground.maxRange = 300.0;
    return {std::to_string(targets) + " targets", targets, threads,
            timedSequence([&](int k) { return scene.frame(k); }, frames, kWarmUp, options)};
}

int run(const Cli& cli)
{
    std::vector<int> threads;
    for (const int n : cli.threads)
        threads.push_back(n > 0 ? n : static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<TimedRun> runs;
    if (!cli.data.empty())
        for (const fs::path& drive : recordedDrives(cli.data))
        {
            const std::vector<LadarFrame> frames = recordedFrames(drive);
            for (const int n : threads) runs.push_back(timedDrive(drive, frames, n));
        }
    for (const int targets : cli.targets)
        for (const int n : threads)
            if (targets > 0) runs.push_back(timedScene(targets, cli.frames, n));
    std::printf("%s", stageTable(runs).c_str());
    if (cli.out.empty()) return kDone;
    vdamf::makeFolder(cli.out);
    writeTextFile(fs::path(cli.out) / "scaling.csv", timesCsv(runs));
    writeTextFile(fs::path(cli.out) / "scaling.svg", scalingSvg(runs));
    return kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    return runProgram(
        argc, argv,
        {"vdamf_benchmark_scaling",
         "Time of the tracker, stage by stage, on recorded drives and on many targets.",
         "Example:\n  vdamf_benchmark_scaling --targets 50,500 --out scaling",
         [&](CLI::App& app) { declare(app, cli); }, nullptr, [&] { return run(cli); }});
}
