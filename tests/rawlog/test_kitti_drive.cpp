// SPDX-License-Identifier: BSD-3-Clause
// Reading a KITTI drive: times, poses, calibration, points, and what is refused.
#include "vdamf/rawlog/kitti_drive.h"

#include <gmock/gmock.h>

#include <limits>

#include "../files/temporary_folder.h"
#include "kitti_example_drive.h"
#include "replaced_text.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using ::testing::EndsWith;
using ::testing::HasSubstr;

class KittiDriveTest : public TemporaryFolder
{
protected:
    // The error of reading the drive when one of its files has other bytes.
    std::string errorWith(const std::filesystem::path& file, const std::string& bytes)
    {
        const KittiExampleDrive drive(at("day"));
        KittiExampleDrive::write(file, bytes);
        return errorOf([&] { readKittiDrive(drive.folder()); });
    }
    std::string errorWithout(const std::filesystem::path& file)
    {
        const KittiExampleDrive drive(at("day"));
        std::filesystem::remove_all(file);
        return errorOf([&] { readKittiDrive(drive.folder()); });
    }

    std::filesystem::path inDrive(const std::string& name) const
    {
        return at("day/2011_09_26_drive_0042_sync") / name;
    }

    std::string timeError(const std::string& text)
    {
        const auto path = make("times.txt", text);
        return errorOf([&] { readKittiTimestamps(path); });
    }
};

TEST_F(KittiDriveTest, ReadsTheDrive)
{
    const KittiExampleDrive example(at("day"));
    const KittiDrive drive = readKittiDrive(example.folder());
    ASSERT_EQ(drive.scans.size(), 3U);
    ASSERT_EQ(drive.oxts.size(), 3U);
    EXPECT_EQ(drive.scans[2].path, example.scanFile(2));
    EXPECT_EQ(drive.oxts[0].latitude, 49.0);
    EXPECT_EQ(drive.oxts[0].altitude, 116.5);
    EXPECT_EQ(drive.oxts[0].satellites, 9);
    // The file holds the INS in the velodyne's frame.
    EXPECT_TRUE(drive.velodyneInVehicle.translation().isApprox(Eigen::Vector3d(1.0, 0.0, 0.5)));
}

TEST_F(KittiDriveTest, TakesCalibrationFromTheDrivesFolderToo)
{
    const KittiExampleDrive example(at("day"));
    const auto beside = at("day") / "calib_imu_to_velo.txt";
    std::filesystem::rename(beside, example.folder() / "calib_imu_to_velo.txt");
    EXPECT_EQ(readKittiDrive(example.folder()).scans.size(), 3U);
}

