// SPDX-License-Identifier: BSD-3-Clause
// Spinning multi-beam LADARs by name. Sources: the user manuals of the VLP-16, HDL-32E and
// HDL-64E S2. Returns come in the order in which the data packets hold them; it is the order of
// firing for the VLP-16 and HDL-32E. The loss of the HDL-64E is that of KITTI's recordings; the
// smaller sensors, with weaker lasers, see asphalt to about 50 m.
#include "vdamf/simulation/spinning_ladar.h"

#include <cmath>
#include <cstddef>

#include "line_scanners.h"

namespace vdamf
{
namespace
{
std::vector<double> delays(std::size_t lasers, double step)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < lasers; ++i) result.push_back(static_cast<double>(i) * step);
    return result;
}

/// -15, 1, -13, 3, ... -1, 15 degrees.
SpinningLadar vlp16()
{
    SpinningLadar ladar;
    for (int i = 0; i < 8; ++i)
    {
        ladar.elevations.push_back((-15.0 + 2.0 * i) * kDegree);
        ladar.elevations.push_back((1.0 + 2.0 * i) * kDegree);
    }
    ladar.laserDelays = delays(16, 2.304e-6);
    ladar.firingPeriod = 55.296e-6;
    ladar.firingsPerPacket = 24;
    ladar.rangeNoise = 0.02;
    ladar.minRange = 0.5;
    ladar.maxRange = 100.0;
    ladar.halfLossStrength = 0.003;
    return ladar;
}

/// -30.67, -9.33, -29.33, -8.00, ... -10.67, 10.67 degrees, as the manual rounds them.
SpinningLadar hdl32e()
{
    SpinningLadar ladar;
    for (int i = 0; i < 16; ++i)
    {
        for (const double start : {-92.0, -28.0})
        {
            const double degrees = (start + 4.0 * i) / 3.0;
            ladar.elevations.push_back(std::round(degrees * 100.0) / 100.0 * kDegree);
        }
    }
    ladar.laserDelays = delays(32, 1.152e-6);
    ladar.firingPeriod = 46.08e-6;
    ladar.firingsPerPacket = 12;
    ladar.rangeNoise = 0.02;
    ladar.minRange = 1.0;
    ladar.maxRange = 100.0;
    ladar.halfLossStrength = 0.003;
    return ladar;
}

/// Upper block 2 to -8.33 degrees, lower block -8.83 to -24.33 degrees, nominal. Each block's 32
/// lasers fire while the other block's do.
SpinningLadar hdl64e()
{
    SpinningLadar ladar;
    for (int i = 0; i < 32; ++i) ladar.elevations.push_back((2.0 - i / 3.0) * kDegree);
    for (int i = 0; i < 32; ++i) ladar.elevations.push_back((-8.83 - i / 2.0) * kDegree);
    const double step = 1.5e-6;
    ladar.laserDelays = delays(32, step);
    const std::vector<double> lower = ladar.laserDelays;
    ladar.laserDelays.insert(ladar.laserDelays.end(), lower.begin(), lower.end());
    ladar.firingPeriod = 48.0e-6;
    ladar.firingsPerPacket = 6;
    ladar.rangeNoise = 0.02;
    ladar.minRange = 0.9;
    ladar.maxRange = 120.0;
    ladar.halfLossStrength = 0.002;
    return ladar;
}
}  // namespace

int SpinningLadar::firingsPerRevolution(double rate) const
{
    const double packetTime = firingsPerPacket * firingPeriod;
    return static_cast<int>(std::floor(1.0 / (rate * packetTime))) * firingsPerPacket;
}

SpinningLadar ladarOf(LadarModel model)
{
    switch (model)
    {
        case LadarModel::VLP16:
            return vlp16();
        case LadarModel::HDL32E:
            return hdl32e();
        case LadarModel::HDL64E:
            return hdl64e();
        case LadarModel::LMS291:
            return lms291();
        case LadarModel::LMS511:
            return lms511();
    }
    return vlp16();
}

Sweep sweepOf(const SpinningLadar& ladar, double rate, double fieldOfView)
{
    if (ladar.isLineScanner()) return lineSweep(ladar, fieldOfView);
    const int firings = ladar.firingsPerRevolution(rate);
    return {firings, 0.0, 2.0 * kPi / firings, ladar.firingPeriod};
}

}  // namespace vdamf
