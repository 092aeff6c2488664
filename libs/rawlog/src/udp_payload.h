// SPDX-License-Identifier: BSD-3-Clause
// From a frame of a network capture to what a UDP datagram carries.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace vdamf
{
/// How frames begin. Values of libpcap's DLT_ constants.
enum class LinkLayer
{
    Loopback = 0,
    Ethernet = 1,
    RawIp = 12,
    LinuxCooked = 113,
    Ipv4 = 228,
    LinuxCooked2 = 276
};

struct UdpPayload
{
    std::uint32_t source = 0;  ///< IPv4 address
    std::string_view bytes;    ///< in the frame
    bool isCut = false;        ///< the datagram goes on behind what was captured
};

/// Nothing where the frame is no whole IPv4 UDP datagram (a fragment, another protocol, nonsense).
std::optional<UdpPayload> udpPayload(LinkLayer link, std::string_view frame);

}  // namespace vdamf
