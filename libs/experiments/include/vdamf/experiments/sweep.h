// SPDX-License-Identifier: BSD-3-Clause
// A sweep from its file to its results: everything checked first, what is done skipped, what is
// left given to an engine.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vdamf/experiments/engine.h"
#include "vdamf/experiments/recordings.h"
#include "vdamf/experiments/results.h"
#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
/// The program whose results these are.
struct SweepProgram
{
    std::string version;
    std::string digest;  ///< of its file: another build may track otherwise
};

/// A sweep that passed all checks.
struct PreparedSweep
{
    SweepFile file;
    IniDocument base;
    std::vector<SweepRecording> recordings;
    std::vector<std::string> rawlogDigests;  ///< by recording
    std::vector<std::string> truthDigests;   ///< by recording
    /// Of the plans that know them before: all but `optimise`.
    std::vector<SweepSetting> settings;
    std::size_t runs = 0;  ///< of the plan, at most
};

/// Reads the file and checks everything that can fail before a run: keys and values, recordings and
/// truths, the size of the plan, the configuration of each setting. Reads the recordings for their
/// digests, at last. Throws std::runtime_error.
PreparedSweep prepareSweep(const std::filesystem::path& file);

struct PlannedRun
{
    SweepRow row;
    RunTask task;
    bool isDone = false;
};

/// The runs of these settings, numbered from `firstSetting`; `folder` is the sweep's.
std::vector<PlannedRun> plannedRuns(const PreparedSweep& sweep,
                                    const std::vector<SweepSetting>& settings,
                                    std::size_t firstSetting, const SweepProgram& program,
                                    const std::filesystem::path& folder);

/// Told while a sweep goes on.
struct SweepListener
{
    /// Once for each part of the plan: how many of its runs are done already, and are not.
    std::function<void(const std::vector<PlannedRun>&)> planned;
    std::function<void(const PlannedRun&, const std::string& failure)> finished;
    /// A search came to a setting whose values are not allowed together: it has no runs.
    std::function<void(const std::string& why)> impossible;
};

/// Carries the sweep out. Folders below `folder`: `runs/<run>`, whole results; `tasks/<run>`, those
/// in progress and those that failed, with their log. Returns early when `stop` is set: then rows
/// are missing. Throws std::runtime_error where it cannot go on.
SweepResults runSweep(const PreparedSweep& sweep, const SweepProgram& program,
                      const std::filesystem::path& folder, const Engine& engine,
                      const std::atomic<bool>& stop, const SweepListener& listener);

/// The configuration of a setting as ini, with a heading that says where it is from. Where groups
/// of recordings set keys of their own, without these.
std::string settingIni(const PreparedSweep& sweep, const SweepResults& results,
                       std::size_t setting);

}  // namespace vdamf
