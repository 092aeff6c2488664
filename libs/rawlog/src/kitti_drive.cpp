// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/kitti_drive.h"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "fail_at.h"
#include "kitti_numbers.h"
#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
namespace fs = std::filesystem;

void checkFolder(const fs::path& folder)
{
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) failAt(folder, "there is no such folder");
    for (const char* part : {"velodyne_points/data", "oxts/data"})
    {
        if (fs::is_directory(folder / part, ignored)) continue;
        failAt(folder, std::string("not a KITTI raw drive: there is no folder ") + part +
                           "; name a folder like 2011_09_26_drive_0001_sync");
    }
}

// 0000000000.bin, 0000000001.bin, ... in `data` of a folder, as many as there are time stamps, of
// which such a share may be missing.
std::vector<KittiFile> stampedFiles(const fs::path& part, const std::string& extension,
                                    double mayBeMissing)
{
    const fs::path timestamps = part / "timestamps.txt";
    const fs::path folder = part / "data";
    const auto times = readKittiTimestamps(timestamps);
    const std::size_t stamps = times.size();
    if (stamps == 0) failAt(timestamps, "has no times");
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    {
        if (entry.path().extension() == extension) ++count;
    }
    std::vector<KittiFile> files;
    std::size_t missing = 0;
    for (std::size_t i = 0; i < stamps; ++i)
    {
        std::array<char, 32> name = {};
        std::snprintf(name.data(), name.size(), "%010zu", i);
        files.push_back({folder / (name.data() + extension), times[i]});
        files.back().isThere = fs::is_regular_file(files.back().path);
        if (files.back().isThere) continue;
        if (static_cast<double>(++missing) <= mayBeMissing * static_cast<double>(stamps)) continue;
        failAt(files.back().path, "is missing: the folder has " + std::to_string(count) +
                                      " files *" + extension + ", " + timestamps.string() +
                                      " has " + std::to_string(stamps) + " times");
    }
    if (count + missing == stamps) return files;
    failAt(folder, "has " + std::to_string(count) + " files *" + extension + ", but " +
                       timestamps.string() + " has " + std::to_string(stamps) + " times");
}

KittiOxts oxtsOf(const fs::path& path, mrpt::Clock::time_point time)
{
    constexpr std::size_t kValues = 30;
    constexpr std::size_t kSatellites = 26;
    const std::vector<double> v = numbersOf(readTextFile(path), path.string() + ":1", kValues);
    KittiOxts oxts{time, v[0], v[1], v[2], v[3], v[4], v[5], 0};
    if (std::abs(oxts.latitude) >= 90.0)
        failAt(path, "latitude " + toText(v[0]) + " is not on earth");
    if (v[kSatellites] >= 0.0 && v[kSatellites] < 256.0)
        oxts.satellites = static_cast<int>(v[kSatellites]);
    return oxts;
}

fs::path calibrationFile(const fs::path& folder)
{
    constexpr const char* kName = "calib_imu_to_velo.txt";
    const fs::path beside = fs::canonical(folder).parent_path() / kName;
    for (const fs::path& path : {beside, folder / kName})
    {
        if (fs::exists(path)) return path;
    }
    failAt(beside,
           "is missing (nor is it in the drive's folder); unpack the calibration of the day"
           " (like 2011_09_26_calib.zip) beside the drive");
}
}  // namespace

KittiDrive readKittiDrive(const fs::path& folder)
{
    checkFolder(folder);
    KittiDrive drive;
    drive.folder = folder;
    drive.velodyneInVehicle = readRigidTransform(calibrationFile(folder)).inverse();
    constexpr double kFewScans = 0.1;
    drive.scans = stampedFiles(folder / "velodyne_points", ".bin", kFewScans);
    for (const KittiFile& sample : stampedFiles(folder / "oxts", ".txt", 0.0))
        drive.oxts.push_back(oxtsOf(sample.path, sample.time));
    if (drive.scans.size() != drive.oxts.size())
    {
        failAt(folder, "has " + std::to_string(drive.scans.size()) + " scans, but " +
                           std::to_string(drive.oxts.size()) +
                           " oxts samples; a synchronised drive (_sync) has as many of both");
    }
    return drive;
}

}  // namespace vdamf