TEST_F(KittiDriveTest, PosesAreMercatorFromTheFirstSample)
{
    const KittiExampleDrive example(at("day"));
    KittiDrive drive = readKittiDrive(example.folder());
    const auto poses = kittiPoses(drive.oxts);
    for (int i = 0; i < 3; ++i)
    {
        const Eigen::Vector3d north(0.0, i, 0.0);
        EXPECT_LT((poses[static_cast<std::size_t>(i)].translation() - north).norm(), 1e-6);
    }
    // Yaw 90 degrees: forward is north, left is west.
    EXPECT_LT((poses[0].linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
              1e-12);
    // East: a degree of longitude is 111.3 km times the cosine of the latitude.
    drive.oxts[1] = drive.oxts[0];
    drive.oxts[1].longitude += 1e-3;
    drive.oxts[1].pitch = 0.1;
    const Eigen::Isometry3d east = kittiPoses(drive.oxts)[1];
    const double expected = 6378137.0 * 1e-3 * kPi / 180.0 * std::cos(49.0 * kPi / 180.0);
    EXPECT_LT((east.translation() - Eigen::Vector3d(expected, 0.0, 0.0)).norm(), 1e-6);
    // Positive pitch: the front points down.
    EXPECT_NEAR((east.linear() * Eigen::Vector3d::UnitX()).z(), -std::sin(0.1), 1e-12);
}

TEST_F(KittiDriveTest, TimesKeepTheirTicks)
{
    const auto times = readKittiTimestamps(
        make("t.txt",
             "1970-01-01 00:00:00.0\n2000-02-29 23:59:59.999999949\r\n"
             "2011-09-26 13:02:25.963999987\n2011-09-26 13:02:25.964000051\n\n"));
    ASSERT_EQ(times.size(), 4U);
    EXPECT_EQ(mrpt::Clock::toDouble(times[0]), 0.0);
    constexpr std::int64_t kUnix = 116'444'736'000'000'000;  // ticks from 1601 to 1970
    EXPECT_EQ(times[1].time_since_epoch().count() - kUnix, 9'518'687'999'999'999);
    EXPECT_EQ(times[2].time_since_epoch().count() - kUnix, 13'170'421'459'640'000);
    EXPECT_EQ(times[3].time_since_epoch().count() - kUnix, 13'170'421'459'640'001);
}

TEST_F(KittiDriveTest, TimesMayBeginWithAByteOrderMark)
{
    const std::string mark = "\xEF\xBB\xBF";
    EXPECT_EQ(timeError(mark + "2011-09-26 13:02:25.96\n2011-09-26 13:02:26.06\n"),
              "(nothing thrown)");
}

TEST_F(KittiDriveTest, RefusesBadTimes)
{
    const std::string good = "2011-09-26 13:02:25.96\n";
    for (const char* bad :
         {"13:02:25.96", "2011-09-26 13:02:25", "2011-09-26T13:02:25.96", "2011-13-26 13:02:25.96",
          "2011-09-26 24:02:25.96", "2011-09-26 13:02:25.9x", "2011-09-26 13:02:25.1234567890",
          "2011-09-26 13:-2:25.96", ""})
    {
        const std::string rest = std::string(bad).empty() ? "\n\n" + good : std::string(bad);
        EXPECT_THAT(timeError(good + rest),
                    HasSubstr("times.txt:2: expected a time like 2011-09-26"))
            << bad;
    }
    EXPECT_THAT(timeError(good + "2011-09-26 13:02:25.95\n"),
                HasSubstr("times.txt:2: the time is not after that of the line before"));
}

TEST_F(KittiDriveTest, RefusesDatesThatAreInNoCalendar)
{
    const auto errorOn = [this](const std::string& date)
    { return timeError("1999-01-01 00:00:00.0\n" + date + " 13:02:25.9\n"); };
    for (const char* bad : {"2011-02-30", "2011-02-29", "2100-02-29", "2012-02-30", "2011-04-31",
                            "2011-06-31", "2011-09-31", "2011-11-31", "2011-12-32", "2011-01-00"})
        EXPECT_THAT(errorOn(bad), HasSubstr("times.txt:2: expected a time like 2011-09-26")) << bad;
    for (const char* good : {"2011-02-28", "2012-02-29", "2000-02-29", "2011-04-30", "2011-01-31",
                             "2011-07-31", "2011-08-31", "2011-12-31"})
        EXPECT_EQ(errorOn(good), "(nothing thrown)") << good;
}

TEST_F(KittiDriveTest, NamesMissingFiles)
{
    EXPECT_THAT(errorOf([&] { readKittiDrive(at("none")); }), HasSubstr("there is no such folder"));
    EXPECT_THAT(errorOf([&] { readKittiDrive(at("")); }), HasSubstr("not a KITTI raw drive"));
    EXPECT_THAT(errorWithout(inDrive("oxts")), HasSubstr("there is no folder oxts/data"));
    EXPECT_THAT(errorWithout(inDrive("oxts/timestamps.txt")),
                HasSubstr("oxts/timestamps.txt: cannot read: No such file"));
    EXPECT_THAT(errorWithout(inDrive("velodyne_points/data/0000000001.bin")),
                HasSubstr("0000000001.bin: is missing: the folder has 2 files *.bin, "));
    EXPECT_THAT(errorWithout(at("day/calib_imu_to_velo.txt")),
                HasSubstr("calib_imu_to_velo.txt: is missing"));
}

// More than a tenth of them: not all of it was unpacked.
TEST_F(KittiDriveTest, ManyScansMayNotBeMissing)
{
    const KittiExampleDrive drive(at("day"));
    drive.lengthenTo(12);
    std::filesystem::remove(drive.scanFile(1));
    EXPECT_FALSE(readKittiDrive(drive.folder()).scans.at(1).isThere);
    std::filesystem::remove(drive.scanFile(4));
    EXPECT_THAT(errorOf([&] { readKittiDrive(drive.folder()); }),
                HasSubstr("0000000004.bin: is missing: the folder has 10 files *.bin, "));
}

TEST_F(KittiDriveTest, NamesCountsThatDisagree)
{
    const std::string two = KittiExampleDrive::timestamps().substr(0, 60);
    EXPECT_THAT(errorWith(inDrive("oxts/timestamps.txt"), two),
                HasSubstr("oxts/data: has 3 files *.txt, but "));
    EXPECT_THAT(errorWith(inDrive("oxts/timestamps.txt"), ""), EndsWith("has no times"));
    const KittiExampleDrive drive(at("day"));
    std::filesystem::remove(drive.oxtsFile(2));
    KittiExampleDrive::write(inDrive("oxts/timestamps.txt"), two);
    EXPECT_THAT(errorOf([&] { readKittiDrive(drive.folder()); }),
                HasSubstr("has 3 scans, but 2 oxts samples"));
}

TEST_F(KittiDriveTest, NamesBadNumbers)
{
    const auto oxts = inDrive("oxts/data/0000000001.txt");
    const std::string good = KittiExampleDrive::oxts(1);
    EXPECT_THAT(errorWith(oxts, replaced(good, "8.4", "8,4")),
                HasSubstr("0000000001.txt:1: value 2: expected a finite number, found '8,4'"));
    EXPECT_THAT(errorWith(oxts, replaced(good, "8.4", "nan")), HasSubstr("value 2"));
    EXPECT_THAT(errorWith(oxts, "49 8.4 116\n"), HasSubstr("expected 30 numbers, found 3"));
    EXPECT_THAT(errorWith(oxts, "9" + good), HasSubstr("is not on earth"));
    const auto calibration = at("day/calib_imu_to_velo.txt");
    EXPECT_THAT(errorWith(calibration, "T: 0 0 0\n"), HasSubstr("there is no line 'R: ...'"));
    EXPECT_THAT(errorWith(calibration, "R: 1 0 0 0 1 0 0 0 1\nT: 0 0\n"),
                HasSubstr("calib_imu_to_velo.txt:2: expected 3 numbers, found 2"));
    EXPECT_THAT(errorWith(calibration, "\nR: 1 0 0 0 1 0 0 0 2\nT: 0 0 0\n"),
                HasSubstr("calib_imu_to_velo.txt:2: R is not a rotation matrix"));
    EXPECT_THAT(errorWith(calibration, "R: 1 0 0 0 1 0 0 0 -1\nT: 0 0 0\n"),
                HasSubstr("R is not a rotation matrix"));
}

TEST_F(KittiDriveTest, ReadsPoints)
{
    const PointCloud scan = readKittiScan(make("s.bin", KittiExampleDrive::scan(1)));
    ASSERT_EQ(scan.size(), 4U);
    EXPECT_EQ(scan.x[0], 19.0F);
    EXPECT_EQ(scan.y[1], 2.1F);
    EXPECT_EQ(scan.z[3], -1.7F);
    EXPECT_EQ(scan.intensity[2], 0.75F);
    EXPECT_TRUE(scan.time.empty());
}

// In a text they would be a byte order mark.
TEST_F(KittiDriveTest, ReadsPointsThatBeginWithAnyBytes)
{
    const std::string bytes = "\xEF\xBB\xBF\x41" + KittiExampleDrive::scan(1).substr(sizeof(float));
    const PointCloud scan = readKittiScan(make("s.bin", bytes));
    ASSERT_EQ(scan.size(), 4U);
    EXPECT_NEAR(scan.x[0], 23.97F, 0.01F);
}

TEST_F(KittiDriveTest, RefusesDamagedPoints)
{
    const auto errorFor = [this](const std::string& bytes)
    {
        const auto path = make("s.bin", bytes);
        return errorOf([&] { readKittiScan(path); });
    };
    std::string bytes = KittiExampleDrive::scan(0);
    EXPECT_THAT(errorFor(bytes.substr(0, 60)), HasSubstr("s.bin: has 60 bytes; expected 16"));
    EXPECT_THAT(errorFor(""), HasSubstr("s.bin: has 0 bytes"));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(bytes.data() + 20, &nan, sizeof nan);
    EXPECT_THAT(errorFor(bytes), HasSubstr("s.bin: point 1 is not finite"));
    EXPECT_THAT(errorOf([&] { readKittiScan(at("none.bin")); }), HasSubstr("No such file"));
}

}  // namespace
}  // namespace vdamf
