// SPDX-License-Identifier: BSD-3-Clause
// A drive replayed for hours of recording time, ever farther from where it began: does a run of
// that length stay as it was in its first minutes?
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "vdamf/rawlog/configuration.h"

namespace vdamf::endurance
{
struct Plan
{
    std::filesystem::path rawlog;  ///< of poses as CObservationRobotPose, and scans
    double hours = 1.0;            ///< of recording time
    /// m to the east and to the north from one round to the next: a multiple of 2^-16 m, so that
    /// the same numbers come back.
    double drift = 137.25;
    double pause = 4.0;  ///< s between rounds, in which all tracks end
    int rows = 12;       ///< of the report
    Configuration configuration;
};

/// One part of the run.
struct Row
{
    double hours = 0.0;       ///< of recording time, at its end
    double kilometres = 0.0;  ///< from the origin
    std::uint64_t frames = 0;
    double milliseconds = 0.0;  ///< of computing a frame, on average
    double megabytes = 0.0;     ///< resident at its end
    /// Shares of the tracks that lie within 1 nm and within 1 mm of one in the same frame of the
    /// first round. What the input's own rounding far away turns is not the same.
    double same = 1.0;
    double alike = 1.0;
};

struct Result
{
    std::vector<Row> rows;
    std::uint64_t tracks = 0;     ///< identities
    std::uint64_t confirmed = 0;  ///< that were confirmed
    std::uint64_t reused = 0;     ///< identities that came back after their end
    std::uint64_t rounds = 0;
};

/// Feeds the rounds through a pipe to trackRawlog(), whose outputs go to /dev/null. `onRow` is
/// called as each row is done. Throws std::runtime_error as trackRawlog() does.
Result run(const Plan& plan, const std::function<void(const Row&)>& onRow = {});

}  // namespace vdamf::endurance
