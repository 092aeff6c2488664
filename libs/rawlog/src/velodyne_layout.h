// SPDX-License-Identifier: BSD-3-Clause
// How the returns of a Velodyne data packet lie in time.
#pragma once

#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
constexpr int kBlocksPerPacket = 12;
constexpr int kReturnsPerBlock = 32;
constexpr int kUnitsPerTurn = 36000;      // of an azimuth
constexpr double kMetresPerUnit = 0.002;  // of a return's distance

/// Times from the manuals. A firing is one shot of every laser; the HDL-64E's two blocks of lasers
/// fire side by side and fill one block of the packet each.
struct VelodyneLayout
{
    int lasers = 0;
    int firingsPerBlock = 1;    ///< firings that share a block of the packet
    int blocksPerFiring = 1;    ///< blocks of the packet that share a firing
    double firingPeriod = 0.0;  ///< s
    double laserPeriod = 0.0;   ///< from laser to laser, s

    double blockGroupPeriod() const { return firingPeriod * firingsPerBlock; }

    /// From the begin of the block's first firing to the shot of a return, s.
    double delayInBlock(int returnIndex) const
    {
        const int lasersInBlock = kReturnsPerBlock / firingsPerBlock;
        return firingPeriod * (returnIndex / lasersInBlock) +
               laserPeriod * (returnIndex % lasersInBlock);
    }
};

VelodyneLayout velodyneLayout(VelodyneModel model);

}  // namespace vdamf
