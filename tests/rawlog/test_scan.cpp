// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/scan.h"

#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <cmath>
#include <limits>

#include "../files/temporary_folder.h"
#include "example_objects.h"
#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationPointCloud;

class ScanTest : public TemporaryFolder
{
};

mrpt::obs::CObservation2DRangeScan lineScan()
{
    mrpt::obs::CObservation2DRangeScan line;
    line.timestamp = mrpt::Clock::fromDouble(1.5e9);
    line.sensorLabel = "bumper";
    line.aperture = static_cast<float>(kPi);
    line.rightToLeft = true;
    line.maxRange = 80.0F;
    line.sensorPose = mrpt::poses::CPose3D(3.5, 0.0, 0.5, 0.0, 0.0, 0.0);
    line.resizeScanAndAssign(5, 10.0F, true);
    return line;
}

TEST_F(ScanTest, IsOfAClassThatHasPoints)
{
    EXPECT_TRUE(isScan(test::pointCloud(1)));
    EXPECT_TRUE(isScan(mrpt::obs::CObservationVelodyneScan()));
    EXPECT_TRUE(isScan(lineScan()));
    EXPECT_TRUE(isLineScan(lineScan()));
    EXPECT_TRUE(isMinorScan(lineScan()));
    EXPECT_FALSE(isMinorScan(test::pointCloud(1)));
    EXPECT_FALSE(isLineScan(test::pointCloud(1)));
    EXPECT_FALSE(isScan(test::odometry(1)));
    EXPECT_FALSE(scanFrom(test::odometry(1)).has_value());
}

TEST_F(ScanTest, PointsAreInTheVehicleFrame)
{
    CObservationPointCloud observation = test::pointCloud(3, 1.5e9 + 0.125);
    // Turned left, tilted down by 30 degrees, 2 m above the vehicle.
    observation.sensorPose = mrpt::poses::CPose3D(1.0, 0.0, 2.0, kPi / 2.0, kPi / 6.0, 0.0);
    const auto scan = scanFrom(observation);
    ASSERT_TRUE(scan);
    EXPECT_NEAR(1.5e9 + 0.125, scan->time, 1e-6);
    EXPECT_EQ("ladar", scan->sensorLabel);
    EXPECT_EQ(Eigen::Vector3d(1.0, 0.0, 2.0), scan->sensorInVehicle);
    ASSERT_EQ(3u, scan->points.size());
    // Sensor point (2, 1, 1): forward leans down, up leans forward, then forward is left.
    const double c = std::cos(kPi / 6.0);
    const double s = std::sin(kPi / 6.0);
    EXPECT_NEAR(1.0 - 1.0, scan->points.x[1], 1e-5);
    EXPECT_NEAR(2.0 * c + 1.0 * s, scan->points.y[1], 1e-5);
    EXPECT_NEAR(2.0 - 2.0 * s + 1.0 * c, scan->points.z[1], 1e-5);
    EXPECT_EQ(std::vector<float>(3, 0.25F), scan->points.intensity);
    EXPECT_TRUE(scan->points.time.empty());
}

TEST_F(ScanTest, DropsWhatIsNoReturn)
{
    CObservationPointCloud observation = test::pointCloud(5);
    auto& map = *observation.pointcloud;
    map.setPointFast(1, 0.0F, 0.0F, 0.0F);
    map.setPointFast(3, std::nanf(""), 1.0F, 1.0F);
    map.setPointFast(4, std::numeric_limits<float>::infinity(), 1.0F, 1.0F);
    const auto scan = scanFrom(observation);
    ASSERT_TRUE(scan);
    EXPECT_EQ(std::vector<float>({1.0F, 3.0F}), scan->points.x);
    EXPECT_EQ(2u, scan->points.intensity.size());
}

TEST_F(ScanTest, ScalesIntensitiesToOne)
{
    CObservationPointCloud observation = test::pointCloud(2);
    auto& map = dynamic_cast<mrpt::maps::CPointsMapXYZI&>(*observation.pointcloud);
    map.setPointIntensity(0, 255.0F);
    map.setPointIntensity(1, 51.0F);
    EXPECT_EQ(std::vector<float>({1.0F, 0.2F}), scanFrom(observation)->points.intensity);
}

TEST_F(ScanTest, PlainPointsHaveNoIntensity)
{
    CObservationPointCloud observation = test::pointCloud(0);
    auto map = mrpt::maps::CSimplePointsMap::Create();
    map->insertPoint(1.0F, 2.0F, 3.0F);
    observation.pointcloud = map;
    const auto scan = scanFrom(observation);
    ASSERT_EQ(1u, scan->points.size());
    EXPECT_TRUE(scan->points.intensity.empty());
}

