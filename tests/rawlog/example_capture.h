// SPDX-License-Identifier: BSD-3-Clause
// Network captures of simulated Velodyne sensors, byte by byte.
#pragma once

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf::test
{
inline std::string bigEndian(std::uint32_t value, int bytes)
{
    std::string text;
    for (int i = bytes - 1; i >= 0; --i)
        text += static_cast<char>(value >> static_cast<unsigned>(8 * i) & 0xffU);
    return text;
}

inline std::string littleEndian(std::uint32_t value)
{
    std::string text = bigEndian(value, 4);
    return {text.rbegin(), text.rend()};
}

/// IPv4 and UDP headers before a payload. The source is 10.0.0.`host`.
inline std::string datagram(const std::string& payload, int host)
{
    const auto size = static_cast<std::uint32_t>(payload.size());
    const std::string ip =
        bigEndian(0x45000000U + size + 28, 4) + bigEndian(0, 4) + bigEndian(0x40110000U, 4) +
        bigEndian(0x0a000000U + static_cast<std::uint32_t>(host), 4) + bigEndian(0xffffffffU, 4);
    return ip + bigEndian(2368, 2) + bigEndian(2368, 2) + bigEndian(size + 8, 2) + bigEndian(0, 2) +
           payload;
}

/// A pcap file with a link type of libpcap.
class ExampleCapture
{
public:
    explicit ExampleCapture(std::uint32_t link = 1) : link_(link)
    {
        bytes_ = littleEndian(0xa1b2c3d4U) + littleEndian(0x00040002U) + littleEndian(0) +
                 littleEndian(0) + littleEndian(65535) + littleEndian(link);
    }

    void add(double time, const std::string& payload, int host = 1)
    {
        const std::string frame = linkHeader() + datagram(payload, host);
        const auto size = static_cast<std::uint32_t>(frame.size());
        const double seconds = std::floor(time);
        bytes_ += littleEndian(static_cast<std::uint32_t>(seconds)) +
                  littleEndian(static_cast<std::uint32_t>(std::lround((time - seconds) * 1e6))) +
                  littleEndian(size) + littleEndian(size) + frame;
    }

    const std::string& bytes() const { return bytes_; }

private:
    std::string linkHeader() const
    {
        const std::string ipv4 = bigEndian(0x0800, 2);
        if (link_ == 1 && tagged) return std::string(12, 'm') + bigEndian(0x81000005U, 4) + ipv4;
        if (link_ == 1) return std::string(12, 'm') + ipv4;
        if (link_ == 113) return std::string(14, 's') + ipv4;
        if (link_ == 276) return ipv4 + std::string(18, 's');
        if (link_ == 0) return littleEndian(2);
        return {};
    }

    std::uint32_t link_;
    std::string bytes_;

public:
    bool tagged = false;  ///< frames with a VLAN tag, Ethernet only
};

/// Payloads of the packets of `turns` revolutions with one hit a shot, at 20 m.
inline std::vector<std::string> turningPackets(VelodyneModel model, double time, double turns)
{
    constexpr double kRate = 10.0;  // revolutions, 1/s
    const double period = model == VelodyneModel::VLP16    ? 55.296e-6
                          : model == VelodyneModel::HDL32E ? 46.08e-6
                                                           : 48.0e-6;
    const std::size_t lasers = laserElevations(model).size();
    std::vector<VelodyneFiring> firings(static_cast<std::size_t>(turns / kRate / period));
    for (std::size_t i = 0; i < firings.size(); ++i)
    {
        firings[i].azimuth = 2.0 * kPi * kRate * period * static_cast<double>(i);
        firings[i].range.assign(lasers, 20.0F);
        firings[i].intensity.assign(lasers, 0.5F);
    }
    std::vector<std::string> payloads;
    for (const auto& packet : encodeVelodyne(model, time, firings).scan_packets)
    {
        std::string bytes(sizeof(packet), '\0');
        std::memcpy(bytes.data(), &packet, sizeof(packet));
        payloads.push_back(bytes);
    }
    return payloads;
}

/// A position packet: stamp in microseconds since the hour, sentence.
inline std::string positionPacket(std::uint32_t stamp, const std::string& sentence)
{
    std::string bytes(512, '\0');
    bytes.replace(198, 4, littleEndian(stamp));
    bytes.replace(206, sentence.size(), sentence);
    return bytes;
}

}  // namespace vdamf::test
