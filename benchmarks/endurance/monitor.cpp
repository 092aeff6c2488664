// SPDX-License-Identifier: BSD-3-Clause
#include "endurance/monitor.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace vdamf::endurance
{
namespace
{
constexpr double kSame = 1e-9;     // m
constexpr double kAlike = 1e-3;    // m
constexpr double kNoneNear = 1e3;  // m

double residentMegabytes()
{
    std::ifstream file("/proc/self/statm");
    double all = 0.0;
    double resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}
}  // namespace

Monitor::Monitor(const Plan& plan, const Rounds& rounds, std::function<void(const Row&)> onRow)
    : plan_(plan), rounds_(rounds), onRow_(std::move(onRow)), begin_(std::clock())
{
}

void Monitor::add(const FrameResult& frame)
{
    const double since = frame.time - rounds_.begin();
    const auto round = static_cast<std::uint64_t>((since + 1e-3) / rounds_.period());
    if (round != round_) newestBefore_ = newest_;
    round_ = round;
    ++row_.frames;
    noteIdentities(frame);
    compare(frame);
    const double rowLength = plan_.hours * 3600.0 / plan_.rows;
    if (since >= rowLength * static_cast<double>(result_.rows.size() + 1)) endRow(frame.time);
}

void Monitor::noteIdentities(const FrameResult& frame)
{
    for (const TrackReport& track : frame.tracks)
    {
        if (track.id > newest_)
        {
            newest_ = track.id;
            living_.insert(track.id);
            ++result_.tracks;
        }
        else if (living_.count(track.id) == 0)
            ++result_.reused;
        if (track.status == TrackStatus::Confirmed && confirmed_.insert(track.id).second)
            ++result_.confirmed;
        if (track.status != TrackStatus::Ended) continue;
        living_.erase(track.id);
        confirmed_.erase(track.id);
    }
}

void Monitor::compare(const FrameResult& frame)
{
    const double begin = rounds_.begin() + static_cast<double>(round_) * rounds_.period();
    Places& first = first_[std::round((frame.time - begin) * 1e3)];
    for (const TrackReport& track : frame.tracks)
    {
        // Those of the round before end in the first frame of this one.
        if (track.id <= newestBefore_) continue;
        const double x = track.box.x - rounds_.eastOf(round_);
        const double y = track.box.y - rounds_.northOf(round_);
        if (round_ == 0)
        {
            first.emplace_back(x, y);
            continue;
        }
        double nearest = kNoneNear;
        for (const auto& [firstX, firstY] : first)
            nearest = std::min(nearest, std::hypot(x - firstX, y - firstY));
        ++compared_;
        same_ += nearest < kSame ? 1 : 0;
        alike_ += nearest < kAlike ? 1 : 0;
    }
}

void Monitor::endRow(double time)
{
    const std::clock_t now = std::clock();
    row_.hours = (time - rounds_.begin()) / 3600.0;
    row_.kilometres = std::hypot(rounds_.eastOf(round_), rounds_.northOf(round_)) / 1e3;
    row_.milliseconds =
        1e3 * static_cast<double>(now - begin_) / CLOCKS_PER_SEC / static_cast<double>(row_.frames);
    const auto share = [this](std::uint64_t count)
    { return compared_ == 0 ? 1.0 : static_cast<double>(count) / static_cast<double>(compared_); };
    row_.same = share(same_);
    row_.alike = share(alike_);
    compared_ = same_ = alike_ = 0;
    row_.megabytes = residentMegabytes();
    result_.rows.push_back(row_);
    if (onRow_) onRow_(row_);
    row_ = {};
    begin_ = std::clock();
}

Result Monitor::result()
{
    result_.rounds = round_ + 1;
    return result_;
}

}  // namespace vdamf::endurance
