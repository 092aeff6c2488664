// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/sweep.h"

#include <map>
#include <stdexcept>

#include "vdamf/experiments/metric_names.h"
#include "vdamf/experiments/optimise.h"
#include "vdamf/experiments/setting_configuration.h"
#include "vdamf/files/folder.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

class Runner
{
public:
    Runner(const PreparedSweep& sweep, const SweepProgram& program, const fs::path& folder,
           const Engine& engine, const std::atomic<bool>& stop, const SweepListener& listener)
        : sweep_(sweep),
          program_(program),
          folder_(fs::absolute(folder).lexically_normal()),
          engine_(engine),
          stop_(stop),
          listener_(listener)
    {
        for (const SweptKey& key : sweep.file.keys) results_.keys.push_back(key.name);
        for (const SweepRecording& one : sweep.recordings) results_.recordings.push_back(one.name);
        results_.metrics = sweep.file.metrics;
        results_.goal = sweep.file.goal;
    }

    void run(const std::vector<SweepSetting>& settings)
    {
        const std::vector<PlannedRun> runs =
            plannedRuns(sweep_, settings, results_.settings.size(), program_, folder_);
        listener_.planned(runs);
        const std::map<std::string, std::string> failures = runMissing(runs);
        if (stop_) return;
        results_.settings.insert(results_.settings.end(), settings.begin(), settings.end());
        for (const PlannedRun& planned : runs)
            results_.rows.push_back(rowOf(planned, failures.at(planned.row.run)));
    }

    const SweepResults& results() const { return results_; }

private:
    // By name of the run: two recordings with the same content are one run.
    std::map<std::string, std::string> runMissing(const std::vector<PlannedRun>& runs)
    {
        std::vector<EngineTask> tasks;
        std::vector<const PlannedRun*> missing;
        std::map<std::string, std::string> failures;
        for (const PlannedRun& planned : runs)
        {
            const bool isNew = failures.try_emplace(planned.row.run).second;
            // The order of a run that was done when its sweep was killed.
            if (isNew && planned.isDone) fs::remove_all(folder_ / "tasks" / planned.row.run);
            if (!isNew || planned.isDone) continue;
            tasks.push_back({folder_ / "tasks" / planned.row.run, planned.task.result});
            missing.push_back(&planned);
        }
        makeFolder(folder_ / "runs");
        for (std::size_t i = 0; i < tasks.size(); ++i) writeTask(missing[i]->task, tasks[i].folder);
        if (tasks.empty()) return failures;
        engine_(tasks, stop_,
                [&](std::size_t i, const std::string& failure)
                {
                    if (failure.empty()) fs::remove_all(tasks[i].folder);
                    failures[missing[i]->row.run] = failure;
                    listener_.finished(*missing[i], failure);
                });
        return failures;
    }

    SweepRow rowOf(const PlannedRun& planned, const std::string& failure) const
    {
        SweepRow row = planned.row;
        row.failure = failure;
        if (!failure.empty()) return row;
        const fs::path result = planned.task.result;
        try
        {
            row.values = readMetrics(result / "metrics.json", results_.metrics);
            row.times = readTimes(result);
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error(std::string(error.what()) + "; remove the folder " +
                                     result.string() + " to do this run again");
        }
        return row;
    }

    const PreparedSweep& sweep_;
    const SweepProgram& program_;
    fs::path folder_;
    const Engine& engine_;
    const std::atomic<bool>& stop_;
    const SweepListener& listener_;
    SweepResults results_;
};

std::optional<double> latestScore(const SweepResults& results)
{
    const auto mean = summaries(results).back().means[goalIndex(results)];
    if (!mean) return std::nullopt;
    return results.goal.highest ? *mean : -*mean;
}

struct Stopped
{
};

// Why the values of a setting are not allowed together; empty: they are.
std::string problemOf(const PreparedSweep& sweep, const SweepSetting& setting)
{
    try
    {
        checkSetting(sweep.file, sweep.base, setting);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
    return "";
}

void search(const PreparedSweep& sweep, Runner& runner, const std::atomic<bool>& stop,
            const SweepListener& listener)
{
    const auto score = [&](const SweepSetting& setting) -> std::optional<double>
    {
        const std::string problem = problemOf(sweep, setting);
        if (!problem.empty())
        {
            listener.impossible(problem);
            return std::nullopt;
        }
        runner.run({setting});
        if (stop) throw Stopped();
        return latestScore(runner.results());
    };
    const auto count = static_cast<std::size_t>(sweep.file.sweep.count);
    try
    {
        optimiseSettings(sweep.file.keys, sweep.file.sweep.optimiser, count, score);
    }
    catch (const Stopped&)
    {
        return;  // the caller knows
    }
    if (runner.results().settings.empty())
        throw std::runtime_error(
            sweep.file.path.string() +
            ": the search came to no setting whose values are allowed together");
}

// Those that no setting knows the goal's metric of are in no mean.
std::string recordingsInWords(const SweepResults& results)
{
    const std::size_t all = results.recordings.size();
    const std::size_t silent = silentRecordings(results).size();
    const std::string counted = std::to_string(all) + (all == 1 ? " recording" : " recordings");
    if (silent == 0) return counted;
    return std::to_string(all - silent) + " of " + counted +
           "; the others have none with any setting";
}
}  // namespace

std::vector<PlannedRun> plannedRuns(const PreparedSweep& sweep,
                                    const std::vector<SweepSetting>& settings,
                                    std::size_t firstSetting, const SweepProgram& program,
                                    const fs::path& folder)
{
    std::vector<PlannedRun> runs;
    for (std::size_t s = 0; s < settings.size(); ++s)
    {
        for (std::size_t r = 0; r < sweep.recordings.size(); ++r)
        {
            const SweepRecording& recording = sweep.recordings[r];
            const RecordingGroup& group = sweep.file.groups[recording.group];
            PlannedRun run;
            run.task.rawlog = recording.rawlog.string();
            run.task.truth = recording.truth.string();
            run.task.version = program.version;
            run.task.frames = group.frames;
            run.task.score = group.score;
            run.task.configuration = configurationOf(sweep.file, sweep.base, group, settings[s]);
            run.row.setting = firstSetting + s;
            run.row.recording = r;
            run.row.run = runId(run.task, sweep.rawlogDigests[r], sweep.truthDigests[r],
                                program.version + " " + program.digest);
            const fs::path result = fs::absolute(folder / "runs" / run.row.run).lexically_normal();
            run.task.result = result.string();
            run.isDone = fs::exists(result);
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

SweepResults runSweep(const PreparedSweep& sweep, const SweepProgram& program,
                      const fs::path& folder, const Engine& engine, const std::atomic<bool>& stop,
                      const SweepListener& listener)
{
    Runner runner(sweep, program, folder, engine, stop, listener);
    if (sweep.file.sweep.plan == PlanKind::Optimise)
        search(sweep, runner, stop, listener);
    else
        runner.run(sweep.settings);
    return runner.results();
}

std::string settingIni(const PreparedSweep& sweep, const SweepResults& results, std::size_t setting)
{
    const SweepSetting& chosen = results.settings[setting];
    RecordingGroup all;
    return "# Setting " + std::to_string(setting + 1) + " of " +
           sweep.file.path.filename().string() + ": " + inWords(sweep.file, chosen) +
           "\n# Best mean of " + results.goal.metric + " over " + recordingsInWords(results) +
           "\n\n" + configurationOf(sweep.file, sweep.base, all, chosen);
}

}  // namespace vdamf
