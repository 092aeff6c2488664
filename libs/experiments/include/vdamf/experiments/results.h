// SPDX-License-Identifier: BSD-3-Clause
// What a sweep came to, and its tables.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/experiments/run_task.h"
#include "vdamf/experiments/settings.h"
#include "vdamf/experiments/sweep_file.h"

namespace vdamf
{
/// One recording with one setting.
struct SweepRow
{
    std::size_t setting = 0;                    ///< in SweepResults::settings
    std::size_t recording = 0;                  ///< in SweepResults::recordings
    std::string run;                            ///< name of the run's folder
    std::string failure;                        ///< empty: done
    std::vector<std::optional<double>> values;  ///< by metric; empty cells: not known
    RunTimes times;                             ///< of a run that is done
};

struct SweepResults
{
    std::vector<std::string> keys;
    std::vector<SweepSetting> settings;
    std::vector<std::string> recordings;
    std::vector<std::string> metrics;
    SweepGoal goal;
    std::vector<SweepRow> rows;  ///< by setting, then by recording
};

/// What one setting came to over the recordings. One that no setting knows the value of (all of
/// its runs failed) tells nothing of the settings and is left out; where another setting knows what
/// this one does not, there is no mean to compare.
struct SettingSummary
{
    std::vector<std::optional<double>> means;  ///< by metric
    std::optional<double> msPerFrame;          ///< mean over the recordings
    std::size_t failures = 0;
};

std::vector<SettingSummary> summaries(const SweepResults& results);

/// Names of the recordings that no setting knows the goal's metric of.
std::vector<std::string> silentRecordings(const SweepResults& results);

/// The setting with the best mean of the goal's metric, the first one of equals; nothing where
/// none knows it.
std::optional<std::size_t> bestSetting(const SweepResults& results);

/// Settings that no other one beats in both the goal's mean and the time a frame, by rising time.
std::vector<std::size_t> paretoFront(const SweepResults& results);

/// Place of the goal's metric in `metrics`.
std::size_t goalIndex(const SweepResults& results);

/// table.csv: `setting,recording`, the swept keys, `status` (done, failed), `run`, and the metrics
/// with 9 significant digits; an empty cell: not known. Settings count from 1. The same runs give
/// the same bytes, whatever carried them out.
std::string tableCsv(const SweepResults& results);

/// times.csv: `setting,recording,run,frames,seconds,tracking_ms_per_frame` of the runs that are
/// done.
std::string timesCsv(const SweepResults& results);

}  // namespace vdamf
