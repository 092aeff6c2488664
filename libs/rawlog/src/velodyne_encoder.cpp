// SPDX-License-Identifier: BSD-3-Clause
// Firings -> Velodyne data packets.
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"
#include "velodyne_layout.h"

namespace vdamf
{
namespace
{
using Packet = VelodyneScan::TVelodyneRawPacket;
using PacketBytes = std::array<std::uint8_t, VelodyneScan::PACKET_SIZE>;
static_assert(sizeof(Packet) == VelodyneScan::PACKET_SIZE);

void put16(std::uint8_t* to, std::uint16_t value)
{
    to[0] = static_cast<std::uint8_t>(value & 0xff);
    to[1] = static_cast<std::uint8_t>(value >> 8);
}

std::uint16_t azimuthUnits(double azimuth)
{
    const double units = std::round(azimuth / (2.0 * kPi) * kUnitsPerTurn);
    const double turned = units - kUnitsPerTurn * std::floor(units / kUnitsPerTurn);
    return static_cast<std::uint16_t>(turned);
}

std::uint16_t distanceUnits(float range)
{
    const double units = std::round(static_cast<double>(range) / kMetresPerUnit);
    return units >= 1.0 && units <= 65535.0 ? static_cast<std::uint16_t>(units) : 0;
}

std::uint8_t intensityUnits(float intensity)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(intensity, 0.0F, 1.0F) * 255.0F));
}

/// Microseconds since the hour, as the sensor stamps its packets.
std::uint32_t microsecondsOfHour(double time)
{
    const double ofHour = time - 3600.0 * std::floor(time / 3600.0);
    return static_cast<std::uint32_t>(std::llround(ofHour * 1e6) % 3600000000LL);
}

std::uint8_t modelByte(VelodyneModel model)
{
    // The HDL-64E has a status byte in this place.
    if (model == VelodyneModel::HDL64E) return 0;
    return model == VelodyneModel::VLP16 ? 0x22 : 0x21;
}

void check(const std::vector<VelodyneFiring>& firings, int lasers)
{
    const auto expected = static_cast<std::size_t>(lasers);
    for (const VelodyneFiring& firing : firings)
    {
        if (firing.range.size() == expected && firing.intensity.size() == expected) continue;
        throw std::runtime_error("a firing has " + std::to_string(firing.range.size()) +
                                 " ranges and " + std::to_string(firing.intensity.size()) +
                                 " intensities: expected one of each for " +
                                 std::to_string(lasers) + " lasers");
    }
}

class PacketEncoder
{
public:
    PacketEncoder(VelodyneModel model, double time, const std::vector<VelodyneFiring>& firings)
        : model_(model), layout_(velodyneLayout(model)), time_(time), firings_(firings)
    {
        check(firings, layout_.lasers);
    }

    std::size_t packets() const
    {
        return (firings_.size() + firingsPerPacket() - 1) / firingsPerPacket();
    }

    Packet packet(std::size_t index) const
    {
        PacketBytes bytes = {};
        const std::size_t first = index * firingsPerPacket();
        for (int block = 0; block < kBlocksPerPacket; ++block)
        {
            const int firing = block / layout_.blocksPerFiring * layout_.firingsPerBlock;
            putBlock(&bytes[static_cast<std::size_t>(block * VelodyneScan::SIZE_BLOCK)],
                     first + static_cast<std::size_t>(firing), block % layout_.blocksPerFiring);
        }
        const double begin = time_ + layout_.firingPeriod * static_cast<double>(first);
        const std::uint32_t stamp = microsecondsOfHour(begin);
        std::uint8_t* tail = &bytes[kBlocksPerPacket * VelodyneScan::SIZE_BLOCK];
        put16(tail, static_cast<std::uint16_t>(stamp & 0xffff));
        put16(tail + 2, static_cast<std::uint16_t>(stamp >> 16));
        tail[4] =
            model_ == VelodyneModel::HDL64E ? std::uint8_t{0} : VelodyneScan::RETMODE_STRONGEST;
        tail[5] = modelByte(model_);
        Packet result;
        std::memcpy(&result, bytes.data(), bytes.size());
        return result;
    }

private:
    std::size_t firingsPerPacket() const
    {
        return static_cast<std::size_t>(kBlocksPerPacket * layout_.firingsPerBlock /
                                        layout_.blocksPerFiring);
    }

    /// Azimuth of a firing, also of those that fill up the last packet.
    double azimuthOf(std::size_t firing) const
    {
        if (firing < firings_.size()) return firings_[firing].azimuth;
        const std::size_t last = firings_.size() - 1;
        const double step =
            last > 0 ? wrapAngle(firings_[last].azimuth - firings_[last - 1].azimuth) : 0.0;
        return firings_[last].azimuth + step * static_cast<double>(firing - last);
    }

    void putBlock(std::uint8_t* to, std::size_t firing, int bank) const
    {
        put16(to, bank == 0 ? VelodyneScan::UPPER_BANK : VelodyneScan::LOWER_BANK);
        put16(to + 2, azimuthUnits(azimuthOf(firing)));
        const int lasersInBlock = kReturnsPerBlock / layout_.firingsPerBlock;
        for (int i = 0; i < kReturnsPerBlock; ++i)
        {
            const std::size_t shot = firing + static_cast<std::size_t>(i / lasersInBlock);
            if (shot >= firings_.size()) return;
            const auto laser =
                static_cast<std::size_t>(i % lasersInBlock + kReturnsPerBlock * bank);
            std::uint8_t* one = to + 4 + VelodyneScan::RAW_SCAN_SIZE * i;
            put16(one, distanceUnits(firings_[shot].range[laser]));
            one[2] = intensityUnits(firings_[shot].intensity[laser]);
        }
    }

    VelodyneModel model_;
    VelodyneLayout layout_;
    double time_;
    const std::vector<VelodyneFiring>& firings_;
};

}  // namespace

mrpt::obs::VelodyneCalibration nominalCalibration(VelodyneModel model)
{
    mrpt::obs::VelodyneCalibration result;
    for (const double elevation : laserElevations(model))
    {
        mrpt::obs::VelodyneCalibration::PerLaserCalib laser;
        laser.verticalCorrection = elevation * 180.0 / kPi;
        laser.sinVertCorrection = std::sin(elevation);
        laser.cosVertCorrection = std::cos(elevation);
        result.laser_corrections.push_back(laser);
    }
    return result;
}

VelodyneScan encodeVelodyne(VelodyneModel model, double time,
                            const std::vector<VelodyneFiring>& firings)
{
    const PacketEncoder encoder(model, time, firings);
    VelodyneScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(time);
    scan.originalReceivedTimestamp = scan.timestamp;
    scan.calibration = nominalCalibration(model);
    scan.scan_packets.reserve(encoder.packets());
    for (std::size_t i = 0; i < encoder.packets(); ++i)
    {
        scan.scan_packets.push_back(encoder.packet(i));
    }
    return scan;
}

}  // namespace vdamf
