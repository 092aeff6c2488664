// SPDX-License-Identifier: BSD-3-Clause
// Small observations, and rawlogs made of them.
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf::test
{
inline mrpt::obs::CObservationOdometry odometry(int number)
{
    mrpt::obs::CObservationOdometry object;
    object.timestamp = mrpt::Clock::fromDouble(1.5e9 + number);
    object.sensorLabel = "wheels";
    object.odometry = mrpt::poses::CPose2D(number, 2.0, 0.1);
    return object;
}

/// `points` of them on a line, intensity 0.25.
inline mrpt::obs::CObservationPointCloud pointCloud(int points, double time = 1.5e9)
{
    auto map = mrpt::maps::CPointsMapXYZI::Create();
    for (int i = 0; i < points; ++i)
    {
        const auto x = static_cast<float>(i + 1);
        map->insertPointFast(x, 0.5F * x, 1.0F);
        map->setPointIntensity(static_cast<std::size_t>(i), 0.25F);
    }
    mrpt::obs::CObservationPointCloud object;
    object.timestamp = mrpt::Clock::fromDouble(time);
    object.sensorLabel = "ladar";
    object.pointcloud = map;
    return object;
}

/// The bytes of an object of a class that nobody knows.
inline std::string unknownObject(const std::string& className, const std::string& payload)
{
    const auto length = static_cast<char>(0x80 | className.size());
    return length + className + std::string(1, '\0') + payload + '\x88';
}

inline std::string nullObject()
{
    return "\x87nullptr\x88";
}

inline std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void writeBytes(const std::filesystem::path& path, std::string_view bytes)
{
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::vector<RawlogEntry> entriesOf(RawlogReader& reader)
{
    std::vector<RawlogEntry> entries;
    while (auto entry = reader.next()) entries.push_back(std::move(*entry));
    return entries;
}

inline std::string concatenated(const std::vector<RawlogEntry>& entries)
{
    std::string bytes;
    for (const RawlogEntry& entry : entries) bytes += entry.bytes;
    return bytes;
}

}  // namespace vdamf::test
