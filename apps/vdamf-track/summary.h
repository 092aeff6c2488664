// SPDX-License-Identifier: BSD-3-Clause
// What vdamf-track says at the end of a run.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "vdamf/rawlog/track_rawlog.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
inline std::string joinedInQuotes(const std::vector<std::string>& names)
{
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "'" : ", '") + name + "'";
    return all;
}

/// On stderr what happened at least once.
inline void warnOfCount(std::uint64_t count, const std::string& what, const std::string& input)
{
    if (count > 0)
        std::fprintf(stderr, "%s: %llu %s\n", input.c_str(), static_cast<unsigned long long>(count),
                     what.c_str());
}

/// What is wrong with the poses, on stderr.
inline void warnOfPoses(const TrackRawlogSummary& s, const std::string& input)
{
    constexpr double kDoubtful = 20.0;  // deg
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    if (s.ins.gaps > 0)
        std::fprintf(stderr,
                     "%s: %llu times without poses, the longest %.2f s, the first after %.3f s "
                     "(UNIX)\n",
                     input.c_str(), number(s.ins.gaps), s.ins.longestGap, s.ins.firstGapAt);
    if (s.ins.timeJumps > 0)
        std::fprintf(stderr, "%s: the clock of the poses goes back %llu times\n", input.c_str(),
                     number(s.ins.timeJumps));
    const double turned = s.ins.imuLessCourse.value_or(0.0) / kDegree;
    if (std::abs(turned) > kDoubtful)
        std::fprintf(stderr,
                     "%s: the heading of the IMU is %.0f degrees from the course: set [ins] "
                     "imu_yaw_offset_deg, or gps_heading = course\n",
                     input.c_str(), turned);
}

/// "692 read, 3 unknown, 2 damaged".
inline std::string entriesText(const RawlogSummary& read)
{
    const auto count = [](std::uint64_t n, const char* what)
    { return n > 0 ? ", " + std::to_string(n) + " " + what : std::string(); };
    return std::to_string(read.objects) + " read" + count(read.unknown, "of unknown classes") +
           count(read.damaged, "damaged") + count(read.nulls, "empty") +
           (read.truncated ? ", cut short" : "");
}

/// "CObservationRobotPose 'ins', 1042 samples, 3 out of order, 2 of one time".
inline std::string posesText(const TrackRawlogSummary& s)
{
    const auto count = [](std::uint64_t n, const char* what)
    { return n > 0 ? ", " + std::to_string(n) + " " + what : std::string(); };
    return s.insSource + count(s.ins.taken, "samples") + count(s.ins.outOfOrder, "out of order") +
           count(s.ins.duplicates, "of a time that was there") +
           count(s.ins.impossible, "impossible ones left out");
}

/// "in 157 frames by what stands, up to 0.43 m and 0.9 deg".
inline std::string correctionText(const TrackRawlogSummary& s)
{
    char most[64];
    std::snprintf(most, sizeof most, "%.2f m and %.1f deg", s.mostShifted, s.mostTurned / kDegree);
    return "in " + std::to_string(s.aligned) + " frames by what stands, up to " + most;
}

/// What is wrong with the times of the scans, on stderr.
inline void warnOfTimes(const TrackRawlogSummary& s, const std::string& input)
{
    std::string why;
    if (s.sensors.size() > 1)
        why = "; they come from the sensors " + joinedInQuotes(s.sensors) +
              ": set [scan] label to the one to track on, or merge_s to track on all as one";
    else if (s.atOneTime > 0)
        why = "; all have the label " + joinedInQuotes(s.sensors) +
              ": if they come from several sensors, give each its own";
    warnOfCount(s.outOfOrder, "scans skipped: earlier than the frame before" + why, input);
    warnOfCount(s.atOneTime, "scans skipped: at the time of the frame before" + why, input);
}

/// What was met among the entries besides those that can be read, on stderr.
inline void warnOfEntries(const RawlogSummary& read, const std::string& input)
{
    const auto entries = [](std::uint64_t count)
    { return count == 1 ? std::string("entry") : std::string("entries"); };
    warnOfCount(read.unknown, entries(read.unknown) + " of unknown classes, left as they are",
                input);
    warnOfCount(read.damaged, "damaged " + entries(read.damaged) + " left out", input);
    for (const std::string& problem : read.problems)
        std::fprintf(stderr, "  %s\n", problem.c_str());
    const std::uint64_t more = read.unknown + read.damaged - read.problems.size();
    if (more > 0) std::fprintf(stderr, "  and %llu more\n", static_cast<unsigned long long>(more));
}

