// SPDX-License-Identifier: BSD-3-Clause
// Entries of a rawlog on their way from the reader to the tracker and the output.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
/// A scan observation inside an entry (the entry itself, or in its sensory frame).
struct PendingScan
{
    mrpt::obs::CObservation::Ptr observation;
    double time = 0.0;   ///< s (UNIX)
    double until = 0.0;  ///< time up to which its frame asks for poses, s (UNIX)
    bool done = false;
    /// Serialised annotations, once tracked.
    std::string annotations;
};

struct PendingEntry
{
    RawlogEntry entry;
    std::vector<PendingScan> scans;
    std::uint64_t unstamped = 0;  ///< scans without a time stamp, which are not among `scans`
    std::optional<double> time;   ///< of what was observed last in it, s (UNIX)
    bool ofEarlierRun = false;    ///< a head, an annotation or a scene: not handed on
};

/// Entries in file order, read ahead until the poses reach their scans, so that a scan can be
/// placed between two poses, and at least a fixed time, so that scans that stand slightly out of
/// order in the file can be sorted.
class PendingEntries
{
public:
    PendingEntries(RawlogReader& reader, InsTrajectory& ins, ScanOptions options);

    /// Reads until the first entry's scans have their poses, or will not get them, and earlier
    /// scans behind them; false at the end of the rawlog.
    bool prepareFirst();
    PendingEntry& first() { return entries_.front(); }
    PendingEntry popFirst();

    /// The earliest scan that is not done among all entries read that is no later than `time`.
    PendingScan* earliestScanUntil(double time);
    /// The scans that become one frame with this one, which is not done: of each other sensor the
    /// earliest in the time that scans are merged in.
    std::vector<PendingScan*> partnersOf(const PendingScan& scan);
    /// Why the rawlog could not be read on; empty: it could. The entries before are as always.
    const std::string& readError() const { return readError_; }
    /// Of all scans, those that do not count too, the first eight.
    const std::vector<std::string>& scanLabels() const { return scanLabels_; }
    /// True where an entry has annotations that are not written yet.
    bool holdsAnnotations() const;

private:
    std::optional<RawlogEntry> nextEntry();
    bool readOne();
    bool isOfEarlierRun(const mrpt::obs::CObservation& observation);
    bool counts(const mrpt::obs::CObservation& observation);
    void dropMinorScans();
    PendingScan pendingScan(const mrpt::obs::CObservation::Ptr& observation, double time) const;
    bool mayReadAhead() const;
    bool waits(const PendingEntry& entry) const;
    bool isReadPast(double time) const;

    RawlogReader& reader_;
    InsTrajectory& ins_;
    ScanOptions options_;
    bool minorCount_ = true;
    bool hasHead_ = false;  // of an earlier run
    std::deque<PendingEntry> entries_;
    std::size_t bytes_ = 0;
    bool atEnd_ = false;
    std::string readError_;
    std::vector<std::string> scanLabels_;
};

}  // namespace vdamf
