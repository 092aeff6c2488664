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
constexpr double kLookAhead = 1.0;  // s of entries that a scan waits for a pose
constexpr double kSorting = 0.2;    // s of entries that it waits for earlier scans
// It waits for no more than so many bytes and entries, whatever their stamps say.
constexpr std::size_t kLookAheadBytes = 256U << 20U;
constexpr std::size_t kLookAheadEntries = 10000;
// A stamp farther ahead of a scan is a fault of its entry and ends no waiting, unless so many have
// come that the recording has a gap, or the scan itself the faulty stamp.
constexpr double kPlausible = 600.0;  // s
constexpr int kManyFarAhead = 100;

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
    PendingEntry pending;
    pending.entry = std::move(*entry);
    for (const auto& observation : observationsOf(pending.entry))
    {
        if (isAnnotation(*observation)) continue;
        ins_.insert(*observation);
        const bool stamped = observation->timestamp != INVALID_TIMESTAMP;
        const double time = stamped ? mrpt::Clock::toDouble(observation->timestamp) : 0.0;
        if (stamped) pending.time = std::max(time, pending.time.value_or(time));
        if (!isScan(*observation)) continue;
        if (!scanLabel_.empty() && observation->sensorLabel != scanLabel_) continue;
        if (stamped)
            pending.scans.push_back({observation, time, false, {}});
        else
            ++pending.unstamped;
    }
    // The scans keep what is needed of the object; the bytes serve for the copy.
    pending.entry.object.reset();
    bytes_ += pending.entry.bytes.size();
    entries_.push_back(std::move(pending));
    return true;
}

bool PendingEntries::mayReadAhead() const
{
    return !atEnd_ && bytes_ < kLookAheadBytes && entries_.size() < kLookAheadEntries;
}

bool PendingEntries::isReadPast(double time) const
{
    int farAhead = 0;
    for (const PendingEntry& entry : entries_)
    {
        if (!entry.time || *entry.time < time) continue;
        if (*entry.time <= time + kPlausible || ++farAhead >= kManyFarAhead) return true;
    }
    return false;
}

bool PendingEntries::waits(const PendingEntry& entry) const
{
    return std::any_of(entry.scans.begin(), entry.scans.end(),
                       [this](const PendingScan& scan)
                       {
                           if (scan.done) return false;
                           return !isReadPast(scan.time + kSorting) ||
                                  (!ins_.covers(scan.time) && !isReadPast(scan.time + kLookAhead));
                       });
}

bool PendingEntries::prepareFirst()
{
    if (entries_.empty() && !readOne()) return false;
    while (mayReadAhead() && waits(entries_.front())) readOne();
    return true;
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

bool PendingEntries::holdsAnnotations() const
{
    const auto annotated = [](const PendingScan& scan) { return !scan.annotations.empty(); };
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const PendingEntry& entry)
                       { return std::any_of(entry.scans.begin(), entry.scans.end(), annotated); });
}

}  // namespace vdamf