/// What was skipped or left out, on stderr.
inline void warn(const TrackRawlogSummary& s, const std::string& input)
{
    const auto line = [&](std::uint64_t count, const std::string& what)
    { warnOfCount(count, what, input); };
    line(s.withoutPose, "scans skipped: no INS pose at their time");
    line(s.poseTooLate,
         "of them have one later in the rawlog: a scan waits for its pose for one second of "
         "entries");
    warnOfTimes(s, input);
    line(s.unstamped, "scans skipped: without a time stamp");
    line(s.unreadable, "scans skipped: " + s.firstUnreadable);
    line(s.withoutHits,
         "scans without a hit: all they hold is not finite, or at the sensor's origin");
    line(s.partlyDeskewed,
         "scans with hits at whose time there is no INS pose: these are placed by the pose nearest "
         "in time");
    line(s.ofEarlierRun, "entries of an earlier run (its head, tracks and scenes) left out");
    warnOfEntries(s.read, input);
    warnOfPoses(s, input);
}

inline void printConsistency(std::FILE* to, const NisReport& nis)
{
    const Consistency& all = nis.all;
    if (all.count == 0) return;
    std::fprintf(to, "  %-18s %s\n", "NIS of updates", inWords(all).c_str());
    std::fprintf(to, "  %-18s %.2f of 1 (95 %% band %.2f to %.2f) over %zu updates\n", "  mean",
                 all.mean, all.lowerBound, all.upperBound, all.count);
    std::fprintf(to, "  %-18s %.0f, %.0f, %.0f %% of the updates (expected 68, 95, 99)\n",
                 "  inside", 100.0 * all.within68, 100.0 * all.within95, 100.0 * all.within99);
    const auto count = [&](Verdict verdict)
    { return static_cast<unsigned long long>(nis.verdicts[static_cast<std::size_t>(verdict)]); };
    std::fprintf(
        to,
        "  %-18s %llu consistent, %llu over-, %llu underconfident, %llu heavy-tailed, %llu with "
        "too few updates\n",
        "  tracks", count(Verdict::Consistent), count(Verdict::Overconfident),
        count(Verdict::Underconfident), count(Verdict::HeavyTailed), count(Verdict::TooFew));
    constexpr std::size_t kWorstShown = 3;
    const char* title = "  worst";
    for (std::size_t k = 0; k < std::min(kWorstShown, nis.worst.size()); ++k)
    {
        const TrackNis& track = nis.worst[k];
        std::fprintf(to, "  %-18s track %llu: mean %.2f over %zu updates, %s\n", title,
                     static_cast<unsigned long long>(track.trackId), track.nis.mean,
                     track.nis.count, verdictName(track.verdict));
        title = "";
    }
}

inline void printTimes(std::FILE* to, const TrackRawlogSummary& s)
{
    const auto perFrame = [&](double seconds)
    { return 1e3 * seconds / static_cast<double>(s.frames); };
    const auto ms = [&](const char* name, double seconds)
    { std::fprintf(to, "  %-18s %8.2f ms\n", name, perFrame(seconds)); };
    std::fprintf(to, "\n  per frame\n");
    ms("reading", s.readSeconds);
    ms("to world frame", s.frameSeconds);
    double tracking = s.frameSeconds;
    for (std::size_t k = 0; k < s.stageSeconds.size(); ++k)
    {
        ms(toString(static_cast<Stage>(k)), s.stageSeconds[k]);
        tracking += s.stageSeconds[k];
    }
    ms("writing", s.writeSeconds);
    ms("tracking, all", tracking);
}

inline void printSummary(std::FILE* to, const TrackRawlogSummary& s)
{
    const auto row = [to](const char* name, const std::string& value)
    { std::fprintf(to, "  %-18s %s\n", name, value.c_str()); };
    std::fprintf(to, "\n");
    row("frames", std::to_string(s.frames) + " of " + std::to_string(s.scans) + " scans" +
                      (s.merged > 0 ? ", " + std::to_string(s.merged) + " merged" : ""));
    row("objects confirmed", std::to_string(s.tracksConfirmed));
    row("INS poses", posesText(s));
    if (s.aligned > 0) row("  corrected", correctionText(s));
    row("entries", entriesText(s.read));
    printConsistency(to, s.nis);
    if (s.frames > 0) printTimes(to, s);
}

}  // namespace vdamf
