// SPDX-License-Identifier: BSD-3-Clause
#include "endurance/rounds.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <cmath>
#include <stdexcept>

#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf::endurance
{
Rounds::Rounds(const std::filesystem::path& rawlog, double pause, double drift) : drift_(drift)
{
    RawlogReader reader(rawlog);
    while (const auto entry = reader.next())
        if (auto one = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object))
            observations_.push_back(std::move(one));
    if (observations_.empty()) throw std::runtime_error(rawlog.string() + ": no observations");
    begin_ = mrpt::Clock::toDouble(observations_.front()->timestamp);
    const double end = mrpt::Clock::toDouble(observations_.back()->timestamp);
    period_ = std::ceil(end - begin_ + pause);
}

double Rounds::eastOf(std::uint64_t round) const
{
    constexpr double kAside = 5000.0;
    return drift_ * static_cast<double>(round) + (round % 2 == 1 ? kAside : 0.0);
}

double Rounds::northOf(std::uint64_t round) const
{
    return drift_ * static_cast<double>(round);
}

std::string Rounds::next()
{
    constexpr double kTicksPerSecond = 1e7;
    const bool first = round_ == 0;
    const mrpt::Clock::duration later(first ? 0 : std::llround(period_ * kTicksPerSecond));
    const double east = first ? 0.0 : eastOf(round_) - eastOf(round_ - 1);
    const double north = first ? 0.0 : northOf(round_) - northOf(round_ - 1);
    std::string bytes;
    for (const auto& observation : observations_)
    {
        observation->timestamp += later;
        if (auto* pose = dynamic_cast<mrpt::obs::CObservationRobotPose*>(observation.get()))
        {
            pose->pose.mean.x_incr(east);
            pose->pose.mean.y_incr(north);
        }
        bytes += serialized(*observation);
    }
    ++round_;
    return bytes;
}

}  // namespace vdamf::endurance
