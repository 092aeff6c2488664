// SPDX-License-Identifier: BSD-3-Clause
// vdamf-report: an annotated rawlog in, a page for the browser out.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "program.h"
#include "summary.h"
#include "vdamf/evaluation/named_tables.h"
#include "vdamf/evaluation/truth_frames.h"
#include "vdamf/files/output_file.h"
#include "vdamf/rawlog/annotated_rawlog.h"
#include "vdamf/report/run_report.h"

namespace
{
namespace fs = std::filesystem;

struct CommandLine
{
    fs::path input;
    fs::path output;
    fs::path truth;
    std::string title;
    int hitsPerFrame = 14000;
    double regionFovDegrees = 0.0;
    bool overwrite = false;
    bool quiet = false;
    vdamf::EvaluationOptions evaluation;
};

void declare(CLI::App& app, CommandLine& line)
{
    app.add_option("input", line.input, "rawlog that vdamf-track -o wrote")->required();
    app.add_option("-o,--output", line.output, "page to write (HTML)")->required();
    CLI::Option* const truth = app.add_option(
        "--truth", line.truth, "table of labelled objects (csv): shown, and where the tracks err");
    app.add_option("--title", line.title, "of the page; default: the input's name");
    app.add_option("--hits-per-frame", line.hitsPerFrame,
                   "LADAR hits kept of each frame, at most: more detail, larger page")
        ->check(CLI::Range(100, 200000))
        ->capture_default_str();
    vdamf::ScoringOptions& scoring = line.evaluation.scoring;
    app.add_option("--region-fov-deg", line.regionFovDegrees,
                   "labelled sector ahead of the sensor; 0: all around (KITTI: 80)")
        ->check(vdamf::within(0.0, 360.0))
        ->needs(truth)
        ->capture_default_str();
    app.add_option("--max-range-m", scoring.maxRange, "judge up to this range; 0: all")
        ->check(vdamf::within(0.0, 1e4))
        ->needs(truth)
        ->capture_default_str();
    app.add_option("--min-points", scoring.minPoints, "objects with fewer hits do not count")
        ->check(CLI::Range(0, 1000000))
        ->needs(truth)
        ->capture_default_str();
    app.add_flag("--vehicles-only", scoring.onlyVehicles,
                 "judge no tracks that the discriminator takes for clutter")
        ->needs(truth);
    app.add_flag("--overwrite", line.overwrite, "replace an existing page");
    app.add_flag("-q,--quiet", line.quiet, "no progress, no summary");
}

void showProgress(double share, std::size_t frames)
{
    std::fprintf(stderr, "\r%3.0f %%  %zu frames", 100.0 * share, frames);
}

vdamf::RunFacts factsOf(const CommandLine& line, const vdamf::Annotations& annotations,
                        const vdamf::ReplaySummary& summary)
{
    vdamf::RunFacts facts;
    facts.title = line.title.empty() ? line.input.filename().string() : line.title;
    facts.version = annotations.version;
    facts.configuration = toIni(annotations.configuration);
    std::string sensors;
    for (const std::string& label : summary.labels)
        sensors += (sensors.empty() ? "" : ", ") + label;
    facts.rows = {{"Rawlog", line.input.filename().string()},
                  {"LADAR", sensors},
                  {"INS poses", annotations.insSource},
                  {"World origin", annotations.origin}};
    if (!line.truth.empty()) facts.rows.emplace_back("Truth", line.truth.filename().string());
    return facts;
}

// On stderr how much of the truth the page leaves out.
void warnOfTruthLeftOut(const CommandLine& line, const std::vector<vdamf::TruthRow>& truth,
                        const std::vector<double>& times)
{
    const double tolerance = line.evaluation.scoring.timeTolerance;
    const std::size_t all = vdamf::frameTimes(truth, tolerance).size();
    const std::size_t shown =
        vdamf::frameTimes(vdamf::truthAt(truth, times, tolerance), tolerance).size();
    if (shown == 0 || shown == all) return;
    std::fprintf(stderr, "%s: %zu of its %zu frames are none that were tracked: left out\n",
                 line.truth.c_str(), all - shown, all);
}

std::string pageOf(const CommandLine& line, const vdamf::Annotations& annotations,
                   const std::atomic<bool>& interrupted)
{
    vdamf::ReportTruth truth;
    truth.evaluation = line.evaluation;
    if (!line.truth.empty()) truth.rows = vdamf::readTruth(line.truth);
    vdamf::RunReportOptions options;
    options.ground = annotations.configuration.tracker.ground;
    options.clustering = annotations.configuration.tracker.clustering;
    options.hitsPerFrame = static_cast<std::size_t>(line.hitsPerFrame);
    vdamf::RunReport report(options);
    std::vector<double> times;
    const bool progress = !line.quiet && vdamf::isTerminal();
    const auto summary = vdamf::replayRawlog(
        line.input, annotations, interrupted,
        [&](const vdamf::LadarFrame& frame, const vdamf::FrameResult& result, double share)
        {
            report.add(frame, result);
            times.push_back(result.time);
            if (progress) showProgress(share, report.frames());
        });
    if (progress) std::fprintf(stderr, "\n");
    if (summary.interrupted) throw std::runtime_error("interrupted: no page is written");
    if (summary.tablesUnused > 0)
        std::fprintf(stderr, "%s: %llu frames are left out: their scan or its pose is missing\n",
                     line.input.c_str(), static_cast<unsigned long long>(summary.tablesUnused));
    warnOfTruthLeftOut(line, truth.rows, times);
    const vdamf::RunFacts facts = factsOf(line, annotations, summary);
    if (line.truth.empty()) return report.html(facts);
    return vdamf::namingTables(line.truth, line.input, [&] { return report.html(facts, truth); });
}

int run(const CommandLine& line)
{
    using vdamf::OutputFile;
    const std::atomic<bool>& interrupted = vdamf::catchSignals();
    // Opened first, so that the work does not end on a page that cannot be written.
    OutputFile output(
        line.output,
        line.overwrite ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse,
        OutputFile::Unfinished::Discard);
    const vdamf::Annotations annotations = vdamf::readAnnotations(line.input);
    if (!annotations.configurationProblem.empty())
        std::fprintf(stderr,
                     "%s: its configuration cannot be read, the built-in one is taken: %s\n",
                     line.input.c_str(), annotations.configurationProblem.c_str());
    if (annotations.tablesDamaged > 0)
        std::fprintf(stderr,
                     "%s: %llu of its tables of tracks cannot be read, their frames are left out; "
                     "the first one, at %s\n",
                     line.input.c_str(), static_cast<unsigned long long>(annotations.tablesDamaged),
                     annotations.firstDamaged.c_str());
    if (annotations.tablesRepeated > 0)
        std::fprintf(stderr,
                     "%s: %llu of its tables of tracks are of times that others before them have, "
                     "and are left out: are several runs joined in it?\n",
                     line.input.c_str(),
                     static_cast<unsigned long long>(annotations.tablesRepeated));
    vdamf::warnOfEntries(annotations.read, line.input.string());
    const std::string page = pageOf(line, annotations, interrupted);
    output.write(page);
    output.commit();
    if (!line.quiet && !vdamf::isStandardOutput(line.output))
        std::printf("%s: %zu frames, %.1f MB\n", line.output.c_str(), annotations.tables.size(),
                    1e-6 * static_cast<double>(page.size()));
    if (!annotations.read.truncated) return vdamf::kDone;
    std::fprintf(stderr, "%s: truncated: %s; the %zu frames before are in the page\n",
                 line.input.c_str(), annotations.read.truncation.c_str(),
                 annotations.tables.size());
    return vdamf::kFailed;
}

void prepare(CommandLine& line)
{
    line.evaluation.scoring.regionFov = line.regionFovDegrees * vdamf::kPi / 180.0;
    vdamf::checkOutputPaths({line.output}, {{line.input, "the input"}, {line.truth, "an input"}});
}
}  // namespace

int main(int argc, char** argv)
{
    CommandLine line;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-report",
         "Makes a page of an annotated rawlog that plays it in any browser, offline.",
         "Example:\n  vdamf-report street_tracked.rawlog -o street.html "
         "--truth datasets/street/truth.csv",
         [&](CLI::App& app) { declare(app, line); }, [&] { prepare(line); },
         [&] { return run(line); }});
}
