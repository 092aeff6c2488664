// SPDX-License-Identifier: BSD-3-Clause
#include "pending_entries.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>

#include "vdamf/rawlog/annotation.h"

namespace vdamf
{
namespace
{
constexpr double kLookAhead = 1.0;                    // s of entries that a scan waits for a pose
constexpr double kPlausible = 600.0;                  // s
constexpr std::size_t kLookAheadBytes = 256U << 20U;  // and bytes

// Observations of an entry: itself, or those of its sensory frame.
std::vector<mrpt::obs::CObservation::Ptr> observationsOf(const RawlogEntry& entry)
{
    std::vector<mrpt::obs::CObservation::Ptr> all;
    if (auto one = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry.object))
        all.push_back(one);
    else if (auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry.object))
    {
        for (const auto& observation : *frame)
            if (observation) all.push_back(observation);
    }
    return all;
}
}  // namespace

PendingEntries::PendingEntries(RawlogReader& reader, InsTrajectory& ins, std::string scanLabel)
    : reader_(reader), ins_(ins), scanLabel_(std::move(scanLabel))
{
}

bool PendingEntries::readOne()
{
    std::optional<RawlogEntry> entry = reader_.next();
    if (!entry)
    {
        atEnd_ = true;
        return false;
    }
    PendingEntry pending{std::move(*entry), {}};
    for (const auto& observation : observationsOf(pending.entry))
    {
        if (isAnnotation(*observation)) continue;
        ins_.insert(*observation);
        const bool stamped = observation->timestamp != INVALID_TIMESTAMP;
        const double time = stamped ? mrpt::Clock::toDouble(observation->timestamp) : 0.0;
        if (stamped) latestTime_ = time;
        if (!isScan(*observation)) continue;
        if (!scanLabel_.empty() && observation->sensorLabel != scanLabel_) continue;
        pending.scans.push_back({observation, time, false, {}});
    }
    // The scans keep what is needed of the object; the bytes serve for the copy.
    pending.entry.object.reset();
    bytes_ += pending.entry.bytes.size();
    entries_.push_back(std::move(pending));
    return true;
}

bool PendingEntries::mayReadAhead() const
{
    return !atEnd_ && bytes_ < kLookAheadBytes;
}

bool PendingEntries::waitsForPose(const PendingEntry& entry) const
{
    return std::any_of(entry.scans.begin(), entry.scans.end(),
                       [this](const PendingScan& scan)
                       {
                           // A stamp far off the scan's is a fault of its entry and ends no
                           // waiting.
                           const double ahead = latestTime_ - scan.time;
                           return !scan.done && !ins_.covers(scan.time) &&
                                  (ahead < kLookAhead || ahead > kPlausible);
                       });
}

bool PendingEntries::prepareFirst()
{
    if (entries_.empty() && !readOne()) return false;
    while (mayReadAhead() && waitsForPose(entries_.front())) readOne();
    return true;
}

PendingScan* PendingEntries::prepareFirstScan()
{
    while (mayReadAhead() && (entries_.empty() || entries_.back().scans.empty())) readOne();
    if (entries_.empty() || entries_.back().scans.empty()) return nullptr;
    const std::size_t first = entries_.size() - 1;
    while (mayReadAhead() && waitsForPose(entries_[first])) readOne();
    return &entries_[first].scans.front();
}

PendingEntry PendingEntries::popFirst()
{
    PendingEntry entry = std::move(entries_.front());
    entries_.pop_front();
    bytes_ -= entry.entry.bytes.size();
    return entry;
}

PendingScan* PendingEntries::earliestScanUntil(double time)
{
    PendingScan* earliest = nullptr;
    for (PendingEntry& entry : entries_)
        for (PendingScan& scan : entry.scans)
            if (!scan.done && scan.time <= time &&
                (earliest == nullptr || scan.time < earliest->time))
                earliest = &scan;
    return earliest;
}

}  // namespace vdamf
