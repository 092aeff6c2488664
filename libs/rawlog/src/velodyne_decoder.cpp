// SPDX-License-Identifier: BSD-3-Clause
// Velodyne data packets -> points.
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"
#include "velodyne_lasers.h"
#include "velodyne_layout.h"
#include "velodyne_packet_view.h"

namespace vdamf
{
namespace
{
constexpr double kRadiansPerUnit = 2.0 * kPi / kUnitsPerTurn;

bool isValid(const VelodynePacketView& packet, int block)
{
    const std::uint16_t header = packet.header(block);
    return (header == VelodyneScan::UPPER_BANK || header == VelodyneScan::LOWER_BANK) &&
           packet.azimuth(block) < kUnitsPerTurn;
}

/// Seconds from the first packet's stamp to this one's, over the turn of the hour.
double secondsBetween(std::uint32_t first, std::uint32_t stamp)
{
    constexpr std::int64_t kMicrosecondsPerHour = 3600000000LL;
    std::int64_t difference = static_cast<std::int64_t>(stamp) - static_cast<std::int64_t>(first);
    if (difference < -kMicrosecondsPerHour / 2) difference += kMicrosecondsPerHour;
    if (difference > kMicrosecondsPerHour / 2) difference -= kMicrosecondsPerHour;
    return static_cast<double>(difference) * 1e-6;
}

/// Decodes the packets of one scan.
class PacketDecoder
{
public:
    PacketDecoder(const VelodyneScan& scan, VelodyneModel model)
        : model_(model), layout_(velodyneLayout(model)), lasers_(velodyneLasers(scan, model))
    {
        const std::size_t returns = scan.scan_packets.size() * kBlocksPerPacket * kReturnsPerBlock;
        for (auto* values : {&cloud_.x, &cloud_.y, &cloud_.z, &cloud_.intensity, &cloud_.time})
        {
            values->reserve(returns);
        }
    }

    /// `time` of the packet's first firing, relative to the observation's.
    void decode(const VelodynePacketView& packet, double time)
    {
        blocksPerFiring_ = layout_.blocksPerFiring * (isDual(packet) ? 2 : 1);
        placeLasers(azimuthRate(packet));
        for (int block = 0; block < kBlocksPerPacket; ++block)
        {
            if (isValid(packet, block)) decodeBlock(packet, block, time);
        }
    }

    PointCloud cloud() && { return std::move(cloud_); }

private:
    /// Where a laser points when its block says azimuth 0, and how much later it fires.
    struct Shot
    {
        double cosAzimuth = 1.0;
        double sinAzimuth = 0.0;
        double delay = 0.0;
        const VelodyneLaser* laser = nullptr;
    };

    bool isDual(const VelodynePacketView& packet) const
    {
        if (model_ != VelodyneModel::HDL64E)
            return packet.returnMode() == VelodyneScan::RETMODE_DUAL;
        // No mode byte there: upper, lower, upper, lower of one azimuth.
        return packet.azimuth(0) == packet.azimuth(2) && packet.header(0) == packet.header(2) &&
               packet.azimuth(4) == packet.azimuth(6) && packet.azimuth(0) != packet.azimuth(4);
    }

    /// Mean turning rate in the packet, rad/s. Steps far from the median one (a sector that the
    /// sensor leaves out) do not count.
    double azimuthRate(const VelodynePacketView& packet) const
    {
        std::vector<int> steps;
        for (int block = blocksPerFiring_; block < kBlocksPerPacket; ++block)
        {
            const int before = block - blocksPerFiring_;
            if (!isValid(packet, block) || !isValid(packet, before)) continue;
            const int step = packet.azimuth(block) - packet.azimuth(before);
            steps.push_back((step + kUnitsPerTurn) % kUnitsPerTurn);
        }
        if (steps.empty()) return 0.0;
        const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
        std::nth_element(steps.begin(), middle, steps.end());
        const int median = *middle;
        double sum = 0.0;
        int count = 0;
        for (const int step : steps)
        {
            if (std::abs(step - median) > median / 2 + 1) continue;
            sum += step;
            ++count;
        }
        return sum / count * kRadiansPerUnit / layout_.blockGroupPeriod();
    }

    void placeLasers(double rate)
    {
        const int lasersInBlock = kReturnsPerBlock / layout_.firingsPerBlock;
        for (int bank = 0; bank < layout_.blocksPerFiring; ++bank)
        {
            for (int i = 0; i < kReturnsPerBlock; ++i)
            {
                const int laser = i % lasersInBlock + kReturnsPerBlock * bank;
                Shot& shot = shots_[static_cast<std::size_t>(i + kReturnsPerBlock * bank)];
                shot.laser = &lasers_[static_cast<std::size_t>(laser)];
                shot.delay = layout_.delayInBlock(i);
                const double azimuth = rate * shot.delay - shot.laser->rotation;
                shot.cosAzimuth = std::cos(azimuth);
                shot.sinAzimuth = std::sin(azimuth);
            }
        }
    }

