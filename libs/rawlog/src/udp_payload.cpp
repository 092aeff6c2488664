// SPDX-License-Identifier: BSD-3-Clause
#include "udp_payload.h"

namespace vdamf
{
namespace
{
constexpr std::uint32_t kIpv4 = 0x0800;

std::uint32_t octetAt(std::string_view bytes, std::size_t i)
{
    return static_cast<std::uint8_t>(bytes[i]);
}

/// Big-endian.
std::uint32_t numberAt(std::string_view bytes, std::size_t i)
{
    return octetAt(bytes, i) << 8U | octetAt(bytes, i + 1);
}

std::optional<std::string_view> behind(std::string_view frame, std::size_t header,
                                       std::size_t typeAt)
{
    if (frame.size() < header || numberAt(frame, typeAt) != kIpv4) return std::nullopt;
    return frame.substr(header);
}

std::optional<std::string_view> behindEthernet(std::string_view frame)
{
    constexpr std::size_t kHeader = 14;
    constexpr std::size_t kTag = 4;
    std::size_t header = kHeader;
    for (int tags = 0; tags < 2 && frame.size() >= header + kTag; ++tags)
    {
        const std::uint32_t type = numberAt(frame, header - 2);
        if (type != 0x8100 && type != 0x88a8) break;
        header += kTag;
    }
    return behind(frame, header, header - 2);
}

std::optional<std::string_view> ipIn(LinkLayer link, std::string_view frame)
{
    switch (link)
    {
        case LinkLayer::Ethernet:
            return behindEthernet(frame);
        case LinkLayer::LinuxCooked:
            return behind(frame, 16, 14);
        case LinkLayer::LinuxCooked2:
            return behind(frame, 20, 0);
        case LinkLayer::Loopback:
            // A family in the byte order of the capturing machine.
            return frame.size() < 4 ? std::nullopt : std::optional(frame.substr(4));
        case LinkLayer::RawIp:
        case LinkLayer::Ipv4:
            return frame;
    }
    return std::nullopt;
}
}  // namespace

std::optional<UdpPayload> udpPayload(LinkLayer link, std::string_view frame)
{
    constexpr std::size_t kLeastIp = 20;
    constexpr std::size_t kUdp = 8;
    constexpr std::uint32_t kUdpProtocol = 17;
    constexpr std::uint32_t kFragmentBits = 0x3fff;  // more fragments, or an offset
    const auto ip = ipIn(link, frame);
    if (!ip || ip->size() < kLeastIp || octetAt(*ip, 0) >> 4U != 4U) return std::nullopt;
    const std::size_t header = 4 * (octetAt(*ip, 0) & 0x0fU);
    const bool isDatagram =
        octetAt(*ip, 9) == kUdpProtocol && (numberAt(*ip, 6) & kFragmentBits) == 0;
    if (header < kLeastIp || !isDatagram || ip->size() < header + kUdp) return std::nullopt;
    const std::size_t length = numberAt(*ip, header + 4);
    if (length < kUdp) return std::nullopt;
    UdpPayload payload;
    payload.source = numberAt(*ip, 12) << 16U | numberAt(*ip, 14);
    payload.bytes = ip->substr(header + kUdp, length - kUdp);
    payload.isCut = payload.bytes.size() < length - kUdp;
    return payload;
}

}  // namespace vdamf
