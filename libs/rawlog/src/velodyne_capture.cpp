// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/velodyne_capture.h"

#include <pcap/pcap.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

#include "udp_payload.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t kDataBytes = 1206;
constexpr std::size_t kPositionBytes = 512;
constexpr std::size_t kDataStampAt = 1200;
constexpr std::size_t kPositionStampAt = 198;

std::uint32_t byteOf(const std::string& bytes, std::size_t i)
{
    return static_cast<std::uint8_t>(bytes[i]);
}

using Handle = std::unique_ptr<pcap_t, decltype(&pcap_close)>;

Handle open(const fs::path& path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw std::runtime_error(path.string() + ": is a folder, not a network capture");
    errno = 0;
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (file == nullptr)
        throw std::runtime_error(path.string() +
                                 ": cannot open: " + std::system_category().message(errno));
    std::array<char, PCAP_ERRBUF_SIZE> why = {};
    Handle handle(
        pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, why.data()),
        &pcap_close);
    if (handle) return handle;  // it closes the file
    std::fclose(file);
    throw std::runtime_error(path.string() +
                             ": not a network capture (pcap, pcapng): " + why.data());
}

LinkLayer linkOf(pcap_t* handle, const fs::path& path)
{
    const int type = pcap_datalink(handle);
    for (const LinkLayer known : {LinkLayer::Loopback, LinkLayer::Ethernet, LinkLayer::RawIp,
                                  LinkLayer::LinuxCooked, LinkLayer::Ipv4, LinkLayer::LinuxCooked2})
        if (type == static_cast<int>(known)) return known;
    const char* const name = pcap_datalink_val_to_name(type);
    throw std::runtime_error(path.string() + ": captured from a link of type " +
                             std::to_string(type) + (name ? std::string(" (") + name + ")" : "") +
                             "; known are Ethernet, Linux cooked, raw IP and loopback");
}
}  // namespace

std::uint32_t VelodynePacket::stamp() const
{
    const std::size_t at = kind == Kind::Data ? kDataStampAt : kPositionStampAt;
    return byteOf(bytes, at) | byteOf(bytes, at + 1) << 8U | byteOf(bytes, at + 2) << 16U |
           byteOf(bytes, at + 3) << 24U;
}

int VelodynePacket::azimuth() const
{
    return static_cast<int>(byteOf(bytes, 2) | byteOf(bytes, 3) << 8U);
}

struct VelodyneCapture::Impl
{
    explicit Impl(const fs::path& path) : handle(open(path)), link(linkOf(handle.get(), path))
    {
        std::error_code ignored;
        size = fs::file_size(path, ignored);
        if (ignored) size = 0;
    }

    Handle handle;
    LinkLayer link;
    std::uintmax_t size = 0;
    CaptureSummary summary;

    std::optional<VelodynePacket> packetIn(const pcap_pkthdr& header, const u_char* data)
    {
        const auto payload =
            udpPayload(link, {reinterpret_cast<const char*>(data), std::size_t{header.caplen}});
        const auto size_ = payload ? payload->bytes.size() : 0;
        const bool isData = size_ == kDataBytes && (payload->bytes.substr(0, 2) == "\xff\xee" ||
                                                    payload->bytes.substr(0, 2) == "\xff\xdd");
        const bool isPosition = size_ == kPositionBytes;
        if (!isData && !isPosition)
        {
            ++(payload && payload->isCut ? summary.cut : summary.other);
            return std::nullopt;
        }
        ++(isData ? summary.data : summary.positions);
        VelodynePacket packet;
        packet.kind = isData ? VelodynePacket::Kind::Data : VelodynePacket::Kind::Position;
        packet.time = static_cast<double>(header.ts.tv_sec) +
                      1e-9 * static_cast<double>(header.ts.tv_usec);  // asked for as nanoseconds
        packet.sensor = payload->source;
        packet.bytes = payload->bytes;
        return packet;
    }
};

VelodyneCapture::VelodyneCapture(const fs::path& path) : impl_(std::make_unique<Impl>(path)) {}
VelodyneCapture::~VelodyneCapture() = default;

std::optional<VelodynePacket> VelodyneCapture::next()
{
    for (;;)
    {
        pcap_pkthdr* header = nullptr;
        const u_char* data = nullptr;
        const int state = pcap_next_ex(impl_->handle.get(), &header, &data);
        if (state != 1)
        {
            if (state != PCAP_ERROR_BREAK)
                impl_->summary.problem = pcap_geterr(impl_->handle.get());
            return std::nullopt;
        }
        ++impl_->summary.packets;
        if (auto packet = impl_->packetIn(*header, data)) return packet;
    }
}

const CaptureSummary& VelodyneCapture::summary() const
{
    return impl_->summary;
}

double VelodyneCapture::progress() const
{
    if (impl_->size == 0) return 0.0;
    const long at = std::ftell(pcap_file(impl_->handle.get()));
    return at < 0 ? 0.0 : static_cast<double>(at) / static_cast<double>(impl_->size);
}

}  // namespace vdamf
