// SPDX-License-Identifier: BSD-3-Clause
// LADARs by name, after their data sheets: spinning columns of lasers, and line scanners.
#pragma once

#include <utility>
#include <vector>

#include "vdamf/tracking/types/geometry.h"
#include "vdamf/tracking/types/options.h"

namespace vdamf
{
enum class LadarModel
{
    VLP16,
    HDL32E,
    HDL64E,
    LMS291,
    LMS511
};

template <>
struct EnumNames<LadarModel>
{
    static std::vector<std::pair<LadarModel, const char*>> names()
    {
        return {{LadarModel::VLP16, "VLP-16"},
                {LadarModel::HDL32E, "HDL-32E"},
                {LadarModel::HDL64E, "HDL-64E"},
                {LadarModel::LMS291, "LMS-291"},
                {LadarModel::LMS511, "LMS-511"}};
    }
};

/// One scan as a sequence of firings, evenly spaced in time and azimuth.
struct Sweep
{
    int firings = 0;
    double firstAzimuth = 0.0;  ///< clockwise from forward, rad
    double azimuthStep = 0.0;   ///< from firing to firing, negative: counter-clockwise, rad
    double period = 0.0;        ///< from firing to firing, s
};

/// A column of lasers that turns at a constant rate; a firing is one shot of every laser, one
/// after another, all from the sensor's origin. It turns either as a whole, clockwise (seen from
/// above) and once a scan; or it is a single laser with a mirror of its own rate, which scans its
/// field of view counter-clockwise: a line scanner.
struct SpinningLadar
{
    std::vector<double> elevations;   ///< in the order of the data packets, rad
    std::vector<double> laserDelays;  ///< from the firing's begin to each laser's shot, s
    double firingPeriod = 0.0;        ///< from firing to firing, s; line scanner: see sweepOf()
    int firingsPerPacket = 1;         ///< a revolution is whole packets
    double rangeNoise = 0.0;          ///< standard deviation, m
    double minRange = 0.0;            ///< m
    double maxRange = 0.0;            ///< m
    double halfLossStrength = 0.0;    ///< see LadarMount
    double fieldOfView = 2.0 * kPi;   ///< rad
    double maxRate = 20.0;            ///< scans, 1/s
    double resolution = 0.0;          ///< of a line scanner, rad; 0: not a line scanner

    bool isLineScanner() const { return resolution > 0.0; }

    /// Firings in a revolution at a rate in 1/s, down to whole packets.
    int firingsPerRevolution(double rate) const;
};

SpinningLadar ladarOf(LadarModel model);

/// A scan at a rate in 1/s. A revolution begins at azimuth 0 and has all azimuths; a line
/// scanner's mirror turns at maxRate, and its shots lie symmetrically in the field of view (rad).
Sweep sweepOf(const SpinningLadar& ladar, double rate, double fieldOfView);

}  // namespace vdamf
