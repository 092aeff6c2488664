// SPDX-License-Identifier: BSD-3-Clause
// Velodyne packets: the first byte chooses the sensor and what is known of it, the rest is packets.
#include <algorithm>
#include <cstring>

#include "require.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace
{
using namespace vdamf;
using Scan = mrpt::obs::CObservationVelodyneScan;
using Packet = Scan::TVelodyneRawPacket;

Scan scanOf(const std::uint8_t* data, std::size_t size)
{
    static const VelodyneModel kModels[] = {VelodyneModel::VLP16, VelodyneModel::HDL32E,
                                            VelodyneModel::HDL64E};
    // For the ranges and the calibration that go with the sensor.
    Scan scan = encodeVelodyne(kModels[data[0] % 3], 1.5e9, {});
    scan.scan_packets.assign((size - 1 + sizeof(Packet) - 1) / sizeof(Packet), Packet{});
    if (size > 1) std::memcpy(scan.scan_packets.data(), data + 1, size - 1);
    return scan;
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0) return 0;
    const Scan scan = scanOf(data, size);
    const double duration = durationOf(scan);
    fuzz::require(duration >= 0.0 && duration <= 1.0, "a scan lasts at most a second");
    fuzz::mayRefuse(
        [&]
        {
            const PointCloud cloud = decodeVelodyne(scan);
            constexpr std::size_t kReturns = 12 * 32;
            fuzz::require(cloud.size() <= kReturns * scan.scan_packets.size(),
                          "a packet has at most 384 returns");
            fuzz::require(cloud.y.size() == cloud.size() && cloud.z.size() == cloud.size(),
                          "coordinates are equal in number");
            fuzz::require(scan.scan_packets.empty() || (cloud.time.size() == cloud.size() &&
                                                        cloud.intensity.size() == cloud.size()),
                          "each return has an intensity and a time");
        });
    return 0;
}
