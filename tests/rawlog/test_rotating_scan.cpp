// SPDX-License-Identifier: BSD-3-Clause
// Range images as CObservationRotatingScan has them.
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <algorithm>
#include <cmath>

#include "../files/temporary_folder.h"
#include "hit_range.h"
#include "sample_rawlogs.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservationRotatingScan;

/// 90 degrees to the right at 10 revolutions a second; ranges tell lasers and firings.
mrpt::obs::CObservationVelodyneScan quarterTurn(VelodyneModel model, double firingPeriod)
{
    const std::size_t lasers = laserElevations(model).size();
    std::vector<VelodyneFiring> firings;
    for (int i = 0; firingPeriod * i < 0.025; ++i)
    {
        VelodyneFiring firing;
        firing.azimuth = 2.0 * kPi * 10.0 * firingPeriod * i;
        for (std::size_t laser = 0; laser < lasers; ++laser)
            firing.range.push_back(20.0F + static_cast<float>(laser) +
                                   0.004F * static_cast<float>(i % 100));
        firing.intensity.assign(lasers, 1.0F);
        firings.push_back(firing);
    }
    auto scan = encodeVelodyne(model, 1.5e9, firings);
    scan.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(
        model == VelodyneModel::VLP16 ? "VLP16" : "HDL32");
    return scan;
}

double distance(const PointCloud& a, std::size_t i, const PointCloud& b, std::size_t j)
{
    return std::hypot(a.x[i] - b.x[j], a.y[i] - b.y[j], a.z[i] - b.z[j]);
}

/// The hit of equal range and, within 20 us, equal time. Times of packets are whole microseconds,
/// and columns of the image are evenly spaced; 20 us are 0.07 degrees.
std::size_t sameShot(const PointCloud& found, std::size_t i, const PointCloud& all)
{
    constexpr float kWindow = 20e-6F;
    const auto begin = std::lower_bound(all.time.begin(), all.time.end(), found.time[i] - kWindow);
    auto j = static_cast<std::size_t>(begin - all.time.begin());
    while (j < all.size() && all.time[j] < found.time[i] + kWindow)
    {
        if (std::abs(rangeOf(all, j) - rangeOf(found, i)) < 1e-3) return j;
        ++j;
    }
    return all.size();
}

/// Each hit of the image is one of the packets', at the same place and time. MRPT's conversion
/// loses the others.
void expectSame(const mrpt::obs::CObservationVelodyneScan& packets)
{
    CObservationRotatingScan image;
    image.fromVelodyne(packets);
    const PointCloud expected = decodeVelodyne(packets);
    const PointCloud found = scanFrom(image)->points;
    ASSERT_GT(found.size(), expected.size() / 3);
    ASSERT_EQ(found.time.size(), found.size());
    ASSERT_EQ(found.intensity.size(), found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
        const std::size_t j = sameShot(found, i, expected);
        ASSERT_LT(j, expected.size()) << i;
        EXPECT_LT(distance(found, i, expected, j), 0.07) << i;
    }
    EXPECT_LT(found.y[found.size() - 1], -15.0F) << "a quarter turn to the right";
    EXPECT_NEAR(durationOf(image), 0.025, 2e-3);
}

TEST(RotatingScan, OfAVelodyneHasThePlacesOfItsPackets)
{
    expectSame(quarterTurn(VelodyneModel::VLP16, 55.296e-6));
    expectSame(quarterTurn(VelodyneModel::HDL32E, 46.08e-6));
}

TEST(RotatingScan, OfOneRowIsALine)
{
    mrpt::obs::CObservation2DRangeScan line;
    line.timestamp = mrpt::Clock::fromDouble(1.5e9);
    line.aperture = 3.0F;
    line.rightToLeft = true;
    line.resizeScanAndAssign(7, 12.34F, true);
    line.setScanRangeValidity(2, false);
    CObservationRotatingScan image;
    image.fromScan2D(line);
    const auto expected = scanFrom(line);
    const auto found = scanFrom(image);
    EXPECT_TRUE(isLineScan(image));
    EXPECT_TRUE(found->planar);
    ASSERT_EQ(6u, found->points.size());
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(distance(found->points, i, expected->points, i), 0.006);
    EXPECT_TRUE(found->points.time.empty());
    EXPECT_EQ(0.0, durationOf(image));
}

TEST(RotatingScan, FurtherLayersAreFurtherReturns)
{
    CObservationRotatingScan image;
    image.timestamp = mrpt::Clock::fromDouble(1.5e9);
    image.rangeResolution = 0.01;
    image.rangeImage.setZero(1, 5);
    for (int i = 0; i < 5; ++i) image.rangeImage(0, i) = static_cast<std::uint16_t>(1000 + i);
    auto& last = image.rangeOtherLayers["LAST"];
    last = image.rangeImage;
    last(0, 2) = 2000;  // the others are the same returns
    last(0, 3) = 0;
    image.rangeOtherLayers["BROKEN"].setZero(2, 5);
    const auto scan = scanFrom(image);
    ASSERT_EQ(scan->points.size(), 6U);
    EXPECT_NEAR(std::hypot(scan->points.x[5], scan->points.y[5]), 20.0, 1e-4);
    EXPECT_NEAR(std::atan2(scan->points.y[5], scan->points.x[5]),
                std::atan2(scan->points.y[2], scan->points.x[2]), 1e-6);
}

TEST(RotatingScan, SaysWhatItCannotRead)
{
    CObservationRotatingScan image;
    image.fromVelodyne(quarterTurn(VelodyneModel::VLP16, 55.296e-6));
    const auto errorOfImage = [&] { return errorOf([&] { scanFrom(image); }); };
    const auto good = image;
    image.lidarModel = "Unknown";
    EXPECT_NE(std::string::npos, errorOfImage().find("'Unknown'")) << errorOfImage();
    image = good;
    image.rangeResolution = std::nan("");
    EXPECT_NE(std::string::npos, errorOfImage().find("resolution"));
    image = good;
    image.intensityImage.setZero(16, 3);
    EXPECT_NE(std::string::npos, errorOfImage().find("differ in size"));
    image = good;
    image.azimuthSpan = std::nan("");
    EXPECT_NE(std::string::npos, errorOfImage().find("azimuths"));
    image = CObservationRotatingScan();
    image.timestamp = mrpt::Clock::fromDouble(1.5e9);
    EXPECT_TRUE(scanFrom(image)->points.empty());
}

TEST(RotatingScan, OfTheSampleRawlogHasItsHits)
{
    const auto path = test::sampleRawlog("rot_scan_velodyne.rawlog");
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    RawlogReader reader(path);
    const auto entry = reader.next();
    const auto scan = scanFrom(dynamic_cast<const mrpt::obs::CObservation&>(*entry.value().object));
    EXPECT_EQ(11305U, scan->points.size());
    EXPECT_NEAR(scan->points.time.back(), 0.0995, 1e-4);
}

}  // namespace
}  // namespace vdamf