TEST_F(ScanTest, LoadsPointsFromTheirFileForAWhile)
{
    CObservationPointCloud observation = test::pointCloud(7);
    const auto file = at("points.bin");
    observation.setAsExternalStorage(
        file, CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
    observation.unload();
    ASSERT_TRUE(std::filesystem::exists(file));
    const auto scan = scanFrom(observation);
    EXPECT_EQ(7u, scan->points.size());
    EXPECT_FALSE(observation.pointcloud);
}

TEST_F(ScanTest, FindsExternalFilesWhereverTheRawlogLies)
{
    using Format = CObservationPointCloud::ExternalStorageFormat;
    const std::filesystem::path folder = at("drives");
    CObservationPointCloud named = test::pointCloud(0);
    named.pointcloud.reset();
    named.setAsExternalStorage("cloud_1.bin", Format::MRPT_Serialization);
    for (const char* place : {"day_Images", "day_images", "day_IMAGES", "."})
    {
        std::filesystem::create_directories(folder / place);
        CObservationPointCloud observation = test::pointCloud(7);
        observation.setAsExternalStorage(folder / place / "cloud_1.bin",
                                         Format::MRPT_Serialization);
        observation.unload();
        for (const char* rawlog : {"day.rawlog", "day.rawlog.gz"})
        {
            const auto scan = scanFrom(named, ExternalFiles(folder / rawlog));
            EXPECT_EQ(scan->points.size(), 7U) << place << ", " << rawlog;
        }
        // From a folder of another machine.
        CObservationPointCloud moved = test::pointCloud(0);
        moved.pointcloud.reset();
        moved.setAsExternalStorage("/home/other/day_Images/cloud_1.bin",
                                   Format::MRPT_Serialization);
        EXPECT_EQ(scanFrom(moved, ExternalFiles(folder / "day.rawlog"))->points.size(), 7U);
        std::filesystem::remove_all(folder);
    }
    std::filesystem::create_directories(folder);
    const std::string error =
        errorOf([&] { scanFrom(named, ExternalFiles(folder / "day.rawlog")); });
    EXPECT_NE(error.find("'cloud_1.bin' is missing; searched in " + folder.string()),
              std::string::npos)
        << error;
    test::writeBytes(folder / "cloud_1.bin", "this is no cloud");
    EXPECT_THROW(scanFrom(named, ExternalFiles(folder / "day.rawlog")), std::runtime_error);
    EXPECT_TRUE(std::filesystem::exists(folder / "cloud_1.bin"));
}

/// A cloud as newer versions of MRPT store it: `n` points with intensities, rings and times, as far
/// as asked for.
std::string cloudOfNewerMrpt(std::uint32_t n, bool fields)
{
    const std::string old = serialized(test::pointCloud(static_cast<int>(n)));
    const std::string oldName = std::string("\x9a") + "mrpt::maps::CPointsMapXYZI" + '\0';
    const std::size_t name = old.find(oldName);
    const std::size_t points = name + oldName.size();
    const std::size_t intensities = points + 4 + 12 * n;
    const std::size_t options = intensities + 4 * n;
    const auto bytes = [](const auto& value)
    { return std::string(reinterpret_cast<const char*>(&value), sizeof(value)); };
    std::string added = bytes(fields ? n : 0U);
    if (fields) added += old.substr(intensities, 4 * n);
    added += bytes(fields ? n : 0U);
    for (std::uint16_t i = 0; fields && i < n; ++i) added += bytes(i);
    added += bytes(fields ? n : 0U);
    for (std::uint32_t i = 0; fields && i < n; ++i) added += bytes(0.01F * static_cast<float>(i));
    return old.substr(0, name) + "\x9cmrpt::maps::CPointsMapXYZIRT" + '\0' +
           old.substr(points, intensities - points) + added + old.substr(options);
}

TEST_F(ScanTest, OfNewerMrptHasTimes)
{
    const std::string whole = cloudOfNewerMrpt(5, true) + cloudOfNewerMrpt(4, false);
    RawlogReader reader(make("newer.rawlog", whole));
    const auto entries = test::entriesOf(reader);
    ASSERT_EQ(entries.size(), 2U) << reader.summary().problems.size();
    const auto timed = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entries[0].object);
    ASSERT_TRUE(timed);
    const auto scan = scanFrom(*timed);
    ASSERT_EQ(scan->points.time.size(), 5U);
    EXPECT_NEAR(scan->points.time[3], 0.03F, 1e-7F);
    EXPECT_FLOAT_EQ(scan->points.intensity[3], 0.25F);
    EXPECT_NEAR(durationOf(*timed), 0.04, 1e-7);
    const auto plain = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entries[1].object);
    ASSERT_TRUE(plain);
    EXPECT_EQ(scanFrom(*plain)->points.size(), 4U);
    EXPECT_TRUE(scanFrom(*plain)->points.intensity.empty());
    EXPECT_TRUE(scanFrom(*plain)->points.time.empty());
    // It goes out as it came in.
    EXPECT_TRUE(serialized(*timed) + serialized(*plain) == whole);
}

