// SPDX-License-Identifier: BSD-3-Clause
// A network capture of a Velodyne sensor: pcap or pcapng.
#include "memory_file.h"
#include "require.h"
#include "vdamf/rawlog/velodyne_capture.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace vdamf;
    const fuzz::MemoryFile file(fuzz::textOf(data, size));
    fuzz::mayRefuse(
        [&]
        {
            VelodyneCapture capture(file.path());
            while (const auto packet = capture.next())
            {
                const bool isData = packet->kind == VelodynePacket::Kind::Data;
                constexpr std::size_t kData = 1206;
                constexpr std::size_t kPosition = 512;
                fuzz::require(packet->bytes.size() == (isData ? kData : kPosition),
                              "a packet has the size of its kind");
                packet->stamp();
                if (isData) packet->azimuth();
            }
            const CaptureSummary& summary = capture.summary();
            fuzz::require(
                summary.data + summary.positions + summary.cut + summary.other <= summary.packets,
                "packets are counted once");
        });
    return 0;
}
