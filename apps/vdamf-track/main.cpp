// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: a rawlog in, its vehicles tracked, an annotated rawlog out.
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "pictures.h"
#include "summary.h"
#include "vdamf/rawlog/track_rawlog.h"

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

struct Cli
{
    std::string config;
    std::string input;
    std::string output;
    std::string tracks;
    std::string nis;
    vdamf::PicturePaths pictures;
    std::string frames;
    std::vector<std::string> set;
    bool overwrite = false;
    bool quiet = false;
    bool printConfig = false;
};

void declare(CLI::App& app, Cli& cli)
{
    app.set_version_flag("--version", std::string("vdamf-track ") + VDAMF_VERSION);
    app.add_option("-c,--config", cli.config, "configuration (ini); default: built-in values");
    app.add_option("-i,--input", cli.input, "rawlog to read");
    app.add_option("-o,--output", cli.output, "annotated rawlog to write");
    app.add_option("--tracks", cli.tracks, "table of all tracks to write (CSV)");
    app.add_option("--nis", cli.nis, "table of each track's consistency (NIS) to write (CSV)");
    app.add_option("--picture", cli.pictures.picture,
                   "bird's-eye picture of the last frame to write (SVG)");
    app.add_option("--report", cli.pictures.report,
                   "page to write that plays the run in a browser (HTML)");
    app.add_option("--scene", cli.pictures.scene,
                   "scene of the run to write, for SceneViewer3D (.3Dscene)");
    app.add_option("--frames", cli.frames, "frames A:B to track, the first one is 0, B excluded");
    app.add_option("--set", cli.set, "section.key=value over the configuration (repeatable)")
        ->allow_extra_args(false);
    app.add_flag("--overwrite", cli.overwrite, "replace existing outputs");
    app.add_flag("-q,--quiet", cli.quiet, "no progress, no summary");
    app.add_flag("--print-config", cli.printConfig,
                 "print the effective configuration as ini and exit");
    app.failure_message(
        [](const CLI::App*, const CLI::Error& error)
        {
            return "vdamf-track: " + std::string(error.what()) +
                   "\nRun with --help for more information.\n";
        });
    app.footer(
        "Example:\n  vdamf-track -i street.rawlog -o street_tracked.rawlog "
        "--tracks tracks.csv --report street.html");
}

// "A:B", either side may be empty. Throws std::invalid_argument.
void parseFrames(const std::string& text, vdamf::TrackRawlogJob& job)
{
    const std::size_t colon = text.find(':');
    const auto number = [&](const std::string& part, std::uint64_t fallback)
    {
        if (part.empty()) return fallback;
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size())
            throw std::invalid_argument("--frames " + text + ": expected A:B, for example 0:100");
        return value;
    };
    if (colon == std::string::npos)
        throw std::invalid_argument("--frames " + text + ": expected A:B, for example 0:100");
    job.firstFrame = number(text.substr(0, colon), 0);
    job.lastFrame = number(text.substr(colon + 1), job.lastFrame);
    if (job.firstFrame >= job.lastFrame)
        throw std::invalid_argument("--frames " + text + ": holds no frame");
}

vdamf::Configuration configurationOf(const Cli& cli)
{
    vdamf::IniDocument document = cli.config.empty()
                                      ? vdamf::IniDocument::parse("", "built-in configuration")
                                      : vdamf::IniDocument::load(cli.config);
    for (const std::string& assignment : cli.set) document.set(assignment);
    return vdamf::readConfiguration(document);
}

std::vector<std::string> outputsOf(const Cli& cli)
{
    std::vector<std::string> all;
    for (const std::string& name : {cli.output, cli.tracks, cli.nis, cli.pictures.picture,
                                    cli.pictures.report, cli.pictures.scene})
        if (!name.empty()) all.push_back(name);
    return all;
}

// What is printed must not stand in the midst of an output.
std::FILE* streamForSummary(const Cli& cli)
{
    for (const std::string& name : outputsOf(cli))
        if (vdamf::isStandardOutput(name)) return stderr;
    return stdout;
}

