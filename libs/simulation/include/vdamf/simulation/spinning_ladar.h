// SPDX-License-Identifier: BSD-3-Clause
// Spinning multi-beam LADARs by name, after their data sheets.
#pragma once

#include <utility>
#include <vector>

#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class LadarModel
{
    VLP16,
    HDL32E,
    HDL64E
};

template <>
struct EnumNames<LadarModel>
{
    static std::vector<std::pair<LadarModel, const char*>> names()
    {
        return {{LadarModel::VLP16, "VLP-16"},
                {LadarModel::HDL32E, "HDL-32E"},
                {LadarModel::HDL64E, "HDL-64E"}};
    }
};

/// A column of lasers that turns clockwise (seen from above) at a constant rate. All lasers leave
/// from the sensor's origin. A firing is one shot of every laser, one after another.
struct SpinningLadar
{
    std::vector<double> elevations;   ///< in the order of the data packets, rad
    std::vector<double> laserDelays;  ///< from the firing's begin to each laser's shot, s
    double firingPeriod = 0.0;        ///< from firing to firing, s
    int firingsPerPacket = 1;         ///< a revolution is whole packets
    double rangeNoise = 0.0;          ///< standard deviation, m
    double minRange = 0.0;            ///< m
    double maxRange = 0.0;            ///< m

    /// Firings in a revolution at a rate in 1/s, down to whole packets.
    int firingsPerRevolution(double rate) const;
};

SpinningLadar ladarOf(LadarModel model);

}  // namespace vdamf
