// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/rawlog/velodyne_packets.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <cmath>
#include <cstring>
#include <random>
#include <set>

#include "../files/temporary_folder.h"
#include "hit_range.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr double kScanTime = 1.5e9 + 0.25;

struct Sensor
{
    VelodyneModel model;
    double firingPeriod;  // s
    double laserPeriod;   // s
    int lasersInTurn;     // that fire one after another
    int firingsPerBlock;
};

const Sensor kSensors[] = {{VelodyneModel::VLP16, 55.296e-6, 2.304e-6, 16, 2},
                           {VelodyneModel::HDL32E, 46.08e-6, 1.152e-6, 32, 1},
                           {VelodyneModel::HDL64E, 48.0e-6, 1.5e-6, 32, 1}};

constexpr double kRate = 2.0 * kPi * 10.0;  // rad/s

std::size_t lasersOf(const Sensor& sensor)
{
    return laserElevations(sensor.model).size();
}

/// Firings of a turning sensor, with ranges from 1 to 100 m that differ for each return.
std::vector<VelodyneFiring> firingsOf(const Sensor& sensor, int count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> range(1.0F, 100.0F);
    std::vector<VelodyneFiring> firings;
    for (int i = 0; i < count; ++i)
    {
        VelodyneFiring& firing = firings.emplace_back();
        firing.azimuth = wrapAngle(6.0 + kRate * sensor.firingPeriod * i);
        for (std::size_t laser = 0; laser < lasersOf(sensor); ++laser)
        {
            firing.range.push_back(range(random));
            firing.intensity.push_back(static_cast<float>(laser) / 255.0F);
        }
    }
    return firings;
}

/// Writes into the raw bytes of a packet.
void poke(VelodyneScan& scan, std::size_t packet, std::size_t offset, std::uint8_t value)
{
    std::memcpy(reinterpret_cast<char*>(&scan.scan_packets[packet]) + offset, &value, 1);
}

class VelodynePackets : public ::testing::TestWithParam<Sensor>
{
};

TEST_P(VelodynePackets, DecodeWhatWasEncoded)
{
    const Sensor& sensor = GetParam();
    const std::vector<VelodyneFiring> firings = firingsOf(sensor, 1203);
    const PointCloud cloud = decodeVelodyne(encodeVelodyne(sensor.model, kScanTime, firings));
    ASSERT_EQ(firings.size() * lasersOf(sensor), cloud.size());
    ASSERT_EQ(cloud.size(), cloud.time.size());
    // Points come block by block: for the HDL-64E lasers 0..31, then 32..63 of the same firing.
    std::size_t i = 0;
    for (std::size_t f = 0; f < firings.size(); ++f)
    {
        for (std::size_t laser = 0; laser < lasersOf(sensor); ++laser, ++i)
        {
            const double delay =
                sensor.laserPeriod * static_cast<double>(laser % sensor.lasersInTurn);
            const double azimuth = firings[f].azimuth + kRate * delay;
            EXPECT_NEAR(firings[f].range[laser], rangeOf(cloud, i), 0.0011);
            const double seen = -std::atan2(cloud.y[i], cloud.x[i]);
            EXPECT_NEAR(0.0, wrapAngle(seen - azimuth) * 180.0 / kPi, 0.01);
            EXPECT_NEAR(laserElevations(sensor.model)[laser],
                        std::asin(cloud.z[i] / rangeOf(cloud, i)), 1e-5);
            EXPECT_NEAR(firings[f].intensity[laser], cloud.intensity[i], 1e-6);
            EXPECT_NEAR(sensor.firingPeriod * static_cast<double>(f) + delay, cloud.time[i], 1e-6);
            if (HasFailure()) FAIL() << "firing " << f << ", laser " << laser;
        }
    }
}

TEST_P(VelodynePackets, AllLasersAppear)
{
    const Sensor& sensor = GetParam();
    const PointCloud cloud =
        decodeVelodyne(encodeVelodyne(sensor.model, kScanTime, firingsOf(sensor, 24)));
    std::set<long> lasers;
    for (const float intensity : cloud.intensity) lasers.insert(std::lround(intensity * 255.0F));
    EXPECT_EQ(lasersOf(sensor), lasers.size());
}

