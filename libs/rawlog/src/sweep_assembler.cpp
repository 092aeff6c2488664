// SPDX-License-Identifier: BSD-3-Clause
#include "sweep_assembler.h"

#include <mrpt/core/Clock.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace vdamf
{
namespace
{
constexpr double kHour = 3600.0;

/// The value that differs from `value` by whole hours and is nearest to `near`.
double nearestHour(double value, double near)
{
    return value + kHour * std::round((near - value) / kHour);
}
}  // namespace

double SensorClock::timeOf(const VelodynePacket& packet)
{
    constexpr double kApart = 1.0;
    const double ofHour = 1e-6 * packet.stamp();
    if (offset_)
    {
        const double time = nearestHour(*offset_ + ofHour, packet.time);
        if (std::abs(time - packet.time) <= kApart) return last_ = time;
        ++restarts_;
    }
    offset_ = packet.time - ofHour;
    return last_ = packet.time;
}

double SensorClock::timeAt(double secondsOfHour, double near) const
{
    return offset_ ? nearestHour(*offset_ + secondsOfHour, near) : near;
}

double SweepAssembler::behindCut(const VelodynePacket& packet) const
{
    const double azimuth = 0.01 * packet.azimuth() - cut_;
    return azimuth - 360.0 * std::floor(azimuth / 360.0);
}

std::optional<mrpt::obs::CObservationVelodyneScan> SweepAssembler::add(const VelodynePacket& packet,
                                                                       double time)
{
    constexpr double kTurnedBack = 10.0;        // deg; less is jitter of a standing mirror
    constexpr double kPause = 0.2;              // s
    constexpr std::size_t kMostPackets = 4000;  // of a sensor that does not turn
    const double behind = behindCut(packet);
    const bool begins = !sweep_ || behind < lastBehindCut_ - kTurnedBack ||
                        std::abs(time - lastTime_) > kPause ||
                        sweep_->scan_packets.size() >= kMostPackets;
    std::optional<mrpt::obs::CObservationVelodyneScan> ended;
    if (begins)
    {
        ended = finish();
        sweep_.emplace();
        sweep_->timestamp = mrpt::Clock::fromDouble(time);
        sweep_->originalReceivedTimestamp = mrpt::Clock::fromDouble(packet.time);
    }
    mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket raw;
    std::memcpy(&raw, packet.bytes.data(), std::min(sizeof(raw), packet.bytes.size()));
    sweep_->scan_packets.push_back(raw);
    lastBehindCut_ = behind;
    lastTime_ = time;
    return ended;
}

std::optional<mrpt::obs::CObservationVelodyneScan> SweepAssembler::finish()
{
    return std::exchange(sweep_, std::nullopt);
}

}  // namespace vdamf
