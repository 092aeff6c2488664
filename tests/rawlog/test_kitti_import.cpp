// SPDX-License-Identifier: BSD-3-Clause
// A drive to a rawlog and its truth: read back with MRPT's own reader.
#include "vdamf/rawlog/kitti_import.h"

#include <gmock/gmock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/serialization/CArchive.h>

#include "../files/temporary_folder.h"
#include "kitti_example_drive.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservationGPS;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRobotPose;
using ::testing::HasSubstr;

std::vector<CObservation::Ptr> observationsOf(const std::filesystem::path& rawlog)
{
    mrpt::io::CFileGZInputStream file(rawlog.string());
    auto archive = mrpt::serialization::archiveFrom(file);
    std::vector<CObservation::Ptr> observations;
    try
    {
        for (;;) observations.push_back(archive.ReadObject<CObservation>());
    }
    catch (const mrpt::serialization::CExceptionEOF&)
    {
    }
    return observations;
}

class KittiImportTest : public TemporaryFolder
{
protected:
    KittiImportTest() : drive_(at("day"))
    {
        std::filesystem::create_directories(at("out"));
        job_.drive = drive_.folder();
        job_.rawlog = at("out/o.rawlog");
        job_.truth = at("out/truth.csv");
    }

    std::size_t outputs() const
    {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(at("out")), {}));
    }

    // The error of the import; nothing may stay behind.
    std::string error() const
    {
        const std::string what = errorOf([&] { importKittiDrive(job_); });
        EXPECT_EQ(outputs(), 0U) << what;
        return what;
    }

    void expectProgress(std::size_t scans)
    {
        job_.progress = [this, scans](std::size_t done, std::size_t all)
        {
            EXPECT_EQ(done, ++calls_);
            EXPECT_EQ(all, scans);
            return true;
        };
    }

    KittiExampleDrive drive_;
    KittiImport job_;
    std::size_t calls_ = 0;
};

TEST_F(KittiImportTest, SummaryCounts)
{
    expectProgress(3U);
    const KittiImportSummary summary = importKittiDrive(job_);
    EXPECT_EQ(calls_, 3U);
    EXPECT_EQ(summary.scans, 3U);
    EXPECT_EQ(summary.poses, 3U);
    EXPECT_NEAR(summary.seconds, 0.2, 1e-6);
    EXPECT_EQ(summary.points, 12U);
    EXPECT_EQ(summary.objects, 2U);
    EXPECT_EQ(summary.labels, 5U);
    EXPECT_EQ(summary.labelsWithoutPose, 0U);
    EXPECT_FALSE(summary.stopped);
    EXPECT_EQ(outputs(), 2U);
}

// As drive 0009 of 2011_09_26 is published.
TEST_F(KittiImportTest, AFewScansMayBeMissing)
{
    drive_.lengthenTo(12);
    std::filesystem::remove(drive_.scanFile(1));
    expectProgress(12U);
    const KittiImportSummary summary = importKittiDrive(job_);
    EXPECT_EQ(calls_, 12U);
    EXPECT_EQ(summary.scans, 11U);
    EXPECT_EQ(summary.missingScans, 1U);
    EXPECT_EQ(summary.poses, 12U);
    EXPECT_EQ(summary.labels, 3U) << "of frames 0 and 2";
    EXPECT_EQ(summary.labelsWithoutPose, 0U);
}

TEST_F(KittiImportTest, EntriesAreOrderedAndStamped)
{
    importKittiDrive(job_);
    const auto all = observationsOf(job_.rawlog);
    ASSERT_EQ(all.size(), 9U);
    const char* labels[] = {"ins", "gps", "velodyne"};
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        EXPECT_EQ(all[i]->sensorLabel, labels[i % 3]);
        EXPECT_GE(all[i]->timestamp, all[i > 0 ? i - 1 : 0]->timestamp);
    }
    // 2011-09-26 13:02:26.164000049 in ticks since 1601.
    EXPECT_EQ(all[8]->timestamp.time_since_epoch().count(), 129'615'157'461'640'000);
}

