// SPDX-License-Identifier: BSD-3-Clause
// How far a sweep is, and how long it still takes.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "vdamf/experiments/sweep.h"

namespace vdamf
{
/// On stderr: a bar on a terminal, a line a run in a log. Failed runs are always told.
class SweepProgress
{
public:
    enum class Style
    {
        Bar,
        Lines,
        Quiet
    };

    SweepProgress(const PreparedSweep& sweep, Style style);

    void planned(const std::vector<PlannedRun>& runs);
    void finished(const PlannedRun& run, const std::string& failure);
    void tell(const std::string& text) const;  ///< a line, also where it is quiet
    void end() const;                          ///< behind the bar

    std::size_t failures() const { return failures_; }
    std::size_t skipped() const { return skipped_; }

private:
    std::string remaining() const;
    void show(const PlannedRun& run, const std::string& failure) const;

    const PreparedSweep& sweep_;
    Style style_;
    std::size_t done_ = 0;
    std::size_t skipped_ = 0;
    std::size_t failures_ = 0;
    /// Of rawlogs: a run takes about as long as its rawlog is large.
    double bytesDone_ = 0.0;
    double bytesSkipped_ = 0.0;
    double bytesPlanned_ = 0.0;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// "12 s", "3 min", "2 h 10 min"
std::string durationInWords(double seconds);

}  // namespace vdamf
