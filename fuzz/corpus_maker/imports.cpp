// SPDX-License-Identifier: BSD-3-Clause
// What vdamf-import reads beside KITTI drives: captures, clouds, poses. And what vdamf-track wrote.
#include <cstring>

#include "corpus.h"
#include "rawlog/example_capture.h"
#include "street.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf::fuzz
{
namespace
{
std::string pcapng(const std::string& frame)
{
    using test::littleEndian;
    const auto size = static_cast<std::uint32_t>(frame.size());
    const std::string padding((4 - size % 4) % 4, '\0');
    const std::uint32_t packet = 32 + size + static_cast<std::uint32_t>(padding.size());
    return littleEndian(0x0a0d0d0aU) + littleEndian(28) + littleEndian(0x1a2b3c4dU) +
           littleEndian(1) + std::string(8, '\xff') + littleEndian(28) + littleEndian(1) +
           littleEndian(20) + littleEndian(1) + littleEndian(65535) + littleEndian(20) +
           littleEndian(6) + littleEndian(packet) + std::string(12, '\0') + littleEndian(size) +
           littleEndian(size) + frame + padding + littleEndian(packet);
}

void addCaptures(Corpus& corpus)
{
    const auto packets = test::turningPackets(VelodyneModel::VLP16, 1.5e9, 0.02);
    test::ExampleCapture capture;
    capture.add(1.5e9, test::positionPacket(5, "$GPRMC,210230,A,3855.4,N,09446.2,W,0.0,76,130998"));
    capture.add(1.5e9 + 1e-3, packets.at(0));
    capture.add(1.5e9 + 2e-3, packets.at(1));
    corpus["capture/pcap"] = capture.bytes();
    test::ExampleCapture cooked(113);
    cooked.add(1.5e9, packets.at(0));
    corpus["capture/cooked"] = cooked.bytes();
    corpus["capture/pcapng"] = pcapng(std::string(12, 'm') + test::bigEndian(0x0800, 2) +
                                      test::datagram(packets.at(0), 1));
}

template <class T>
std::string bytesOf(std::initializer_list<T> values)
{
    std::string bytes;
    for (const T value : values)
    {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    }
    return bytes;
}

void addClouds(Corpus& corpus)
{
    const std::string head =
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity t\nSIZE 4 4 4 4 4\n"
        "TYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ";
    const std::string point = bytesOf({1.0F, -2.5F, 0.5F, 0.25F}) + bytesOf<std::uint32_t>({1000});
    corpus["pcd/ascii"] = head + "ascii\n1 -2.5 0.5 0.25 1000\nnan 2 3 1 2000\n";
    corpus["pcd/binary"] = head + "binary\n" + point + point;
    // One literal run of LZF: a count less one, then bytes.
    const std::string stream = std::string(1, '\x1f') + (point + point).substr(0, 32) +
                               std::string(1, '\x07') + (point + point).substr(32);
    corpus["pcd/compressed"] =
        head + "binary_compressed\n" +
        bytesOf<std::uint32_t>({static_cast<std::uint32_t>(stream.size()),
                                static_cast<std::uint32_t>(2 * point.size())}) +
        stream;
    const auto ply = [](const std::string& format)
    {
        return "ply\nformat " + format +
               " 1.0\ncomment made\nelement vertex 2\nproperty float x\nproperty float y\n"
               "property float z\nproperty uchar intensity\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n";
    };
    corpus["ply/ascii"] = ply("ascii") + "1 2 3 40\n-1 2.5 3 255\n3 0 1 1\n";
    const std::string vertex = bytesOf({1.0F, 2.0F, 3.0F}) + "(";
    corpus["ply/little"] =
        ply("binary_little_endian") + vertex + vertex + '\x01' + bytesOf<std::int32_t>({1});
    corpus["ply/big"] =
        ply("binary_big_endian") + vertex + vertex + '\x01' + bytesOf<std::int32_t>({1});
}

/// The small street with a table behind its scan.
std::string annotated()
{
    OutputOptions options;
    options.scene = false;
    Annotator annotator(options);
    std::string bytes = serialized(headComment("1.0", "0 0 0", "CObservationRobotPose 'ins'", {},
                                               mrpt::Clock::fromDouble(1.5e9)));
    const Street street = smallStreet("VLP-16", 1, 16.0);
    const auto scan = thinned(*street.observations.at(1), 50);
    bytes += serialized(*street.observations.at(0)) + serialized(*scan);
    FrameResult frame{1.5e9, {}, 0, 0, 0, {}};
    frame.tracks.resize(1);
    frame.tracks[0].id = 3;
    frame.tracks[0].status = TrackStatus::Confirmed;
    frame.tracks[0].box = {12.0, 0.5, 0.0, 4.3, 1.8};
    for (const auto& one : annotator.annotate(frame, scan->timestamp)) bytes += serialized(*one);
    return bytes + serialized(*street.observations.at(2));
}
}  // namespace

Corpus importCorpus()
{
    Corpus corpus = {
        {"poses/tum", "# time x y z q\n1.5e9 1 2 3 0 0 0 1\n1500000001 2 2 3 0 0 1 0\n"},
        {"poses/kitti", "1 0 0 1.5 0 1 0 0 0 0 1 -2\n1 0 0 2.5 0 1 0 0 0 0 1 -2\n"},
        {"poses/times", "1500000000.1\n1500000000.2\n"},
        {"poses/dates", "2011-09-26 13:02:25.963999987\n"},
        {"annotations/frame", annotated()}};
    addCaptures(corpus);
    addClouds(corpus);
    return corpus;
}

}  // namespace vdamf::fuzz