TEST_P(VelodynePackets, NominalElevationsNeedNoCalibration)
{
    const Sensor& sensor = GetParam();
    VelodyneScan scan = encodeVelodyne(sensor.model, kScanTime, firingsOf(sensor, 24));
    const PointCloud calibrated = decodeVelodyne(scan);
    scan.calibration.clear();
    const PointCloud nominal = decodeVelodyne(scan);
    ASSERT_EQ(calibrated.size(), nominal.size());
    for (std::size_t i = 0; i < nominal.size(); ++i)
        EXPECT_NEAR(calibrated.z[i], nominal.z[i], 1e-4);
}

TEST_P(VelodynePackets, TimeGoesOnOverTheHour)
{
    const Sensor& sensor = GetParam();
    const double beforeTheHour = 3600.0 * 416666 - 0.01;
    const std::vector<VelodyneFiring> firings = firingsOf(sensor, 1200);
    const PointCloud cloud = decodeVelodyne(encodeVelodyne(sensor.model, beforeTheHour, firings));
    for (std::size_t i = 1; i < cloud.size(); ++i)
    {
        ASSERT_LT(std::abs(cloud.time[i] - cloud.time[i - 1]), 0.001) << "point " << i;
    }
    EXPECT_NEAR(1200 * sensor.firingPeriod, cloud.time.back(), 1e-4);
}

