// SPDX-License-Identifier: BSD-3-Clause
// Simulated scans as what sensors send.
#include "native_scans.h"

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
namespace
{
VelodyneModel velodyneModel(LadarModel model)
{
    switch (model)
    {
        case LadarModel::VLP16:
            return VelodyneModel::VLP16;
        case LadarModel::HDL32E:
            return VelodyneModel::HDL32E;
        case LadarModel::HDL64E:
            return VelodyneModel::HDL64E;
        case LadarModel::LMS291:
        case LadarModel::LMS511:
            break;
    }
    throw std::logic_error("a line scanner has no data packets of Velodyne");
}

std::vector<VelodyneFiring> packetFirings(const std::vector<LadarFiring>& firings)
{
    std::vector<VelodyneFiring> result;
    result.reserve(firings.size());
    for (const LadarFiring& firing : firings)
    {
        VelodyneFiring& packed = result.emplace_back();
        packed.azimuth = firing.azimuth;
        for (const LadarReturn& one : firing.returns)
        {
            packed.range.push_back(static_cast<float>(one.range));
            packed.intensity.push_back(static_cast<float>(one.intensity));
        }
    }
    return result;
}

/// Gives all packets the time of the first: in a world that stood still during the revolution,
/// all returns belong to its begin, and whoever moves them by their times must not.
void stopClock(mrpt::obs::CObservationVelodyneScan& scan)
{
    using Packet = mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket;
    // The stamp is private to the packet; it stands behind the blocks.
    constexpr std::size_t kStampOffset = sizeof(Packet::blocks);
    constexpr std::size_t kStampSize = 4;
    char stamp[kStampSize];
    for (std::size_t i = 0; i < scan.scan_packets.size(); ++i)
    {
        char* bytes = reinterpret_cast<char*>(&scan.scan_packets[i]) + kStampOffset;
        if (i == 0) std::memcpy(stamp, bytes, kStampSize);
        std::memcpy(bytes, stamp, kStampSize);
    }
}

mrpt::obs::CObservation::Ptr velodyneScan(const SimulatedSensor& sensor, const SimulatedScan& scan)
{
    const auto observation = std::make_shared<mrpt::obs::CObservationVelodyneScan>(encodeVelodyne(
        velodyneModel(sensor.options.model), scan.time, packetFirings(scan.firings)));
    observation->minRange = sensor.mount.ladar.minRange;
    observation->maxRange = sensor.mount.ladar.maxRange;
    if (sensor.mount.instantaneous) stopClock(*observation);
    return observation;
}

mrpt::obs::CObservation::Ptr lineScan(const SimulatedSensor& sensor, const SimulatedScan& scan)
{
    const SpinningLadar& ladar = sensor.mount.ladar;
    const auto observation = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
    observation->timestamp = mrpt::Clock::fromDouble(scan.time);
    observation->rightToLeft = true;
    observation->aperture =
        static_cast<float>(ladar.resolution * (static_cast<double>(scan.firings.size()) - 1.0));
    observation->maxRange = static_cast<float>(ladar.maxRange);
    observation->stdError = static_cast<float>(ladar.rangeNoise);
    observation->resizeScanAndAssign(scan.firings.size(), 0.0F, false);
    observation->setScanHasIntensity(true);
    for (std::size_t i = 0; i < scan.firings.size(); ++i)
    {
        const LadarReturn& one = scan.firings[i].returns.front();
        observation->setScanIntensity(i, static_cast<int>(std::lround(255.0 * one.intensity)));
        if (one.range == 0.0) continue;
        observation->setScanRange(i, static_cast<float>(one.range));
        observation->setScanRangeValidity(i, true);
    }
    return observation;
}
}  // namespace

mrpt::obs::CObservation::Ptr nativeScan(const SimulatedSensor& sensor, const SimulatedScan& scan)
{
    return sensor.mount.ladar.isLineScanner() ? lineScan(sensor, scan) : velodyneScan(sensor, scan);
}

}  // namespace vdamf
