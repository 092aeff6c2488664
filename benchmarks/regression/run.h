// SPDX-License-Identifier: BSD-3-Clause
// One scenario from its scans to its numbers, and many of them side by side.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "regression/catalogue.h"
#include "regression/metric.h"

namespace vdamf
{
struct RegressionOptions
{
    std::filesystem::path programs;  ///< folder of vdamf-track and the others
    std::filesystem::path tracker;   ///< called in place of vdamf-track; empty: that
    std::filesystem::path config;    ///< of vdamf-track
    std::vector<std::string> set;    ///< section.key=value over it
    std::filesystem::path out;       ///< each scenario has a folder of its own in it
    bool keepScans = false;          ///< the rawlogs, which are large
    unsigned jobs = 1;
};

struct RunOutcome
{
    RegressionRow row;    ///< without values if the run failed
    std::string failure;  ///< empty: done
    double seconds = 0.0;
};

/// Milliseconds per frame of vdamf-track's summary; nothing if the text has none.
std::optional<double> trackingTimeIn(std::string_view summary);

/// Makes scans and truth, tracks and scores, with outputs in `<out>/<name>/`: truth.csv,
/// tracks.csv, metrics.json and log.txt. What fails is told in the outcome.
RunOutcome runScenario(const RegressionScenario& scenario, const RegressionOptions& options);

/// All of them, in their order; `done` is told of each when it is (one call at a time).
std::vector<RunOutcome> runScenarios(const std::vector<RegressionScenario>& scenarios,
                                     const RegressionOptions& options,
                                     const std::function<void(const RunOutcome&)>& done);

}  // namespace vdamf
