// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: a rawlog in, its vehicles tracked, an annotated rawlog out.
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "pictures.h"
#include "program.h"
#include "summary.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace
{
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

// Where a run that ends early has left the frames done: "a.partial and b.partial"; empty: nowhere.
// What is no file, as a pipe, has been read by others.
std::string keptIn(const std::vector<std::string>& outputs, std::uint64_t frames)
{
    std::string all;
    for (const std::string& output : outputs)
    {
        if (output.empty() || frames == 0) continue;
        const std::filesystem::path partial = vdamf::partialPathOf(output);
        if (partial != output && std::filesystem::exists(partial))
            all += (all.empty() ? "" : " and ") + partial.string();
    }
    return all;
}

int exitCodeOf(const Cli& cli, const vdamf::TrackRawlogSummary& summary)
{
    const auto frames = static_cast<unsigned long long>(summary.frames);
    if (summary.interrupted)
    {
        const std::string kept = keptIn({cli.output, cli.tracks, cli.nis}, summary.frames);
        std::fprintf(stderr, "interrupted: %llu frames done%s%s\n", frames,
                     kept.empty() ? "" : " are in ", kept.c_str());
        return vdamf::kFailed;
    }
    if (!summary.readError.empty())
    {
        std::fprintf(stderr, "%s; the %llu frames before are done\n", summary.readError.c_str(),
                     frames);
        return vdamf::kFailed;
    }
    if (summary.read.truncated)
    {
        std::fprintf(stderr, "%s: truncated: %s; the %llu frames before are done\n",
                     cli.input.c_str(), summary.read.truncation.c_str(), frames);
        return vdamf::kFailed;
    }
    return vdamf::kDone;
}

int track(const Cli& cli, const vdamf::TrackRawlogJob& job)
{
    const std::atomic<bool>& interrupted = vdamf::catchSignals();
    const bool progress = !cli.quiet && vdamf::isTerminal();
    std::uint64_t frames = 0;
    vdamf::Pictures pictures(cli.pictures, job);
    const auto listener =
        [&](const vdamf::LadarFrame& frame, const vdamf::FrameResult& result, double share)
    {
        pictures.add(frame, result);
        ++frames;
        if (progress) showProgress(share, frames);
    };
    std::uint64_t read = 0;  // in a first reading
    const auto firstReading = [&](double share)
    {
        ++read;
        if (progress) showProgress(share, read);
    };
    vdamf::TrackRawlogSummary summary;
    try
    {
        summary = vdamf::trackRawlog(job, interrupted, listener, firstReading);
    }
    catch (const std::exception& error)
    {
        const std::string kept = keptIn({cli.output, cli.tracks}, frames);
        if (kept.empty()) throw;
        throw std::runtime_error(vdamf::reasonOf(error) + ("; of the " + std::to_string(frames)) +
                                 " frames done, those written before are in " + kept);
    }
    if (progress) std::fprintf(stderr, "\n");
    if (!summary.interrupted) pictures.commit(job, summary);
    vdamf::warn(summary, cli.input);
    if (!cli.quiet)
    {
        vdamf::printSummary(streamForSummary(cli), summary);
        vdamf::checkPrinted(streamForSummary(cli));
    }
    return exitCodeOf(cli, summary);
}

vdamf::TrackRawlogJob prepared(const Cli& cli)
{
    const vdamf::Configuration configuration = vdamf::loadConfiguration(cli.config, cli.set);
    vdamf::TrackRawlogJob job;
    if (!cli.printConfig) job = jobOf(cli);
    job.configuration = configuration;
    if (!cli.printConfig) checkPaths(job);
    return job;
}

int run(const Cli& cli, const vdamf::TrackRawlogJob& job)
{
    if (!cli.printConfig) return track(cli, job);
    using vdamf::OutputFile;
    OutputFile printed("/dev/stdout", OutputFile::Existing::Refuse, OutputFile::Unfinished::Keep);
    printed.write(toIni(job.configuration));
    printed.commit();
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    Cli cli;
    vdamf::TrackRawlogJob job;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-track", "Tracks vehicles in an MRPT rawlog with LADAR scans and INS poses.",
         "Example:\n  vdamf-track -i street.rawlog -o street_tracked.rawlog "
         "--tracks tracks.csv --report street.html",
         [&](CLI::App& app) { declare(app, cli); }, [&] { job = prepared(cli); },
         [&] { return run(cli, job); }});
}
