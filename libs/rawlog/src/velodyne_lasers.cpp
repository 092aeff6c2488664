// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_lasers.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "vdamf/tracking/types/geometry.h"
#include "velodyne_layout.h"
#include "velodyne_packet_view.h"

namespace vdamf
{
namespace
{
using Calibration = mrpt::obs::VelodyneCalibration::PerLaserCalib;

constexpr std::uint8_t kHdl32e = 0x21;
constexpr std::uint8_t kVlp16 = 0x22;
constexpr std::uint8_t kPuckLite = 0x23;
constexpr std::uint8_t kPuckHiRes = 0x24;

bool hasLowerBlocks(const VelodyneScan& scan)
{
    for (const auto& packet : scan.scan_packets)
    {
        const VelodynePacketView view(packet);
        for (int block = 0; block < kBlocksPerPacket; ++block)
        {
            if (view.header(block) == VelodyneScan::LOWER_BANK) return true;
        }
    }
    return false;
}

[[noreturn]] void failUnknownModel(std::uint8_t model, std::size_t calibrated)
{
    char code[8] = {};
    std::snprintf(code, sizeof(code), "0x%02x", static_cast<unsigned>(model));
    throw std::runtime_error("unknown Velodyne sensor: model code " + std::string(code) +
                             " and calibration of " + std::to_string(calibrated) +
                             " lasers; known are VLP-16 (0x22, 0x23; 0x24 with calibration), "
                             "HDL-32E (0x21) and HDL-64E");
}

/// MRPT keeps angles in the unit of the calibration file: degrees (XML) or radians (YAML). The
/// sine beside the vertical angle tells which.
double radiansPerUnit(const Calibration& laser)
{
    constexpr double kTolerance = 1e-6;
    const double sineOfRadians = std::sin(laser.verticalCorrection);
    const bool radians = std::abs(sineOfRadians - laser.sinVertCorrection) < kTolerance;
    return radians ? 1.0 : kPi / 180.0;
}

/// The unit is the same for all lasers; a laser near the horizon cannot tell it.
double radiansPerUnit(const std::vector<Calibration>& lasers)
{
    const Calibration* steepest = &lasers.front();
    for (const Calibration& laser : lasers)
    {
        if (std::abs(laser.sinVertCorrection) > std::abs(steepest->sinVertCorrection))
        {
            steepest = &laser;
        }
    }
    return radiansPerUnit(*steepest);
}

VelodyneLaser calibrated(const Calibration& laser, double unit)
{
    VelodyneLaser result;
    result.cosElevation = laser.cosVertCorrection;
    result.sinElevation = laser.sinVertCorrection;
    result.rotation = laser.azimuthCorrection * unit;
    result.distance = laser.distanceCorrection;
    result.verticalOffset = laser.verticalOffsetCorrection;
    result.horizontalOffset = laser.horizontalOffsetCorrection;
    return result;
}
}  // namespace

VelodyneModel velodyneModelOf(const VelodyneScan& scan)
{
    if (scan.scan_packets.empty()) throw std::runtime_error("it has no packets");
    // The HDL-64E has a changing status byte where the others tell their model.
    if (hasLowerBlocks(scan)) return VelodyneModel::HDL64E;
    const std::uint8_t model = VelodynePacketView(scan.scan_packets.front()).model();
    const std::size_t calibratedLasers = scan.calibration.laser_corrections.size();
    if (model == kVlp16 || model == kPuckLite) return VelodyneModel::VLP16;
    if (model == kPuckHiRes && calibratedLasers == 16) return VelodyneModel::VLP16;
    if (model == kHdl32e) return VelodyneModel::HDL32E;
    // Old firmware leaves the code out.
    if (model == 0 && calibratedLasers == 16) return VelodyneModel::VLP16;
    if (model == 0 && calibratedLasers == 32) return VelodyneModel::HDL32E;
    failUnknownModel(model, calibratedLasers);
}

std::vector<VelodyneLaser> velodyneLasers(const VelodyneScan& scan, VelodyneModel model)
{
    std::vector<VelodyneLaser> result;
    const std::vector<Calibration>& corrections = scan.calibration.laser_corrections;
    const std::vector<double>& nominal = laserElevations(model);
    if (corrections.empty())
    {
        for (const double elevation : nominal)
        {
            VelodyneLaser& laser = result.emplace_back();
            laser.cosElevation = std::cos(elevation);
            laser.sinElevation = std::sin(elevation);
        }
        return result;
    }
    if (corrections.size() != nominal.size())
    {
        throw std::runtime_error("the Velodyne calibration is one of " +
                                 std::to_string(corrections.size()) + " lasers, the sensor has " +
                                 std::to_string(nominal.size()));
    }
    const double unit = radiansPerUnit(corrections);
    for (const Calibration& laser : corrections) result.push_back(calibrated(laser, unit));
    return result;
}

}  // namespace vdamf
