// SPDX-License-Identifier: BSD-3-Clause
// The packets of Velodyne sensors in a network capture (pcap, pcapng).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace vdamf
{
struct VelodynePacket
{
    enum class Kind
    {
        Data,     ///< 1206 bytes: returns
        Position  ///< 512 bytes: GPS
    };
    Kind kind = Kind::Data;
    double time = 0.0;         ///< of the capture, s (UNIX)
    std::uint32_t sensor = 0;  ///< IPv4 address that it came from
    std::string bytes;         ///< payload

    /// Sensor's clock, microseconds since the hour.
    std::uint32_t stamp() const;
    /// Azimuth of the first block, hundredths of a degree. Data only.
    int azimuth() const;
};

struct CaptureSummary
{
    std::uint64_t packets = 0;  ///< of the network, all
    std::uint64_t data = 0;
    std::uint64_t positions = 0;
    std::uint64_t cut = 0;    ///< captured without their end, left out
    std::uint64_t other = 0;  ///< of other programs, or fragments
    std::string problem;      ///< why reading ended before the end of the file; empty: it did not
};

/// Streams the packets of a capture in file order. Ethernet (with VLAN tags), Linux cooked, raw and
/// loopback captures; IPv4, UDP, any port.
class VelodyneCapture
{
public:
    /// Throws std::runtime_error that names the file: missing, not a capture, link type not known.
    explicit VelodyneCapture(const std::filesystem::path& path);
    ~VelodyneCapture();
    VelodyneCapture(const VelodyneCapture&) = delete;
    VelodyneCapture& operator=(const VelodyneCapture&) = delete;

    /// Nothing at the end of the file, or where it is cut or damaged (see summary().problem).
    std::optional<VelodynePacket> next();

    const CaptureSummary& summary() const;
    /// Read so far, 0..1.
    double progress() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vdamf
