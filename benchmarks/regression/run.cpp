// SPDX-License-Identifier: BSD-3-Clause
#include "regression/run.h"

#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "regression/side_by_side.h"
#include "vdamf/experiments/process.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

struct RunFiles
{
    fs::path scans, truth, tracks, metrics, log;
};

// In a folder without what an earlier run has left there.
RunFiles preparedFiles(const fs::path& folder)
{
    makeFolder(folder);
    RunFiles files{folder / "scans.rawlog", folder / "truth.csv", folder / "tracks.csv",
                   folder / "metrics.json", folder / "log.txt"};
    for (const fs::path& file : {files.scans, files.truth, files.tracks, files.metrics, files.log})
        fs::remove(file);
    return files;
}

void call(const std::vector<std::string>& command, const std::vector<std::string>& more,
          const RegressionOptions& options, const fs::path& log)
{
    std::vector<std::string> all = command;
    all.front() = (options.programs / command.front()).string();
    all.insert(all.end(), more.begin(), more.end());
    const int exitCode = runProgram(all, log);
    if (exitCode != 0)
        throw std::runtime_error(command.front() + " " + exitInWords(exitCode) + " (" +
                                 log.string() + "): " + lastWords(log));
}

std::vector<std::string> trackCommand(const RegressionScenario& scenario, const RunFiles& files,
                                      const RegressionOptions& options)
{
    std::vector<std::string> command = {
        options.tracker.empty() ? "vdamf-track" : options.tracker.string(),
        "-c",
        options.config.string(),
        "-i",
        files.scans.string(),
        "--tracks",
        files.tracks.string(),
        "--overwrite"};
    command.insert(command.end(), scenario.track.begin(), scenario.track.end());
    for (const std::string& assignment : options.set)
        command.insert(command.end(), {"--set", assignment});
    return command;
}

nlohmann::json scored(const RunFiles& files, const std::vector<std::string>& how,
                      const RegressionOptions& options)
{
    const std::vector<std::string> command = {
        "vdamf-evaluate", "--overwrite",        "--tracks", files.tracks.string(),
        "--truth",        files.truth.string(), "--json",   files.metrics.string()};
    call(command, how, options, files.log);
    return nlohmann::json::parse(readTextFile(files.metrics));
}

MetricValues measured(const RegressionScenario& scenario, const RegressionOptions& options)
{
    const RunFiles files = preparedFiles(options.out / scenario.name);
    call(scenario.make,
         {"-o", files.scans.string(), "--truth", files.truth.string(), "--overwrite"}, options,
         files.log);
    call(trackCommand(scenario, files, options), {}, options, files.log);
    if (!options.keepScans) fs::remove(files.scans);
    const std::optional<double> time = trackingTimeIn(readTextFile(files.log));
    nlohmann::json evaluation = scored(files, scenario.score, options);
    std::vector<std::string> ofVehicles = scenario.score;
    ofVehicles.push_back("--vehicles-only");
    evaluation[kVehiclesOnly] = scored(files, ofVehicles, options);
    writeTextFile(files.metrics, evaluation.dump(2) + "\n");
    return valuesOf(evaluation, time);
}
}  // namespace

std::optional<double> trackingTimeIn(std::string_view summary)
{
    const std::string_view label = "tracking, all";
    const std::size_t begin = summary.rfind(label);
    if (begin == std::string_view::npos) return std::nullopt;
    std::string_view line = summary.substr(begin + label.size());
    line = line.substr(0, line.find('\n'));
    const std::size_t unit = line.find("ms");
    if (unit == std::string_view::npos) return std::nullopt;
    return parseNumber(trimmed(line.substr(0, unit)));
}

RunOutcome runScenario(const RegressionScenario& scenario, const RegressionOptions& options)
{
    const auto begin = std::chrono::steady_clock::now();
    RunOutcome outcome;
    outcome.row.scenario = scenario.name;
    try
    {
        outcome.row.values = measured(scenario, options);
    }
    catch (const std::exception& error)
    {
        outcome.failure = error.what();
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    outcome.seconds = passed.count();
    return outcome;
}

std::vector<RunOutcome> runScenarios(const std::vector<RegressionScenario>& scenarios,
                                     const RegressionOptions& options,
                                     const std::function<void(const RunOutcome&)>& done)
{
    std::vector<RunOutcome> outcomes(scenarios.size());
    std::mutex telling;
    sideBySide(scenarios.size(), options.jobs,
               [&](std::size_t i)
               {
                   outcomes[i] = runScenario(scenarios[i], options);
                   const std::lock_guard<std::mutex> one(telling);
                   done(outcomes[i]);
               });
    return outcomes;
}

}  // namespace vdamf
