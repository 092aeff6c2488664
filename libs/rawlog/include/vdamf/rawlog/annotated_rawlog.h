// SPDX-License-Identifier: BSD-3-Clause
// Reads back what vdamf-track wrote: the scans of an annotated rawlog with the tracks behind them.
#pragma once

#include <mrpt/core/Clock.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// The annotations of a rawlog, without its scans.
struct Annotations
{
    // Of the head, as text; empty where it does not say.
    std::string version;    ///< of the program that tracked
    std::string origin;     ///< of the world
    std::string insSource;  ///< what gave the poses
    Configuration configuration;
    /// Why the configuration is not that of the run but the built-in one; empty: it is that of the
    /// run.
    std::string configurationProblem;
    /// Tracks by the time stamp of their scan; of several tables of one time the first one.
    std::map<mrpt::Clock::time_point, std::vector<TrackReport>> tables;
    std::uint64_t tablesDamaged = 0;   ///< others that are there, and make no sense
    std::string firstDamaged;          ///< the time of the first one, and why
    std::uint64_t tablesRepeated = 0;  ///< others of a time that was there
    /// From the world of the poses to that of the tracks, where these differ; by time as well.
    std::map<mrpt::Clock::time_point, PlaneMotion> alignments;
    RawlogSummary read;  ///< what was lost of the file
};

/// Reads the head and all tables of tracks. Throws std::runtime_error that names the file and what
/// to do: not readable, no annotations in it, no table that makes sense.
Annotations readAnnotations(const std::filesystem::path& path);

struct ReplaySummary
{
    std::uint64_t frames = 0;         ///< handed on
    std::uint64_t tablesUnused = 0;   ///< without a scan that could be read, or its pose
    std::vector<std::string> labels;  ///< of the sensors, the first eight
    bool interrupted = false;
};

/// Makes the frames that were tracked once more, as trackRawlog() does, and hands each on with its
/// recorded tracks, by rising time. Of the result's counts only `points` is known. Throws
/// std::runtime_error that names the file where none of the tables has its scan.
ReplaySummary replayRawlog(const std::filesystem::path& path, const Annotations& annotations,
                           const std::atomic<bool>& stop, const FrameListener& listener);

}  // namespace vdamf
