// SPDX-License-Identifier: BSD-3-Clause
// One run: one recording tracked with one configuration, and scored. Its order stands in a task
// folder, what came out in a result folder that appears when it is whole.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "vdamf/experiments/recordings.h"
#include "vdamf/experiments/run_input.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// What a run is told. Files of a task folder: task.ini, config.ini and, once
/// it runs, log.txt.
struct RunTask
{
    std::string rawlog;
    std::string truth;
    std::string result;  ///< folder to make; its parent exists
    std::string version;
    FrameRange frames;
    RunScoring score;
    std::string configuration;  ///< ini, as toIni() writes it

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.rawlog, "rawlog", "to track");
        field(self.truth, "truth", "to score by");
        field(self.result, "result", "folder to make");
        field(self.version, "version", "of the program");
        FrameRange::visit(self.frames, field);
        RunScoring::visit(self.score, field);
    }
};

/// What a run depends on: the digests of its recording and of its truth, the range and the scoring,
/// the effective configuration, and the program. Its name: 32 hexadecimal digits.
std::string runId(const RunTask& task, const std::string& rawlogDigest,
                  const std::string& truthDigest, const std::string& program);

/// Makes the task folder. Throws std::runtime_error.
void writeTask(const RunTask& task, const std::filesystem::path& folder);
RunTask readTask(const std::filesystem::path& folder);

/// What a run took. Never equal twice, so it stands beside the results and not in them.
struct RunTimes
{
    std::uint64_t frames = 0;
    double seconds = 0.0;           ///< in all
    double trackingMsPerFrame = 0;  ///< scan to world frame, and the tracker's stages
};

RunTimes readTimes(const std::filesystem::path& resultFolder);

/// What is told of a run in its log.
using TaskReport = std::function<void(const TrackRawlogSummary&, const RunTask&)>;

/// Of a task folder; whoever starts performTask() sends there what it prints.
constexpr const char* kLogFile = "log.txt";

/// Runs a task and makes its result folder: config.ini, tracks.csv, metrics.json, times.json and
/// log.txt (the task's own, as far as it is written). Where the result exists already, by another
/// process, that one stays. Throws std::runtime_error; then there is no result, and the task folder
/// says why.
void performTask(const std::filesystem::path& folder, const TaskReport& tell);

/// Forgets what an earlier attempt has left in the task folder.
void prepareAttempt(const std::filesystem::path& folder);

/// Why the task's run failed by itself; nothing where it did not, or was ended by others.
std::optional<std::string> failureOf(const std::filesystem::path& folder);

}  // namespace vdamf
