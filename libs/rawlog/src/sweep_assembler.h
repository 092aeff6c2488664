// SPDX-License-Identifier: BSD-3-Clause
// Packets of one Velodyne sensor to revolutions, on one clock.
#pragma once

#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cstdint>
#include <optional>

#include "vdamf/rawlog/velodyne_capture.h"

namespace vdamf
{
/// The sensor's clock (microseconds of the hour) put beside that of the capture. It follows the
/// sensor's, which does not jitter, from the first packet on; where the two part by more than a
/// second (a sensor that starts anew, a pause), it starts again from the capture's.
class SensorClock
{
public:
    double timeOf(const VelodynePacket& packet);  ///< s (UNIX)
    /// The time at which the sensor's clock showed so many seconds since the hour, near to another
    /// time.
    double timeAt(double secondsOfHour, double near) const;
    std::uint64_t restarts() const { return restarts_; }

private:
    std::optional<double> offset_;  // of the capture's clock before the sensor's seconds of hour
    double last_ = 0.0;
    std::uint64_t restarts_ = 0;
};

class SweepAssembler
{
public:
    /// A sweep begins with the first packet at or behind the cut, deg (clockwise, 0 forward).
    explicit SweepAssembler(double cutAzimuth) : cut_(cutAzimuth) {}

    /// The sweep that ends where this packet begins, if it does.
    std::optional<mrpt::obs::CObservationVelodyneScan> add(const VelodynePacket& packet,
                                                           double time);
    /// What is left at the end.
    std::optional<mrpt::obs::CObservationVelodyneScan> finish();

private:
    double behindCut(const VelodynePacket& packet) const;

    double cut_ = 0.0;
    double lastBehindCut_ = 0.0;
    double lastTime_ = 0.0;
    std::optional<mrpt::obs::CObservationVelodyneScan> sweep_;
};

}  // namespace vdamf