TEST_F(KittiImportTest, PoseOfTheVehicle)
{
    importKittiDrive(job_);
    const auto pose =
        std::dynamic_pointer_cast<CObservationRobotPose>(observationsOf(job_.rawlog).at(6));
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->pose.mean.x(), 0.0, 1e-6);
    EXPECT_NEAR(pose->pose.mean.y(), 2.0, 1e-6);
    EXPECT_NEAR(pose->pose.mean.z(), 0.0, 1e-6);
    EXPECT_NEAR(pose->pose.mean.yaw(), std::acos(0.0), 1e-9);
    EXPECT_NEAR(pose->pose.cov(1, 1), 0.0025, 1e-12);
    EXPECT_NEAR(pose->pose.cov(3, 3), 3.0462e-6, 1e-9);
    EXPECT_EQ(pose->pose.cov(0, 1), 0.0);
}

TEST_F(KittiImportTest, GpsHasPositionAndTime)
{
    importKittiDrive(job_);
    const auto gps = std::dynamic_pointer_cast<CObservationGPS>(observationsOf(job_.rawlog).at(1));
    ASSERT_TRUE(gps);
    ASSERT_TRUE(gps->hasMsgClass<mrpt::obs::gnss::Message_NMEA_GGA>());
    // The message is packed: take copies, not references.
    const auto& gga = gps->getMsgByClass<mrpt::obs::gnss::Message_NMEA_GGA>().fields;
    const double latitude = gga.latitude_degrees;
    const double longitude = gga.longitude_degrees;
    const double altitude = gga.altitude_meters;
    const std::uint32_t satellites = gga.satellitesUsed;
    const int hour = gga.UTCTime.hour;
    const int minute = gga.UTCTime.minute;
    const double second = gga.UTCTime.sec;
    EXPECT_EQ(latitude, 49.0);
    EXPECT_EQ(longitude, 8.4);
    EXPECT_EQ(altitude, 116.5);
    EXPECT_EQ(satellites, 9U);
    EXPECT_EQ(hour, 13);
    EXPECT_EQ(minute, 2);
    EXPECT_NEAR(second, 25.964, 1e-6);
}

TEST_F(KittiImportTest, PointsStayInTheSensorsFrame)
{
    importKittiDrive(job_);
    const auto scan =
        std::dynamic_pointer_cast<CObservationPointCloud>(observationsOf(job_.rawlog).at(5));
    ASSERT_TRUE(scan);
    EXPECT_NEAR(scan->sensorPose.x(), 1.0, 1e-12);
    EXPECT_NEAR(scan->sensorPose.z(), 0.5, 1e-12);
    const auto map = std::dynamic_pointer_cast<mrpt::maps::CPointsMapXYZI>(scan->pointcloud);
    ASSERT_TRUE(map);
    ASSERT_EQ(map->size(), 4U);
    EXPECT_EQ(map->getPointsBufferRef_x()[0], 19.0F);
    EXPECT_EQ(map->getPointsBufferRef_y()[1], 2.1F);
    EXPECT_EQ(map->getPointsBufferRef_z()[3], -1.7F);
    EXPECT_EQ(map->getPointIntensity(2), 0.75F);
}

TEST_F(KittiImportTest, TruthIsInTheWorld)
{
    importKittiDrive(job_);
    const std::vector<TruthRow> rows = readTruth(*job_.truth);
    ASSERT_EQ(rows.size(), 5U);
    const char* ids[] = {"0", "0", "1", "0", "1"};
    const int points[] = {2, 2, 0, 2, 0};
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        EXPECT_EQ(rows[i].objectId, ids[i]);
        EXPECT_EQ(rows[i].points, points[i]) << i;
        EXPECT_EQ(rows[i].box.length, 4.0);
        EXPECT_EQ(rows[i].box.width, 2.0);
        EXPECT_EQ(rows[i].height, 1.5);
        EXPECT_NEAR(rows[i].z, 0.5 - 1.75, 1e-4);
    }
    // The parked car: 1 + 20 m north of the origin, 3 m to the left (west), facing south.
    EXPECT_EQ(rows[3].objectClass, "Car");
    EXPECT_NEAR(rows[3].box.x, -3.0, 1e-4);
    EXPECT_NEAR(rows[3].box.y, 21.0, 1e-4);
    EXPECT_NEAR(rows[3].box.heading, -std::acos(0.0), 1e-6);
    EXPECT_NEAR(rows[3].speed, 0.0, 1e-3);
    // The van at 10 m/s, 15 m ahead of the velodyne in the last scan.
    EXPECT_EQ(rows[4].objectClass, "Van");
    EXPECT_NEAR(rows[4].box.x, 0.0, 1e-4);
    EXPECT_NEAR(rows[4].box.y, 18.0, 1e-4);
    EXPECT_NEAR(rows[4].speed, 10.0, 1e-2);
    EXPECT_NEAR(rows[4].time, 1317042146.164, 1e-6);
    // The velodyne, 1 m ahead of the vehicle that heads north by 1 m a scan.
    const int frames[] = {0, 1, 1, 2, 2};
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        ASSERT_TRUE(rows[i].sensor) << i;
        EXPECT_NEAR(rows[i].sensor->x, 0.0, 1e-4);
        EXPECT_NEAR(rows[i].sensor->y, 1.0 + frames[i], 1e-4);
        EXPECT_NEAR(rows[i].sensor->heading, std::acos(0.0), 1e-6);
    }
}