TEST_P(VelodynePackets, NonsenseStampsAreReplacedByTheNominalPace)
{
    const Sensor& sensor = GetParam();
    VelodyneScan scan = encodeVelodyne(sensor.model, kScanTime, firingsOf(sensor, 1200));
    for (std::size_t i = 0; i < scan.scan_packets.size(); ++i)
    {
        for (std::size_t k = 0; k < 4; ++k)
        {
            poke(scan, i, 1200 + k, static_cast<std::uint8_t>(97 * i + 13 * k));
        }
    }
    const PointCloud cloud = decodeVelodyne(scan);
    EXPECT_NEAR(1200 * sensor.firingPeriod, cloud.time.back(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Sensors, VelodynePackets, ::testing::ValuesIn(kSensors));

TEST(VelodyneEncoder, LeavesOutWhatIsNoReturn)
{
    VelodyneFiring firing;
    firing.range.assign(32, 10.0F);
    firing.intensity.assign(32, 2.0F);
    firing.range[3] = 0.0F;
    firing.range[4] = 132.0F;
    firing.range[5] = std::nanf("");
    const VelodyneScan scan = encodeVelodyne(VelodyneModel::HDL32E, kScanTime, {firing});
    const PointCloud cloud = decodeVelodyne(scan);
    ASSERT_EQ(29u, cloud.size());
    EXPECT_EQ(1.0F, cloud.intensity[0]);
    EXPECT_EQ(1u, scan.scan_packets.size());
    EXPECT_NEAR(kScanTime, mrpt::Clock::toDouble(scan.timestamp), 1e-6);
}

TEST(VelodyneEncoder, WantsARangeForEachLaser)
{
    VelodyneFiring firing;
    firing.range.assign(16, 10.0F);
    firing.intensity.assign(16, 0.0F);
    EXPECT_THROW(encodeVelodyne(VelodyneModel::HDL32E, kScanTime, {firing}), std::runtime_error);
    EXPECT_TRUE(encodeVelodyne(VelodyneModel::HDL32E, kScanTime, {}).scan_packets.empty());
}

TEST(VelodyneDecoder, DropsTheSecondOfTwoEqualReturns)
{
    const Sensor& sensor = kSensors[1];
    const std::vector<VelodyneFiring> single = firingsOf(sensor, 12);
    std::vector<VelodyneFiring> twice;
    for (const VelodyneFiring& firing : single) twice.insert(twice.end(), 2, firing);
    twice[1].range[7] += 5.0F;
    VelodyneScan scan = encodeVelodyne(sensor.model, kScanTime, twice);
    for (std::size_t i = 0; i < scan.scan_packets.size(); ++i)
    {
        poke(scan, i, 1204, VelodyneScan::RETMODE_DUAL);
    }
    const PointCloud cloud = decodeVelodyne(scan);
    ASSERT_EQ(12u * 32 + 1, cloud.size());
    // Both returns of a shot have its time and direction.
    EXPECT_NEAR(7 * sensor.laserPeriod, cloud.time[32], 1e-7);
    EXPECT_NEAR(twice[1].range[7], rangeOf(cloud, 32), 0.0011);
    EXPECT_NEAR(cloud.y[7] / cloud.x[7], cloud.y[32] / cloud.x[32], 1e-5);
    EXPECT_NEAR(5 * sensor.firingPeriod + 31 * sensor.laserPeriod, cloud.time[6 * 32], 1e-6);
}

TEST(VelodyneDecoder, CorrectsByTheCalibration)
{
    VelodyneFiring firing;
    firing.range.assign(64, 10.0F);
    firing.intensity.assign(64, 0.5F);
    VelodyneScan scan = encodeVelodyne(VelodyneModel::HDL64E, kScanTime, {firing});
    auto& laser = scan.calibration.laser_corrections[40];
    // In radians, as from a YAML file.
    for (auto& one : scan.calibration.laser_corrections) one.verticalCorrection *= kPi / 180.0;
    laser.azimuthCorrection = 0.1;
    laser.distanceCorrection = 1.5;
    laser.verticalOffsetCorrection = 0.2;
    laser.horizontalOffsetCorrection = 0.03;
    const PointCloud cloud = decodeVelodyne(scan);
    const double e = laserElevations(VelodyneModel::HDL64E)[40];
    // Forward, left and up of the beam, by hand.
    const Eigen::Vector3d beam(std::cos(e) * std::cos(0.1), std::cos(e) * std::sin(0.1),
                               std::sin(e));
    const Eigen::Vector3d up(-std::sin(e) * std::cos(0.1), -std::sin(e) * std::sin(0.1),
                             std::cos(e));
    const Eigen::Vector3d left(-std::sin(0.1), std::cos(0.1), 0.0);
    const Eigen::Vector3d expected = 11.5 * beam + 0.2 * up + 0.03 * left;
    EXPECT_NEAR(expected.x(), cloud.x[40], 1e-4);
    EXPECT_NEAR(expected.y(), cloud.y[40], 1e-4);
    EXPECT_NEAR(expected.z(), cloud.z[40], 1e-4);
}

TEST(VelodyneDecoder, TakesTheStoredCloudWhereThereAreNoPackets)
{
    VelodyneScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(kScanTime);
    scan.point_cloud.x = {1.0F, 2.0F};
    scan.point_cloud.y = {3.0F, 4.0F};
    scan.point_cloud.z = {5.0F, 6.0F};
    scan.point_cloud.intensity = {255, 51};
    PointCloud cloud = decodeVelodyne(scan);
    EXPECT_EQ(std::vector<float>({3.0F, 4.0F}), cloud.y);
    EXPECT_EQ(std::vector<float>({1.0F, 0.2F}), cloud.intensity);
    EXPECT_TRUE(cloud.time.empty());
    scan.point_cloud.timestamp = {scan.timestamp, mrpt::Clock::fromDouble(kScanTime + 0.01)};
    cloud = decodeVelodyne(scan);
    ASSERT_EQ(2u, cloud.time.size());
    EXPECT_NEAR(0.01, cloud.time[1], 1e-6);
}

TEST(VelodyneDecoder, NamesASensorThatItDoesNotKnow)
{
    VelodyneScan scan =
        encodeVelodyne(VelodyneModel::HDL32E, kScanTime, firingsOf(kSensors[1], 12));
    poke(scan, 0, 1205, 0x28);  // VLP-32C
    EXPECT_NE(std::string::npos, errorOf([&] { decodeVelodyne(scan); }).find("0x28"));
    poke(scan, 0, 1205, 0x22);
    EXPECT_NE(std::string::npos, errorOf([&] { decodeVelodyne(scan); }).find("calibration"));
}

TEST(VelodyneDecoder, SkipsBrokenBlocks)
{
    VelodyneScan scan =
        encodeVelodyne(VelodyneModel::HDL32E, kScanTime, firingsOf(kSensors[1], 12));
    poke(scan, 0, 100, 0x00);  // header of block 1
    poke(scan, 0, 203, 0xff);  // azimuth of block 2
    EXPECT_EQ(10u * 32, decodeVelodyne(scan).size());
}

}  // namespace
}  // namespace vdamf
