// SPDX-License-Identifier: BSD-3-Clause
#include "pending_entries.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <map>

#include "first_labels.h"
#include "vdamf/rawlog/annotation.h"

namespace vdamf
{
namespace
{
constexpr double kLookAhead = 1.0;  // s of entries that a scan waits for a pose
// s of entries that it waits for earlier scans, and for those that it is merged with
constexpr double kSorting = ScanOptions::kLongestMerge;
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

PendingEntries::PendingEntries(RawlogReader& reader, InsTrajectory& ins, ScanOptions options)
    : reader_(reader), ins_(ins), options_(std::move(options))
{
}

// Without a label, minor scans count as long as no other has been met.
bool PendingEntries::counts(const mrpt::obs::CObservation& observation)
{
    if (!isScan(observation)) return false;
    addLabel(scanLabels_, observation.sensorLabel);
    if (!options_.label.empty()) return observation.sensorLabel == options_.label;
    if (isMinorScan(observation)) return minorCount_;
    minorCount_ = false;
    return true;
}

void PendingEntries::dropMinorScans()
{
    for (PendingEntry& entry : entries_)
        for (PendingScan& scan : entry.scans)
            scan.done = scan.done || isMinorScan(*scan.observation);
}

PendingScan PendingEntries::pendingScan(const mrpt::obs::CObservation::Ptr& observation,
                                        double time) const
{
    PendingScan scan;
    scan.observation = observation;
    scan.time = time;
    scan.until = time + options_.merge + (options_.deskew ? durationOf(*observation) : 0.0);
    return scan;
}

std::optional<RawlogEntry> PendingEntries::nextEntry()
{
    try
    {
        return reader_.next();
    }
    catch (const ReadError& error)
    {
        readError_ = error.what();
        return std::nullopt;
    }
}

bool PendingEntries::isOfEarlierRun(const mrpt::obs::CObservation& observation)
{
    const bool isFirst = isHead(observation);
    hasHead_ = hasHead_ || isFirst;
    return isFirst || isAnnotation(observation) || (hasHead_ && isScene(observation));
}

bool PendingEntries::readOne()
{
    std::optional<RawlogEntry> entry = nextEntry();
    if (!entry)
    {
        atEnd_ = true;
        return false;
    }
    const bool minorCounted = minorCount_;
    PendingEntry pending;
    pending.entry = std::move(*entry);
    if (pending.entry.movement) ins_.insert(*pending.entry.movement);
    for (const auto& observation : observationsOf(pending.entry))
    {
        pending.ofEarlierRun = observation == pending.entry.object && isOfEarlierRun(*observation);
        if (isAnnotation(*observation)) continue;
        ins_.insert(*observation);
        const bool stamped = observation->timestamp != INVALID_TIMESTAMP;
        const double time = stamped ? mrpt::Clock::toDouble(observation->timestamp) : 0.0;
        if (stamped) pending.time = std::max(time, pending.time.value_or(time));
        if (!counts(*observation)) continue;
        if (stamped)
            pending.scans.push_back(pendingScan(observation, time));
        else
            ++pending.unstamped;
    }
    // The scans keep what is needed of the object; the bytes serve for the copy.
    pending.entry.object.reset();
    if (pending.entry.kind == RawlogEntry::Kind::Damaged || pending.ofEarlierRun)
        std::string().swap(pending.entry.bytes);
    bytes_ += pending.entry.bytes.size();
    entries_.push_back(std::move(pending));
    if (minorCounted && !minorCount_) dropMinorScans();
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
    return std::any_of(
        entry.scans.begin(), entry.scans.end(),
        [this](const PendingScan& scan)
        {
            if (scan.done) return false;
            return !isReadPast(scan.time + kSorting) ||
                   (!ins_.covers(scan.until) && !isReadPast(scan.until + kLookAhead));
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

std::vector<PendingScan*> PendingEntries::partnersOf(const PendingScan& scan)
{
    std::map<std::string, PendingScan*> earliest;  // by sensor
    if (options_.merge <= 0.0) return {};
    for (PendingEntry& entry : entries_)
        for (PendingScan& other : entry.scans)
        {
            const std::string& label = other.observation->sensorLabel;
            if (other.done || other.time < scan.time || other.time > scan.time + options_.merge ||
                label == scan.observation->sensorLabel)
                continue;
            PendingScan*& first = earliest[label];
            if (first == nullptr || other.time < first->time) first = &other;
        }
    std::vector<PendingScan*> partners;
    for (const auto& [label, partner] : earliest) partners.push_back(partner);
    return partners;
}

bool PendingEntries::holdsAnnotations() const
{
    const auto annotated = [](const PendingScan& scan) { return !scan.annotations.empty(); };
    return std::any_of(entries_.begin(), entries_.end(),
                       [&](const PendingEntry& entry)
                       { return std::any_of(entry.scans.begin(), entry.scans.end(), annotated); });
}

}  // namespace vdamf