TEST_F(ScanTest, SaysWhatItCannotRead)
{
    CObservationPointCloud observation = test::pointCloud(0);
    observation.pointcloud.reset();
    EXPECT_EQ("mrpt::obs::CObservationPointCloud 'ladar': it has no point cloud",
              errorOf([&] { scanFrom(observation); }));
    observation.setAsExternalStorage(
        at("missing.bin"), CObservationPointCloud::ExternalStorageFormat::MRPT_Serialization);
    const std::string error = errorOf([&] { scanFrom(observation); });
    EXPECT_NE(std::string::npos, error.find("missing.bin")) << error;
    EXPECT_EQ(std::string::npos, error.find("backtrace")) << error;
    EXPECT_FALSE(std::filesystem::exists(at("missing.bin")));

    CObservationPointCloud timeless = test::pointCloud(1);
    timeless.timestamp = INVALID_TIMESTAMP;
    EXPECT_NE(std::string::npos, errorOf([&] { scanFrom(timeless); }).find("no time"));
}

TEST_F(ScanTest, OfVelodynePackets)
{
    VelodyneFiring firing;
    firing.range.assign(16, 20.0F);
    firing.intensity.assign(16, 1.0F);
    auto observation = encodeVelodyne(VelodyneModel::VLP16, 1.5e9, {firing, firing});
    observation.sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 2.0, kPi, 0.0, 0.0);
    observation.sensorLabel = "top";
    const auto scan = scanFrom(observation);
    ASSERT_TRUE(scan);
    ASSERT_EQ(32u, scan->points.size());
    EXPECT_NEAR(-20.0 * std::cos(kPi / 12.0), scan->points.x[0], 1e-4);
    EXPECT_NEAR(2.0 - 20.0 * std::sin(kPi / 12.0), scan->points.z[0], 1e-4);
    EXPECT_NEAR(55.296e-6, scan->points.time[16], 1e-8);
}

TEST_F(ScanTest, OfVelodynePacketsLastsAsLongAsItsFirings)
{
    VelodyneFiring firing;
    firing.range.assign(16, 20.0F);
    firing.intensity.assign(16, 1.0F);
    const auto observation =
        encodeVelodyne(VelodyneModel::VLP16, 1.5e9, std::vector<VelodyneFiring>(1800, firing));
    const double last = scanFrom(observation)->points.time.back();
    EXPECT_GT(last, 0.099);
    EXPECT_GE(durationOf(observation), last);
    EXPECT_LT(durationOf(observation), last + 1e-4);
    EXPECT_EQ(0.0, durationOf(test::pointCloud(3)));
    EXPECT_EQ(0.0, durationOf(mrpt::obs::CObservationVelodyneScan()));
    EXPECT_EQ(0.0, durationOf(test::odometry(1)));
}

TEST_F(ScanTest, OfALineRunsFromRightToLeftOrBack)
{
    mrpt::obs::CObservation2DRangeScan line = lineScan();
    const auto scan = scanFrom(line);
    ASSERT_TRUE(scan);
    ASSERT_EQ(5u, scan->points.size());
    EXPECT_NEAR(-10.0, scan->points.y[0], 1e-5);
    EXPECT_NEAR(13.5, scan->points.x[2], 1e-5);
    EXPECT_NEAR(10.0, scan->points.y[4], 1e-5);
    EXPECT_NEAR(0.5, scan->points.z[1], 1e-6);
    EXPECT_TRUE(scan->points.intensity.empty());
    EXPECT_TRUE(scan->points.time.empty());
    line.rightToLeft = false;
    EXPECT_NEAR(10.0, scanFrom(line)->points.y[0], 1e-5);
}

TEST_F(ScanTest, OfALineHasOnlyValidRaysInRange)
{
    mrpt::obs::CObservation2DRangeScan line = lineScan();
    line.setScanHasIntensity(true);
    for (std::size_t i = 0; i < 5; ++i) line.setScanIntensity(i, 51 * static_cast<int>(i + 1));
    line.setScanRangeValidity(0, false);
    line.setScanRange(1, 80.0F);
    line.setScanRange(3, 0.0F);
    line.setScanRange(4, std::nanf(""));
    const auto scan = scanFrom(line);
    ASSERT_EQ(1u, scan->points.size());
    EXPECT_NEAR(13.5, scan->points.x[0], 1e-5);
    EXPECT_FLOAT_EQ(0.6F, scan->points.intensity[0]);
    line.resizeScan(0);
    EXPECT_TRUE(scanFrom(line)->points.empty());
    line.resizeScanAndAssign(1, 10.0F, true);
    EXPECT_NEAR(13.5, scanFrom(line)->points.x[0], 1e-5);
}

TEST_F(ScanTest, OfALineIsPlanarWhereItIsLevel)
{
    mrpt::obs::CObservation2DRangeScan line = lineScan();
    EXPECT_TRUE(scanFrom(line)->planar);
    line.sensorPose = mrpt::poses::CPose3D(3.5, 0.0, 0.5, 1.0, 0.0, kPi);  // upside down
    EXPECT_TRUE(scanFrom(line)->planar);
    line.sensorPose = mrpt::poses::CPose3D(3.5, 0.0, 0.5, 1.0, 0.1, 0.0);  // looks at the road
    EXPECT_FALSE(scanFrom(line)->planar);
    EXPECT_FALSE(scanFrom(test::pointCloud(3))->planar);
}

}  // namespace
}  // namespace vdamf
