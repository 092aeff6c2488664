// SPDX-License-Identifier: BSD-3-Clause
// vdamf-simulate: a rawlog with exact truth from a scenario file.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "observations.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/simulation/scenario.h"

namespace
{
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadUse = 2;

struct CommandLine
{
    std::filesystem::path scenario;
    std::filesystem::path rawlog;
    std::filesystem::path truth;
    bool overwrite = false;
    int gzLevel = 1;
    std::optional<int> seed;
};

struct Totals
{
    std::size_t poses = 0;
    std::size_t returns = 0;
};

volatile std::sig_atomic_t stopRequested = 0;

void requestStop(int /*signal*/)
{
    stopRequested = 1;
}

void showProgress(int done, int all)
{
    if (isatty(STDERR_FILENO) == 0) return;
    std::fprintf(stderr, "\rframe %d of %d%s", done, all, done == all ? "\n" : "");
}

/// Writes poses up to a scene time, in their order with the scans.
class PoseWriter
{
public:
    PoseWriter(const vdamf::Scenario& scenario, vdamf::RawlogWriter& rawlog)
        : scenario_(scenario), rawlog_(rawlog)
    {
    }

    void writeUntil(double sceneTime)
    {
        constexpr double kRounding = 1e-9;
        while (static_cast<double>(written_) / scenario_.run.insRate <= sceneTime + kRounding)
        {
            const double time = static_cast<double>(written_) / scenario_.run.insRate;
            rawlog_.write(vdamf::poseObservation(scenario_, time));
            ++written_;
        }
    }

    std::size_t written() const { return written_; }

private:
    const vdamf::Scenario& scenario_;
    vdamf::RawlogWriter& rawlog_;
    std::size_t written_ = 0;
};

std::size_t countReturns(const vdamf::SimulatedFrame& frame)
{
    std::size_t count = 0;
    for (const vdamf::LadarFiring& firing : frame.firings)
    {
        for (const vdamf::LadarReturn& one : firing.returns) count += one.range > 0.0 ? 1 : 0;
    }
    return count;
}

Totals simulate(const vdamf::Scenario& scenario, const CommandLine& line)
{
    using vdamf::OutputFile;
    vdamf::RawlogWriter::Options options;
    options.gzLevel = line.gzLevel;
    options.existing =
        line.overwrite ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse;
    vdamf::RawlogWriter rawlog(line.rawlog, options);
    std::unique_ptr<OutputFile> truth;
    if (!line.truth.empty())
    {
        truth = std::make_unique<OutputFile>(line.truth, options.existing,
                                             OutputFile::Unfinished::Discard);
        truth->write(vdamf::truthHeader());
    }

    PoseWriter poses(scenario, rawlog);
    Totals totals;
    for (int i = 0; i < scenario.frames(); ++i)
    {
        if (stopRequested != 0) throw std::runtime_error("interrupted; no output was kept");
        const vdamf::SimulatedFrame frame = vdamf::simulateFrame(scenario, i);
        poses.writeUntil(scenario.frameTime(i));
        rawlog.write(vdamf::scanObservation(scenario, frame));
        for (const vdamf::TruthRow& row : frame.truth)
        {
            if (truth) truth->write(vdamf::toCsv(row));
        }
        totals.returns += countReturns(frame);
        showProgress(i + 1, scenario.frames());
    }
    // One pose at or behind the end, so that the last scan is between two poses.
    poses.writeUntil(scenario.run.duration + 1.0 / scenario.run.insRate);
    totals.poses = poses.written();
    rawlog.commit();
    if (truth) truth->commit();
    return totals;
}

void summarise(const vdamf::Scenario& scenario, const CommandLine& line, const Totals& totals,
               double seconds)
{
    std::size_t vehicles = 0;
    for (const auto& object : scenario.scene.objects)
    {
        vehicles += vdamf::isVehicle(object.objectClass) ? 1 : 0;
    }
    const int frames = scenario.frames();
    std::printf("%s\n", line.rawlog.string().c_str());
    std::printf("  frames      %d (%g s at %g Hz)\n", frames, scenario.run.duration,
                scenario.run.rate);
    std::printf("  returns     %zu a frame\n", totals.returns / static_cast<std::size_t>(frames));
    std::printf("  poses       %zu\n", totals.poses);
    std::printf("  objects     %zu, of which %zu vehicles\n", scenario.scene.objects.size(),
                vehicles);
    if (std::filesystem::is_regular_file(line.rawlog))  // it may be a device
    {
        std::printf("  size        %.1f MB\n",
                    static_cast<double>(std::filesystem::file_size(line.rawlog)) / 1e6);
    }
    std::printf("  time taken  %.1f s (%.1f frames/s)\n", seconds, frames / seconds);
}

int run(const CommandLine& line)
{
    vdamf::Scenario scenario;
    try
    {
        scenario = vdamf::readScenario(vdamf::IniDocument::load(line.scenario));
    }
    catch (const std::runtime_error& error)
    {
        std::cerr << error.what() << '\n';
        return kBadUse;
    }
    if (line.seed) scenario.run.seed = *line.seed;
    const auto begin = std::chrono::steady_clock::now();
    const Totals totals = simulate(scenario, line);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    summarise(scenario, line, totals, taken.count());
    return kDone;
}

int parseAndRun(int argc, char** argv)
{
    CommandLine line;
    CLI::App app(
        "Simulates a LADAR on a driving platform: a rawlog with scans and poses, and the "
        "truth of all vehicles.");
    app.footer(
        "Example:\n  vdamf-simulate datasets/street/scenario.ini -o street.rawlog "
        "--truth truth.csv");
    app.set_version_flag("--version", VDAMF_VERSION);
    app.add_option("scenario", line.scenario, "Scenario file (ini)")->required();
    app.add_option("-o,--output", line.rawlog, "Rawlog to write")->required();
    app.add_option("--truth", line.truth, "Truth table to write (csv)");
    app.add_flag("--overwrite", line.overwrite, "Replace existing outputs");
    app.add_option("--gz-level", line.gzLevel, "Compression, 0 (none) to 9")
        ->check(CLI::Range(0, 9));
    app.add_option("--seed", line.seed, "Instead of the scenario's seed")
        ->check(CLI::Range(0, 2147483647));
    try
    {
        app.parse(argc, argv);
        if (line.truth == line.rawlog)
        {
            throw CLI::ValidationError("--truth", "must be another file than --output");
        }
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? kDone : kBadUse;
    }
    std::signal(SIGINT, requestStop);
    std::signal(SIGTERM, requestStop);
    return run(line);
}
}  // namespace

int main(int argc, char** argv)
{
    try
    {
        return parseAndRun(argc, argv);
    }
    catch (const std::exception& error)
    {
        const char* const wipeProgress = isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
        std::fprintf(stderr, "%svdamf-simulate: %s\n", wipeProgress, error.what());
        return kFailed;
    }
}
