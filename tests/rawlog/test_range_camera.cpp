// SPDX-License-Identifier: BSD-3-Clause
// Range images of cameras, as CObservation3DRangeScan has them.
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>

#include "../files/temporary_folder.h"
#include "sample_rawlogs.h"
#include "vdamf/rawlog/rawlog_reader.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

/// Looks at a wall 20 m ahead, from 1 m up; 20 by 10 pixels, the first row sees nothing.
CObservation3DRangeScan camera()
{
    CObservation3DRangeScan scan;
    scan.timestamp = mrpt::Clock::fromDouble(1.5e9);
    scan.sensorLabel = "flash";
    scan.sensorPose = mrpt::poses::CPose3D(2.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    scan.cameraParams.ncols = 20;
    scan.cameraParams.nrows = 10;
    scan.cameraParams.setIntrinsicParamsFromValues(40.0, 40.0, 10.0, 5.0);
    scan.hasRangeImage = true;
    scan.range_is_depth = true;
    scan.rangeUnits = 0.001F;
    scan.rangeImage_setSize(10, 20);
    scan.rangeImage.fill(20000);
    for (int column = 0; column < 20; ++column) scan.rangeImage(0, column) = 0;
    return scan;
}

TEST(RangeCamera, SeesAWallWhereItIs)
{
    const auto scan = scanFrom(camera());
    ASSERT_TRUE(scan);
    ASSERT_EQ(180u, scan->points.size());
    for (const float x : scan->points.x) EXPECT_NEAR(x, 22.0, 1e-4);
    const auto& y = scan->points.y;
    EXPECT_NEAR(*std::max_element(y.begin(), y.end()), 20.0 * 10.0 / 40.0, 1e-3);
    EXPECT_NEAR(*std::min_element(y.begin(), y.end()), -20.0 * 9.0 / 40.0, 1e-3);
    const auto& z = scan->points.z;
    EXPECT_NEAR(*std::max_element(z.begin(), z.end()), 1.0 + 20.0 * 4.0 / 40.0, 1e-3);
    EXPECT_FALSE(scan->planar);
    EXPECT_FALSE(isLineScan(camera()));
    EXPECT_TRUE(isMinorScan(camera()));
}

TEST(RangeCamera, PointsGoBeforeTheImage)
{
    CObservation3DRangeScan scan = camera();
    scan.hasPoints3D = true;
    scan.points3D_x = {5.0F, 0.0F};
    scan.points3D_y = {1.0F, 0.0F};
    scan.points3D_z = {0.5F, 0.0F};
    const auto found = scanFrom(scan);
    ASSERT_EQ(1u, found->points.size()) << "zeros are no return";
    EXPECT_FLOAT_EQ(7.0F, found->points.x[0]);
    EXPECT_FLOAT_EQ(1.5F, found->points.z[0]);
    scan.points3D_z.clear();
    EXPECT_NE(std::string::npos, errorOf([&] { scanFrom(scan); }).find("differ in number"));
}

TEST(RangeCamera, NeedsPointsOrAnImage)
{
    CObservation3DRangeScan scan = camera();
    scan.hasRangeImage = false;
    EXPECT_EQ("mrpt::obs::CObservation3DRangeScan 'flash': it has no points and no range image",
              errorOf([&] { scanFrom(scan); }));
}

TEST(RangeCamera, OfTheSampleRawlogHasItsHits)
{
    const auto path = test::sampleRawlog("tests_rgbd.rawlog");
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    RawlogReader reader(path);
    std::size_t hits = 0;
    while (const auto entry = reader.next())
    {
        const auto* scan = dynamic_cast<const CObservation3DRangeScan*>(entry->object.get());
        if (scan != nullptr && hits == 0) hits = scanFrom(*scan)->points.size();
    }
    EXPECT_EQ(273225U, hits);
}

}  // namespace
}  // namespace vdamf
