// SPDX-License-Identifier: BSD-3-Clause
// Which frames of the truth are those of a run: tracks of a part of a recording are judged by the
// truth of that part.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
/// Both ends are in it.
struct TimeSpan
{
    double first = 0.0;  ///< s
    double last = 0.0;   ///< s
};

/// From the earliest row to the latest one; nothing without rows.
std::optional<TimeSpan> spanOf(const std::vector<TruthRow>& truth);
std::optional<TimeSpan> spanOf(const std::vector<TrackRow>& tracks);

/// "100.000000 to 101.900000 s".
std::string inWords(const TimeSpan& span);

/// The rows of the span, or at most `tolerance` (s) before or after it; in their order.
std::vector<TruthRow> truthWithin(const std::vector<TruthRow>& truth, const TimeSpan& span,
                                  double tolerance = 1e-3);

/// The rows at one of the times, give or take `tolerance` (s); in their order.
std::vector<TruthRow> truthAt(const std::vector<TruthRow>& truth, std::vector<double> times,
                              double tolerance = 1e-3);

/// Times of frames, rising; rows within `tolerance` (s) of the first one of a frame belong to it.
std::vector<double> frameTimes(const std::vector<TruthRow>& truth, double tolerance = 1e-3);
std::vector<double> frameTimes(const std::vector<TrackRow>& tracks, double tolerance = 1e-3);
std::vector<double> frameTimes(std::vector<double> ofRows, double tolerance = 1e-3);

/// Index of the one nearest to `time` (s) among rising times, of which there is one at least; of
/// two as near the earlier one.
std::size_t nearestTime(const std::vector<double>& times, double time);

/// Throws std::runtime_error that says that no time of the tracks is one of the truth.
[[noreturn]] void failNothingCommon(const TimeSpan& truth, const TimeSpan& tracks);

}  // namespace vdamf
