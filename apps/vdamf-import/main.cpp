// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import: recordings of other formats to rawlogs.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "vdamf/rawlog/kitti_import.h"

namespace
{
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadUse = 2;

struct CommandLine
{
    std::filesystem::path input;
    std::filesystem::path rawlog;
    std::filesystem::path truth;
    bool overwrite = false;
    int gzLevel = 1;
};

volatile std::sig_atomic_t stopRequested = 0;

void requestStop(int /*signal*/)
{
    stopRequested = 1;
}

bool showProgress(std::size_t done, std::size_t all)
{
    const bool stops = stopRequested != 0;
    if (isatty(STDERR_FILENO) != 0)
    {
        std::fprintf(stderr, "\rscan %zu of %zu%s", done, all, done == all || stops ? "\n" : "");
    }
    return !stops;
}

void summarise(std::FILE* to, const CommandLine& line, const vdamf::KittiImportSummary& summary,
               double seconds)
{
    const auto scans = static_cast<double>(summary.scans);
    std::fprintf(to, "%s\n", line.rawlog.string().c_str());
    std::fprintf(to, "  frames      %zu (%.1f s)\n", summary.scans, summary.seconds);
    std::fprintf(to, "  points      %zu (%.0f a frame)\n", summary.points,
                 static_cast<double>(summary.points) / scans);
    std::fprintf(to, "  poses       %zu\n", summary.poses);
    if (!line.truth.empty())
    {
        std::fprintf(to, "  labels      %zu of %zu objects in %s\n", summary.labels,
                     summary.objects, line.truth.string().c_str());
    }
    if (summary.labelsWithoutPose > 0)
    {
        std::fprintf(to, "  left out    %zu labels: no INS pose at the time of their scan\n",
                     summary.labelsWithoutPose);
    }
    std::error_code ignored;
    const std::uintmax_t bytes = std::filesystem::file_size(line.rawlog, ignored);
    if (!ignored) std::fprintf(to, "  size        %.1f MB\n", static_cast<double>(bytes) / 1e6);
    std::fprintf(to, "  time taken  %.1f s (%.1f frames/s)\n", seconds, scans / seconds);
}

vdamf::KittiImport jobOf(const CommandLine& line)
{
    using Existing = vdamf::OutputFile::Existing;
    for (const std::filesystem::path& output : {line.rawlog, line.truth})
        if (output == "-")
            throw std::invalid_argument(
                "'-' is no file: for the standard output name /dev/stdout (or ./- for a file of "
                "this name)");
    vdamf::KittiImport job;
    job.drive = line.input;
    job.rawlog = line.rawlog;
    if (!line.truth.empty()) job.truth = line.truth;
    job.existing = line.overwrite ? Existing::Overwrite : Existing::Refuse;
    job.gzLevel = line.gzLevel;
    job.progress = showProgress;
    checkPaths(job);
    return job;
}

// What is printed must not stand in the midst of an output.
std::FILE* streamForSummary(const CommandLine& line)
{
    const bool taken = vdamf::isStandardOutput(line.rawlog) || vdamf::isStandardOutput(line.truth);
    return taken ? stderr : stdout;
}

// A full disk or a closed pipe shows itself at the latest here.
void checkPrinted(std::FILE* stream)
{
    errno = 0;
    if (std::fflush(stream) == 0 && std::ferror(stream) == 0) return;
    throw std::runtime_error("cannot write to the standard output: " +
                             std::system_category().message(errno != 0 ? errno : EIO));
}

int importKitti(const CommandLine& line, const vdamf::KittiImport& job)
{
    const auto begin = std::chrono::steady_clock::now();
    const vdamf::KittiImportSummary summary = vdamf::importKittiDrive(job);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    if (summary.stopped)
    {
        std::fprintf(stderr, "vdamf-import: interrupted; no output was kept\n");
        return kFailed;
    }
    summarise(streamForSummary(line), line, summary, taken.count());
    checkPrinted(streamForSummary(line));
    return kDone;
}

void addKittiRaw(CLI::App& app, CommandLine& line)
{
    CLI::App* kitti = app.add_subcommand("kitti-raw", "A synchronised drive of KITTI's raw data");
    kitti->footer(
        "Example:\n  vdamf-import kitti-raw 2011_09_26/2011_09_26_drive_0001_sync "
        "-o drive_0001.rawlog --truth truth.csv");
    kitti->add_option("drive", line.input, "Folder like 2011_09_26_drive_0001_sync")->required();
    kitti->add_option("-o,--output", line.rawlog, "Rawlog to write")->required();
    kitti->add_option("--truth", line.truth, "Truth table to write (csv), from the tracklets");
    kitti->add_flag("--overwrite", line.overwrite, "Replace existing outputs");
    kitti->add_option("--gz-level", line.gzLevel, "Compression, 0 (none) to 9")
        ->check(CLI::Range(0, 9))
        ->capture_default_str();
}

int run(int argc, char** argv)
{
    CommandLine line;
    CLI::App app("Converts recordings of other formats to MRPT rawlogs.");
    app.footer(
        "Examples:\n"
        "  a drive of KITTI's raw data with its labels:\n"
        "    vdamf-import kitti-raw 2011_09_26/2011_09_26_drive_0001_sync -o drive_0001.rawlog "
        "--truth truth.csv\n"
        "  tracked:\n"
        "    vdamf-track -i drive_0001.rawlog -o tracked.rawlog --tracks tracks.csv\n"
        "'vdamf-import kitti-raw --help' lists its options.");
    app.failure_message(
        [](const CLI::App*, const CLI::Error& error)
        {
            return "vdamf-import: " + std::string(error.what()) +
                   "\nRun with --help for more information.\n";
        });
    app.set_version_flag("--version", "vdamf-import " VDAMF_VERSION);
    app.require_subcommand(1);
    addKittiRaw(app, line);
    vdamf::KittiImport job;
    try
    {
        app.parse(argc, argv);
        job = jobOf(line);
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? kDone : kBadUse;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-import: %s\n", error.what());
        return kBadUse;
    }
    std::signal(SIGINT, requestStop);
    std::signal(SIGTERM, requestStop);
    return importKitti(line, job);
}
}  // namespace

int main(int argc, char** argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-import: %s\n", error.what());
        return kFailed;
    }
}
