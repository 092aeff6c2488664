// SPDX-License-Identifier: BSD-3-Clause
// Entries of a rawlog on their way from the reader to the tracker and the output.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
/// A scan observation inside an entry (the entry itself, or in its sensory frame).
struct PendingScan
{
    mrpt::obs::CObservation::Ptr observation;
    double time = 0.0;  ///< s (UNIX)
    bool done = false;
    /// Serialised annotations, once tracked.
    std::string annotations;
};

struct PendingEntry
{
    RawlogEntry entry;
    std::vector<PendingScan> scans;
};

/// Entries in file order, read ahead until the poses reach their scans, so that a scan can be
/// placed between two poses and scans that stand out of order in the file can be sorted.
class PendingEntries
{
public:
    PendingEntries(RawlogReader& reader, InsTrajectory& ins, std::string scanLabel);

    /// Reads until the first entry's scans have their poses, or will not get them; false at the
    /// end of the rawlog.
    bool prepareFirst();
    /// Reads until an entry with scans is there and its scans have their poses, or will not get
    /// them; nothing if the look-ahead or the rawlog ends before.
    PendingScan* prepareFirstScan();
    PendingEntry& first() { return entries_.front(); }
    PendingEntry popFirst();

    /// The earliest scan that is not done among all entries read that is no later than `time`.
    PendingScan* earliestScanUntil(double time);

private:
    bool readOne();
    bool mayReadAhead() const;
    bool waitsForPose(const PendingEntry& entry) const;

    RawlogReader& reader_;
    InsTrajectory& ins_;
    std::string scanLabel_;
    std::deque<PendingEntry> entries_;
    std::size_t bytes_ = 0;
    double latestTime_ = 0.0;  ///< of the entry read last
    bool atEnd_ = false;
};

}  // namespace vdamf
