// SPDX-License-Identifier: BSD-3-Clause
// Reads the fields of a Velodyne data packet. MRPT's accessors bind references to fields that are
// not aligned, which is undefined behaviour; here bytes are put together one by one.
#pragma once

#include <cstdint>

#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
class VelodynePacketView
{
public:
    explicit VelodynePacketView(const VelodyneScan::TVelodyneRawPacket& packet)
        : bytes_(reinterpret_cast<const std::uint8_t*>(&packet))
    {
    }

    std::uint16_t header(int block) const { return at16(block * VelodyneScan::SIZE_BLOCK); }
    /// Hundredths of a degree.
    std::uint16_t azimuth(int block) const { return at16(block * VelodyneScan::SIZE_BLOCK + 2); }
    /// Units of 2 mm; 0: no return.
    std::uint16_t distance(int block, int i) const { return at16(returnAt(block, i)); }
    std::uint8_t intensity(int block, int i) const { return bytes_[returnAt(block, i) + 2]; }
    /// Microseconds since the hour.
    std::uint32_t stamp() const
    {
        return at16(kTail) | static_cast<std::uint32_t>(at16(kTail + 2)) << 16;
    }
    std::uint8_t returnMode() const { return bytes_[kTail + 4]; }
    std::uint8_t model() const { return bytes_[kTail + 5]; }

private:
    static constexpr int kTail = VelodyneScan::BLOCKS_PER_PACKET * VelodyneScan::SIZE_BLOCK;

    static int returnAt(int block, int i)
    {
        return block * VelodyneScan::SIZE_BLOCK + 4 + VelodyneScan::RAW_SCAN_SIZE * i;
    }
    std::uint16_t at16(int offset) const
    {
        return static_cast<std::uint16_t>(bytes_[offset] | bytes_[offset + 1] << 8);
    }

    const std::uint8_t* bytes_;
};

}  // namespace vdamf