    void decodeBlock(const VelodynePacketView& packet, int block, double packetTime)
    {
        const bool lower = packet.header(block) == VelodyneScan::LOWER_BANK;
        if (lower && model_ != VelodyneModel::HDL64E) return;
        const double azimuth = packet.azimuth(block) * kRadiansPerUnit;
        const double cosBlock = std::cos(azimuth);
        const double sinBlock = std::sin(azimuth);
        const double time = packetTime + layout_.blockGroupPeriod() * (block / blocksPerFiring_);
        // The other return of the same shot, in a dual-return packet.
        const int partner = block - layout_.blocksPerFiring;
        const bool isSecond = block % blocksPerFiring_ >= layout_.blocksPerFiring;
        for (int i = 0; i < kReturnsPerBlock; ++i)
        {
            const std::uint16_t units = packet.distance(block, i);
            if (units == 0 || (isSecond && units == packet.distance(partner, i))) continue;
            const Shot& shot = shots_[static_cast<std::size_t>(i + (lower ? kReturnsPerBlock : 0))];
            const double c = cosBlock * shot.cosAzimuth - sinBlock * shot.sinAzimuth;
            const double s = sinBlock * shot.cosAzimuth + cosBlock * shot.sinAzimuth;
            add(*shot.laser, units * kMetresPerUnit + shot.laser->distance, c, s);
            cloud_.intensity.push_back(static_cast<float>(packet.intensity(block, i)) / 255.0F);
            cloud_.time.push_back(static_cast<float>(time + shot.delay));
        }
    }

    // The manual's axes are x right, y forward; ours x forward, y left.
    void add(const VelodyneLaser& laser, double range, double cosAzimuth, double sinAzimuth)
    {
        const double across =
            range * laser.cosElevation - laser.verticalOffset * laser.sinElevation;
        const double offset = laser.horizontalOffset;
        cloud_.x.push_back(static_cast<float>(across * cosAzimuth + offset * sinAzimuth));
        cloud_.y.push_back(static_cast<float>(-across * sinAzimuth + offset * cosAzimuth));
        cloud_.z.push_back(static_cast<float>(range * laser.sinElevation +
                                              laser.verticalOffset * laser.cosElevation));
    }

    VelodyneModel model_;
    VelodyneLayout layout_;
    std::vector<VelodyneLaser> lasers_;
    int blocksPerFiring_ = 1;  // dual returns counted
    std::array<Shot, 2 * kReturnsPerBlock> shots_;
    PointCloud cloud_;
};

double packetPeriod(const VelodyneLayout& layout)
{
    return layout.blockGroupPeriod() * kBlocksPerPacket / layout.blocksPerFiring;
}

/// Time of each packet's begin relative to the first one's. Stamps that cannot be (sensors that
/// never heard of a GPS may hold anything) are replaced by the nominal pace.
std::vector<double> packetTimes(const VelodyneScan& scan, const VelodyneLayout& layout)
{
    constexpr double kLongestPause = 1.0;
    const double period = packetPeriod(layout);
    std::vector<double> times;
    bool plausible = true;
    std::uint32_t first = 0;
    for (const auto& packet : scan.scan_packets)
    {
        const std::uint32_t stamp = VelodynePacketView(packet).stamp();
        if (times.empty()) first = stamp;
        const double time = secondsBetween(first, stamp);
        const double before = times.empty() ? 0.0 : times.back();
        plausible = plausible && std::abs(time - before) <= kLongestPause;
        times.push_back(time);
    }
    if (plausible) return times;
    for (std::size_t i = 0; i < times.size(); ++i) times[i] = period * static_cast<double>(i);
    return times;
}

PointCloud storedCloud(const VelodyneScan& scan)
{
    const VelodyneScan::TPointCloud& stored = scan.point_cloud;
    if (stored.y.size() != stored.x.size() || stored.z.size() != stored.x.size())
    {
        throw std::runtime_error("the coordinates of its points differ in number");
    }
    PointCloud cloud;
    cloud.x = stored.x;
    cloud.y = stored.y;
    cloud.z = stored.z;
    if (stored.intensity.size() == stored.x.size())
    {
        for (const std::uint8_t value : stored.intensity)
        {
            cloud.intensity.push_back(static_cast<float>(value) / 255.0F);
        }
    }
    if (stored.timestamp.size() == stored.x.size())
    {
        for (const mrpt::Clock::time_point stamp : stored.timestamp)
        {
            const std::chrono::duration<double> since = stamp - scan.timestamp;
            cloud.time.push_back(static_cast<float>(since.count()));
        }
    }
    return cloud;
}
}  // namespace

PointCloud decodeVelodyne(const VelodyneScan& scan)
{
    if (scan.scan_packets.empty()) return storedCloud(scan);
    const VelodyneModel model = velodyneModelOf(scan);
    const std::vector<double> times = packetTimes(scan, velodyneLayout(model));
    PacketDecoder decoder(scan, model);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        decoder.decode(VelodynePacketView(scan.scan_packets[i]), times[i]);
    }
    return std::move(decoder).cloud();
}

double durationOf(const VelodyneScan& scan)
{
    constexpr double kLongest = 1.0;
    double last = 0.0;
    try
    {
        if (scan.scan_packets.empty())
        {
            for (const float time : storedCloud(scan).time) last = std::max(last, double{time});
        }
        else
        {
            const VelodyneLayout layout = velodyneLayout(velodyneModelOf(scan));
            last = packetTimes(scan, layout).back() + packetPeriod(layout);
        }
    }
    catch (const std::runtime_error&)
    {
        return 0.0;  // what decodeVelodyne() will say
    }
    return std::clamp(last, 0.0, kLongest);
}

}  // namespace vdamf
