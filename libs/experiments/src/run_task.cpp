// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/run_task.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "vdamf/evaluation/evaluation_json.h"
#include "vdamf/evaluation/named_tables.h"
#include "vdamf/evaluation/truth_frames.h"
#include "vdamf/experiments/digest.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr const char* kFailureFile = "failure.txt";

// The range by the name of its key.
TrackRawlogSummary trackInRange(const TrackRawlogJob& job)
{
    const std::atomic<bool> never{false};
    try
    {
        return trackRawlog(job, never);
    }
    catch (const NoFrameInRange& error)
    {
        throw std::runtime_error("first_frame = " + std::to_string(job.firstFrame) + ": " +
                                 error.what());
    }
}

TrackRawlogSummary track(const RunTask& task, const fs::path& taskFolder, const fs::path& folder)
{
    TrackRawlogJob job;
    job.input = task.rawlog;
    job.tracks = folder / "tracks.csv";
    job.version = task.version;
    job.configuration = loadConfiguration(taskFolder / "config.ini");
    job.firstFrame = static_cast<std::uint64_t>(task.frames.first);
    if (task.frames.last > 0) job.lastFrame = static_cast<std::uint64_t>(task.frames.last);
    const TrackRawlogSummary summary = trackInRange(job);
    if (!summary.readError.empty()) throw ReadError(summary.readError);
    if (summary.read.truncated)
        throw std::runtime_error(task.rawlog + ": truncated: " + summary.read.truncation);
    return summary;
}

// The truth of the range asked for: what lies before or behind it was not to be found.
std::vector<TruthRow> truthInRange(const std::vector<TruthRow>& all, const RunTask& task,
                                   const TrackRawlogSummary& summary)
{
    if (summary.frames == 0) return all;
    constexpr double kEver = std::numeric_limits<double>::infinity();
    const TimeSpan tracked{task.frames.first > 0 ? summary.firstTime : -kEver,
                           task.frames.last > 0 ? summary.lastTime : kEver};
    const std::vector<TruthRow> truth = truthWithin(all, tracked, task.score.scoring.timeTolerance);
    if (truth.empty() && !all.empty())
        throw std::runtime_error("no object is in the range that was tracked (" +
                                 inWords(TimeSpan{summary.firstTime, summary.lastTime}) + ")");
    return truth;
}

void score(const RunTask& task, const TrackRawlogSummary& summary, const fs::path& folder)
{
    const std::vector<TruthRow> truth = readTruth(task.truth);
    const std::vector<TrackRow> tracks = readTracks(folder / "tracks.csv");
    const auto evaluated = [&]
    { return evaluate(truthInRange(truth, task, summary), tracks, task.score.options()); };
    writeTextFile(folder / "metrics.json",
                  toJson(namingTables(task.truth, task.rawlog, evaluated)));
}

std::string timesJson(const TrackRawlogSummary& summary, double seconds)
{
    const double tracking = std::accumulate(summary.stageSeconds.begin(),
                                            summary.stageSeconds.end(), summary.frameSeconds);
    const auto frames = static_cast<double>(std::max<std::uint64_t>(1, summary.frames));
    nlohmann::ordered_json json;
    json["frames"] = summary.frames;
    json["seconds"] = seconds;
    json["tracking_ms_per_frame"] = 1e3 * tracking / frames;
    return json.dump(2) + "\n";
}

// The folder gets its name as a whole; where another process was faster, its result stays.
void publish(const fs::path& folder, const fs::path& result)
{
    std::error_code error;
    fs::rename(folder, result, error);
    if (!error) return;
    if (!fs::exists(result))
        throw std::runtime_error(result.string() + ": cannot make: " + error.message());
    fs::remove_all(folder);
}
void runTask(const fs::path& folder, const TaskReport& tell)
{
    const auto begin = std::chrono::steady_clock::now();
    const RunTask task = readTask(folder);
    // A folder of this process: an earlier or a second one may have left, or still write, its own.
    std::array<char, 256> host = {};
    ::gethostname(host.data(), host.size() - 1);
    const fs::path work =
        folder / ("work-" + std::string(host.data()) + "-" + std::to_string(::getpid()));
    fs::remove_all(work);
    fs::create_directory(work);
    const TrackRawlogSummary summary = track(task, folder, work);
    score(task, summary, work);
    writeTextFile(work / "config.ini", task.configuration);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    writeTextFile(work / "times.json", timesJson(summary, passed.count()));
    tell(summary, task);
    std::fflush(nullptr);
    if (fs::exists(folder / kLogFile)) fs::copy_file(folder / kLogFile, work / kLogFile);
    publish(work, task.result);
}
}  // namespace

std::string runId(const RunTask& task, const std::string& rawlogDigest,
                  const std::string& truthDigest, const std::string& program)
{
    IniWriter writer;
    writer.write("frames", "", task.frames);
    writer.write("score", "", task.score);
    std::string all = "run 1\n";
    for (const std::string& part : {program, rawlogDigest, truthDigest, writer.text()})
        all += part + "\n";
    const Configuration settings =
        readSettings(IniDocument::parse(task.configuration, "the configuration of a run"));
    for (const NamedInput& file : filesNamedBy(settings))
        if (!file.path.empty()) all += file.name + " " + digestOfFile(file.path) + "\n";
    return digestOf(all + task.configuration);
}

void writeTask(const RunTask& task, const fs::path& folder)
{
    IniWriter writer;
    writer.write("task", "One run of a sweep", task);
    makeFolder(folder);
    writeTextFile(folder / "config.ini", task.configuration);
    writeTextFile(folder / "task.ini", writer.text());
}

RunTask readTask(const fs::path& folder)
{
    const IniDocument document = IniDocument::load(folder / "task.ini");
    RunTask task;
    IniReader reader(document);
    reader.read("task", task);
    reader.finish();
    task.configuration = readTextFile(folder / "config.ini");
    return task;
}

RunTimes readTimes(const fs::path& resultFolder)
{
    const fs::path file = resultFolder / "times.json";
    try
    {
        const auto json = nlohmann::json::parse(readTextFile(file));
        return {json.at("frames"), json.at("seconds"), json.at("tracking_ms_per_frame")};
    }
    catch (const nlohmann::json::exception&)
    {
        throw std::runtime_error(file.string() + ": is damaged");
    }
}

void performTask(const fs::path& folder, const TaskReport& tell)
{
    try
    {
        runTask(folder, tell);
    }
    catch (const std::exception& error)
    {
        writeTextFile(folder / kFailureFile, error.what());
        throw;
    }
}

void prepareAttempt(const fs::path& folder)
{
    fs::remove(folder / kFailureFile);
    fs::remove(folder / kLogFile);
}

std::optional<std::string> failureOf(const fs::path& folder)
{
    if (!fs::exists(folder / kFailureFile)) return std::nullopt;
    return readTextFile(folder / kFailureFile);
}

}  // namespace vdamf
