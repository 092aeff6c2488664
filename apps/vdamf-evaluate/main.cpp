// SPDX-License-Identifier: BSD-3-Clause
// vdamf-evaluate: how good tracks are, told by the truth.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "program.h"
#include "time_warnings.h"
#include "vdamf/evaluation/evaluation.h"
#include "vdamf/evaluation/evaluation_json.h"
#include "vdamf/evaluation/named_tables.h"
#include "vdamf/evaluation/truth_frames.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/output_file.h"
#include "vdamf/report/evaluation_plots.h"
#include "vdamf/report/evaluation_text.h"

namespace
{
namespace fs = std::filesystem;

struct CommandLine
{
    fs::path tracks;
    fs::path truth;
    fs::path json;
    fs::path plots;
    double regionFovDegrees = 0.0;
    bool objects = false;
    bool overwrite = false;
    vdamf::EvaluationOptions options;
};

/// An output: where to, and what.
struct Output
{
    fs::path path;
    std::string content;
};

void declareScoring(CLI::App& app, CommandLine& line)
{
    vdamf::ScoringOptions& scoring = line.options.scoring;
    app.add_option("--classes", scoring.classes, "objects that count, by commas")
        ->delimiter(',')
        ->check(CLI::IsMember(vdamf::truthClasses()))
        ->capture_default_str();
    app.add_option("--region-fov-deg", line.regionFovDegrees,
                   "labelled sector ahead of the sensor; 0: all around (KITTI: 80)")
        ->check(vdamf::within(0.0, 360.0))
        ->capture_default_str();
    app.add_option("--max-range-m", scoring.maxRange, "score up to this range; 0: all")
        ->check(vdamf::within(0.0, 1e4))
        ->capture_default_str();
    app.add_option("--min-points", scoring.minPoints, "objects with fewer hits do not count")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    app.add_option("--overlap", scoring.overlap,
                   "bird's-eye IoU from which a track has found an object")
        ->check(vdamf::within(0.01, 1.0))
        ->capture_default_str();
    app.add_option("--pair-overlap", line.options.pairOverlap,
                   "bird's-eye IoU of the pairs whose errors are told")
        ->check(vdamf::within(0.01, 1.0))
        ->capture_default_str();
    app.add_option("--still-speed-mps", line.options.stillSpeed,
                   "objects slower than this stand still")
        ->check(vdamf::within(0.0, 100.0))
        ->capture_default_str();
    app.add_flag("--tracked-span", line.options.trackedSpan,
                 "score from the first to the last time of the tracks: of a part of a recording");
    app.add_flag("--vehicles-only", scoring.onlyVehicles,
                 "drop tracks that the discriminator takes for clutter");
    app.add_flag("--with-tentative", scoring.withTentative, "score tentative tracks too");
}

void declare(CLI::App& app, CommandLine& line)
{
    app.add_option("--tracks", line.tracks, "table of tracks (csv)")->required();
    app.add_option("--truth", line.truth, "table of labelled objects (csv)")->required();
    declareScoring(app, line);
    app.add_flag("--objects", line.objects, "print a line for each object, too");
    app.add_option("--json", line.json, "metrics to write (JSON)");
    app.add_option("--plots", line.plots, "charts to write: one file (*.svg), or a folder");
    app.add_flag("--overwrite", line.overwrite, "replace existing outputs");
}

bool isOnePicture(const fs::path& plots)
{
    return plots.extension() == ".svg";
}

/// Known before the work: a run must not end on a name that cannot be.
std::vector<fs::path> outputsOf(const CommandLine& line)
{
    std::vector<fs::path> outputs;
    if (!line.json.empty()) outputs.push_back(line.json);
    if (line.plots.empty()) return outputs;
    if (isOnePicture(line.plots))
    {
        outputs.push_back(line.plots);
        return outputs;
    }
    for (const std::string& name : vdamf::evaluationChartNames())
        outputs.push_back(line.plots / (name + ".svg"));
    return outputs;
}

/// True for the usual endings of pictures and of this program's other output.
bool isNamedAsFile(const fs::path& path)
{
    static const std::set<std::string> kEndings = {".svg", ".SVG",  ".png", ".PNG", ".jpg",
                                                   ".JPG", ".jpeg", ".pdf", ".PDF", ".json"};
    return kEndings.count(path.extension().string()) > 0;
}

/// Throws where charts cannot have this folder.
void checkFolder(const fs::path& folder, const fs::path& json)
{
    if (fs::is_directory(folder)) return;
    if (fs::exists(folder))
        throw std::invalid_argument(folder.string() + ": is no folder, and does not end in .svg");
    if (isNamedAsFile(folder))
        throw std::invalid_argument(folder.string() +
                                    ": charts are .svg; name such a file, or a folder");
    if (!json.empty() && vdamf::sameFile(json, folder))
        throw std::invalid_argument(folder.string() + ": is named for two outputs");
}

void prepare(CommandLine& line)
{
    line.options.scoring.regionFov = line.regionFovDegrees * vdamf::kPi / 180.0;
    vdamf::checkOutputPaths(outputsOf(line), {{line.tracks, "an input"}, {line.truth, "an input"}});
    if (!line.plots.empty() && !isOnePicture(line.plots)) checkFolder(line.plots, line.json);
}

std::vector<Output> contentsOf(const CommandLine& line, const vdamf::Evaluation& evaluation)
{
    std::vector<Output> outputs;
    if (!line.json.empty()) outputs.push_back({line.json, vdamf::toJson(evaluation)});
    if (line.plots.empty()) return outputs;
    std::vector<vdamf::Chart> charts;
    for (const vdamf::NamedChart& named : vdamf::evaluationCharts(evaluation))
    {
        charts.push_back(named.chart);
        if (isOnePicture(line.plots)) continue;
        outputs.push_back({line.plots / (named.name + ".svg"), vdamf::chartsSvg({named.chart})});
    }
    if (isOnePicture(line.plots)) outputs.push_back({line.plots, vdamf::chartsSvg(charts, 3)});
    return outputs;
}

void write(const std::vector<Output>& outputs, bool overwrite)
{
    using vdamf::OutputFile;
    const auto existing =
        overwrite ? OutputFile::Existing::Overwrite : OutputFile::Existing::Refuse;
    // All of them are opened, and written, before the first one gets its name.
    std::vector<std::unique_ptr<OutputFile>> files;
    for (const Output& output : outputs)
    {
        files.push_back(
            std::make_unique<OutputFile>(output.path, existing, OutputFile::Unfinished::Discard));
        files.back()->write(output.content);
    }
    for (const auto& file : files) file->commit();
}

/// Charts of an earlier run that this one does not have would pass for its own.
void removeOlder(const CommandLine& line, const std::vector<Output>& written)
{
    for (const fs::path& path : outputsOf(line))
    {
        const bool isOwn = std::any_of(written.begin(), written.end(),
                                       [&](const Output& output) { return output.path == path; });
        if (!isOwn && fs::is_regular_file(path)) fs::remove(path);
    }
}

vdamf::ScoredTables tablesOf(const CommandLine& line)
{
    vdamf::ScoredTables tables;
    tables.truthName = line.truth.string();
    tables.tracksName = line.tracks.string();
    tables.truth = vdamf::readTruth(line.truth);
    tables.tracks = vdamf::readTracks(line.tracks);
    if (!line.options.trackedSpan || tables.truth.empty()) return tables;
    const auto tracked = vdamf::spanOf(tables.tracks);
    if (!tracked)
        throw std::runtime_error(tables.tracksName +
                                 ": has no rows, so --tracked-span has no times");
    const std::string labelled = inWords(*vdamf::spanOf(tables.truth));
    tables.truth = vdamf::truthWithin(tables.truth, *tracked, line.options.scoring.timeTolerance);
    if (!tables.truth.empty()) return tables;
    throw std::runtime_error(tables.truthName + ": none of its frames (" + labelled +
                             ") is between the times of " + tables.tracksName + " (" +
                             inWords(*tracked) + ")");
}

/// On stderr: the zeros of nothing would pass for the tracker's.
void warnOfNothingScored(const CommandLine& line, std::size_t rows)
{
    std::fprintf(stderr,
                 "vdamf-evaluate: %s: nothing is scored: none of its %zu rows is of the classes "
                 "asked for, has at least %d hits and lies in the region\n",
                 line.truth.c_str(), rows, line.options.scoring.minPoints);
}

int run(const CommandLine& line)
{
    const vdamf::ScoredTables tables = tablesOf(line);
    vdamf::warnOfTimes(tables, line.options.scoring.timeTolerance);
    const vdamf::Evaluation evaluation = vdamf::namingTables(
        line.truth, line.tracks,
        [&] { return vdamf::evaluate(tables.truth, tables.tracks, line.options); });
    if (evaluation.counts.objectRows == 0) warnOfNothingScored(line, tables.truth.size());
    if (!line.plots.empty() && !isOnePicture(line.plots)) vdamf::makeFolder(line.plots);
    const std::vector<Output> outputs = contentsOf(line, evaluation);
    write(outputs, line.overwrite);
    if (line.overwrite) removeOlder(line, outputs);
    std::string text = vdamf::evaluationText(evaluation);
    if (line.objects) text += "\n" + vdamf::objectsText(evaluation);
    const bool jsonOnStandardOutput = !line.json.empty() && vdamf::isStandardOutput(line.json);
    if (!jsonOnStandardOutput) std::fputs(text.c_str(), stdout);
    return vdamf::kDone;
}
}  // namespace

int main(int argc, char** argv)
{
    CommandLine line;
    return vdamf::runProgram(
        argc, argv,
        {"vdamf-evaluate",
         "Compares tracks with the truth: detection, tracking, errors, consistency.",
         "Example:\n  vdamf-evaluate --tracks tracks.csv --truth datasets/street/truth.csv "
         "--plots street.svg",
         [&](CLI::App& app) { declare(app, line); }, [&] { prepare(line); },
         [&] { return run(line); }});
}