TEST_F(KittiImportTest, WithoutTruthNoLabelsAreNeeded)
{
    std::filesystem::remove(drive_.trackletFile());
    EXPECT_THAT(error(), HasSubstr("tracklet_labels.xml: is missing, but the truth is asked for"));
    job_.truth.reset();
    EXPECT_EQ(importKittiDrive(job_).labels, 0U);
    EXPECT_EQ(outputs(), 1U);
}

TEST_F(KittiImportTest, PlainFileAtLevelZero)
{
    job_.gzLevel = 0;
    importKittiDrive(job_);
    EXPECT_EQ(observationsOf(job_.rawlog).size(), 9U);
    // A plain rawlog starts with the length of the first class name.
    EXPECT_EQ(contentOf("out/o.rawlog").substr(1, 32), "mrpt::obs::CObservationRobotPose");
}

TEST_F(KittiImportTest, AFailureLeavesNothing)
{
    KittiExampleDrive::write(drive_.scanFile(2), KittiExampleDrive::scan(2).substr(0, 50));
    EXPECT_THAT(error(), HasSubstr("0000000002.bin: has 50 bytes"));
    std::filesystem::remove(drive_.scanFile(2));
    EXPECT_THAT(error(), HasSubstr("0000000002.bin: is missing"));
}

TEST_F(KittiImportTest, StopsOnRequest)
{
    job_.progress = [](std::size_t done, std::size_t) { return done < 2; };
    const KittiImportSummary summary = importKittiDrive(job_);
    EXPECT_TRUE(summary.stopped);
    EXPECT_EQ(summary.scans, 2U);
    EXPECT_EQ(outputs(), 0U);
}

TEST_F(KittiImportTest, KeepsExistingOutputs)
{
    make("out/truth.csv", "precious");
    EXPECT_THAT(errorOf([&] { importKittiDrive(job_); }), HasSubstr("--overwrite"));
    EXPECT_EQ(contentOf("out/truth.csv"), "precious");
    EXPECT_EQ(outputs(), 1U);
    job_.existing = OutputFile::Existing::Overwrite;
    importKittiDrive(job_);
    EXPECT_EQ(readTruth(*job_.truth).size(), 5U);
    EXPECT_EQ(outputs(), 2U);
}

TEST_F(KittiImportTest, OneFileCannotBeBoth)
{
    job_.truth = at("out/../out/o.rawlog");
    EXPECT_THAT(error(), HasSubstr("is named for two outputs"));
}

TEST_F(KittiImportTest, NothingOfTheDriveIsWrittenOver)
{
    job_.existing = OutputFile::Existing::Overwrite;
    const std::filesystem::path truth = *job_.truth;
    const std::filesystem::path rawlog = job_.rawlog;
    for (const std::filesystem::path& input :
         {job_.drive / "velodyne_points/data/0000000000.bin",
          job_.drive / "oxts/data/0000000001.txt",
          job_.drive.parent_path() / "calib_imu_to_velo.txt", job_.drive / "tracklet_labels.xml",
          job_.drive / "oxts/timestamps.txt"})
    {
        ASSERT_TRUE(std::filesystem::exists(input)) << input;
        const auto size = std::filesystem::file_size(input);
        job_.rawlog = input;
        EXPECT_THAT(error(), HasSubstr("the drive")) << input;
        job_.rawlog = rawlog;
        job_.truth = input;
        EXPECT_THAT(error(), HasSubstr("choose another output")) << input;
        job_.truth = truth;
        EXPECT_EQ(std::filesystem::file_size(input), size);
    }
}

}  // namespace
}  // namespace vdamf
