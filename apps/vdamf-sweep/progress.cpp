// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vdamf
{
namespace
{
double bytesOf(const PreparedSweep& sweep, const PlannedRun& run)
{
    return static_cast<double>(sweep.recordings[run.row.recording].bytes);
}
}  // namespace

SweepProgress::SweepProgress(const PreparedSweep& sweep, Style style) : sweep_(sweep), style_(style)
{
    double bytesOfSetting = 0.0;
    for (const SweepRecording& recording : sweep.recordings)
        bytesOfSetting += static_cast<double>(recording.bytes);
    const std::size_t settings = sweep.runs / sweep.recordings.size();
    bytesPlanned_ = bytesOfSetting * static_cast<double>(settings);
}

void SweepProgress::planned(const std::vector<PlannedRun>& runs)
{
    for (const PlannedRun& run : runs)
    {
        if (!run.isDone) continue;
        ++done_;
        ++skipped_;
        bytesSkipped_ += bytesOf(sweep_, run);
    }
}

void SweepProgress::finished(const PlannedRun& run, const std::string& failure)
{
    ++done_;
    failures_ += failure.empty() ? 0 : 1;
    bytesDone_ += bytesOf(sweep_, run);
    if (!failure.empty())
        tell(sweep_.recordings[run.row.recording].name + ", setting " +
             std::to_string(run.row.setting + 1) + " failed: " + failure);
    show(run, failure);
}

void SweepProgress::tell(const std::string& text) const
{
    std::fprintf(stderr, "%s%s\n", style_ == Style::Bar ? "\r\033[K" : "", text.c_str());
}

void SweepProgress::end() const
{
    if (style_ == Style::Bar && done_ > skipped_) std::fprintf(stderr, "\n");
}

std::string SweepProgress::remaining() const
{
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    const double left = bytesPlanned_ - bytesSkipped_ - bytesDone_;
    if (!(bytesDone_ > 0.0) || left <= 0.0) return "";
    return ", about " + durationInWords(passed.count() * left / bytesDone_) + " left";
}

void SweepProgress::show(const PlannedRun& run, const std::string& failure) const
{
    if (style_ == Style::Quiet) return;
    const std::string failed = failures_ > 0 ? ", " + std::to_string(failures_) + " failed" : "";
    if (style_ == Style::Lines)
    {
        if (failure.empty())
            std::fprintf(stderr, "%zu of %zu: %s, setting %zu%s\n", done_, sweep_.runs,
                         sweep_.recordings[run.row.recording].name.c_str(), run.row.setting + 1,
                         remaining().c_str());
        return;
    }
    constexpr int kWidth = 30;
    const double share = static_cast<double>(done_) / static_cast<double>(sweep_.runs);
    const int filled = static_cast<int>(share * kWidth);
    std::fprintf(stderr, "\r\033[K[%.*s%*s] %zu of %zu runs%s%s", filled,
                 "##############################", kWidth - filled, "", done_, sweep_.runs,
                 failed.c_str(), remaining().c_str());
}

std::string durationInWords(double seconds)
{
    const long long whole = std::max(1LL, std::llround(seconds));
    if (whole < 120) return std::to_string(whole) + " s";
    const long long minutes = (whole + 30) / 60;
    if (minutes < 120) return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace vdamf