vdamf::TrackRawlogJob jobOf(const Cli& cli)
{
    if (cli.input.empty()) throw std::invalid_argument("-i is required: the rawlog to read");
    if (outputsOf(cli).empty())
        throw std::invalid_argument(
            "nothing to write: name -o, --tracks, --nis, --picture, --report or --scene");
    for (const std::string& name : outputsOf(cli))
        if (name == "-")
            throw std::invalid_argument(
                "'-' is no file: for the standard output name /dev/stdout (or ./- for a file of "
                "this name)");
    vdamf::TrackRawlogJob job;
    job.input = cli.input;
    if (!cli.output.empty()) job.output = cli.output;
    if (!cli.tracks.empty()) job.tracks = cli.tracks;
    if (!cli.nis.empty()) job.nis = cli.nis;
    for (const std::string& name : {cli.pictures.picture, cli.pictures.report, cli.pictures.scene})
        if (!name.empty()) job.otherOutputs.emplace_back(name);
    job.configurationFile = cli.config;
    if (cli.overwrite) job.existing = vdamf::OutputFile::Existing::Overwrite;
    if (!cli.frames.empty()) parseFrames(cli.frames, job);
    job.version = VDAMF_VERSION;
    checkPaths(job);
    return job;
}

void showProgress(double share, std::uint64_t frames)
{
    constexpr int kWidth = 40;
    const int filled = static_cast<int>(share * kWidth);
    std::fprintf(stderr, "\r[%.*s%*s] %3.0f %%  %llu frames", filled,
                 "########################################", kWidth - filled, "", 100.0 * share,
                 static_cast<unsigned long long>(frames));
}

// A full disk or a closed pipe shows itself at the latest here.
void checkPrinted(std::FILE* stream)
{
    errno = 0;
    if (std::fflush(stream) == 0 && std::ferror(stream) == 0) return;
    throw std::runtime_error("cannot write to the standard output: " +
                             std::system_category().message(errno != 0 ? errno : EIO));
}

int exitCodeOf(const Cli& cli, const vdamf::TrackRawlogSummary& summary)
{
    const auto frames = static_cast<unsigned long long>(summary.frames);
    if (summary.interrupted)
    {
        const bool kept = !cli.output.empty() && summary.frames > 0;
        std::fprintf(stderr, "interrupted: %llu frames done%s\n", frames,
                     kept ? (" are in " + vdamf::partialPathOf(cli.output).string()).c_str() : "");
        return kFailed;
    }
    if (!summary.readError.empty())
    {
        std::fprintf(stderr, "%s; the %llu frames before are done\n", summary.readError.c_str(),
                     frames);
        return kFailed;
    }
    if (summary.read.truncated)
    {
        std::fprintf(stderr, "%s: truncated: %s; the %llu frames before are done\n",
                     cli.input.c_str(), summary.read.truncation.c_str(), frames);
        return kFailed;
    }
    return kDone;
}

// Without restarting what they interrupt: a run must not wait for ever for a pipe that stays
// silent.
void catchSignals()
{
    struct sigaction action = {};
    action.sa_handler = onSignal;
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

int run(const Cli& cli, const vdamf::TrackRawlogJob& job)
{
    catchSignals();
    const bool progress = !cli.quiet && isatty(STDERR_FILENO) != 0;
    std::uint64_t frames = 0;
    vdamf::Pictures pictures(cli.pictures, job);
    const auto listener =
        [&](const vdamf::LadarFrame& frame, const vdamf::FrameResult& result, double share)
    {
        pictures.add(frame, result);
        ++frames;
        if (progress) showProgress(share, frames);
    };
    const vdamf::TrackRawlogSummary summary = vdamf::trackRawlog(job, interrupted, listener);
    if (progress) std::fprintf(stderr, "\n");
    if (!summary.interrupted) pictures.commit(job, summary);
    vdamf::warn(summary, cli.input);
    if (!cli.quiet)
    {
        vdamf::printSummary(streamForSummary(cli), summary);
        checkPrinted(streamForSummary(cli));
    }
    return exitCodeOf(cli, summary);
}

int mainOf(int argc, char** argv)
{
    CLI::App app("Tracks vehicles in an MRPT rawlog with LADAR scans and INS poses.");
    Cli cli;
    declare(app, cli);
    vdamf::TrackRawlogJob job;
    try
    {
        app.parse(argc, argv);
        const vdamf::Configuration configuration = configurationOf(cli);
        if (!cli.printConfig) job = jobOf(cli);
        job.configuration = configuration;
    }
    catch (const CLI::ParseError& error)
    {
        return app.exit(error) == 0 ? kDone : kBadUse;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "vdamf-track: %s\n", error.what());
        return kBadUse;
    }
    if (!cli.printConfig) return run(cli, job);
    using vdamf::OutputFile;
    OutputFile printed("/dev/stdout", OutputFile::Existing::Refuse, OutputFile::Unfinished::Keep);
    printed.write(toIni(job.configuration));
    printed.commit();
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
        std::fprintf(stderr, "vdamf-track: %s\n", error.what());
        return kFailed;
    }
}
