// SPDX-License-Identifier: BSD-3-Clause
// MRPT's sample rawlogs, read whole.
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationGPS.h>
#include <zlib.h>

#include <cmath>

#include "example_objects.h"
#include "hit_range.h"
#include "sample_rawlogs.h"
#include "vdamf/rawlog/ins_trajectory.h"
#include "vdamf/rawlog/velodyne_packets.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
class SampleRawlogs : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SampleRawlogs, EntriesAreTheWholeFile)
{
    const auto path = test::sampleRawlog(GetParam());
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    RawlogReader reader(path);
    const auto entries = test::entriesOf(reader);
    gzFile file = gzopen(path.c_str(), "rb");
    std::string expected(64 << 20, '\0');
    const int size = gzread(file, expected.data(), static_cast<unsigned>(expected.size()));
    gzclose(file);
    ASSERT_GT(size, 0);
    expected.resize(static_cast<std::size_t>(size));
    EXPECT_TRUE(expected == test::concatenated(entries));
    EXPECT_EQ(entries.size(), reader.summary().objects);
    EXPECT_FALSE(reader.summary().truncated) << reader.summary().truncation;
}

INSTANTIATE_TEST_SUITE_P(Mrpt, SampleRawlogs,
                         ::testing::Values("test_velodyne_VLP16.rawlog", "rot_scan_velodyne.rawlog",
                                           "rot_scan_2d.rawlog", "test_rtk_path.rawlog",
                                           "test-3d-obs-ground.rawlog", "tests_rgbd.rawlog",
                                           "test-imu-obs-format3.rawlog",
                                           "test-imu-obs-format4.rawlog"));

TEST(SampleObservations, VelodyneGivesAllPoints)
{
    const auto path = test::sampleRawlog("test_velodyne_VLP16.rawlog");
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    RawlogReader reader(path);
    const auto entries = test::entriesOf(reader);
    ASSERT_EQ(1u, entries.size());
    auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(entries[0].object);
    ASSERT_TRUE(scan);
    const PointCloud cloud = decodeVelodyne(*scan);
    EXPECT_EQ(22591u, cloud.size());
    EXPECT_GT(cloud.time.back(), 0.09F);
    EXPECT_LT(cloud.time.back(), 0.11F);
    // MRPT's points are the first half of each block's, with azimuths rounded to 0.01 degrees.
    scan->generatePointCloud();
    const auto& theirs = scan->point_cloud;
    ASSERT_EQ(11305u, theirs.size());
    std::size_t ours = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < theirs.size(); ++i, ++ours)
    {
        const auto angleApart = [&]
        {
            return std::hypot(cloud.x[ours] - theirs.x[i], cloud.y[ours] - theirs.y[i]) /
                   rangeOf(cloud, ours);
        };
        const auto isOther = [&]
        { return std::abs(cloud.z[ours] - theirs.z[i]) > 1e-4 || angleApart() > 0.002; };
        while (ours < cloud.size() && isOther()) ++ours;
        ASSERT_LT(ours, cloud.size()) << "no point like MRPT's " << i;
        worst = std::max(worst, angleApart());
    }
    EXPECT_LT(worst * 180.0 / kPi, 0.03);
}

TEST(SampleObservations, GpsGivesATrajectory)
{
    const auto path = test::sampleRawlog("test_rtk_path.rawlog");
    if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
    InsOptions options;
    options.label = "GPS_RTK_FRONT_L";
    InsTrajectory ins{options};
    RawlogReader reader(path);
    double last = 0.0;
    for (const RawlogEntry& entry : test::entriesOf(reader))
    {
        if (!entry.object) continue;
        ins.insert(*entry.object);
        const auto gps = std::dynamic_pointer_cast<mrpt::obs::CObservationGPS>(entry.object);
        if (gps) last = mrpt::Clock::toDouble(gps->timestamp);
    }
    EXPECT_EQ("CObservationGPS (GGA) 'GPS_RTK_FRONT_L'", ins.sourceName());
    EXPECT_EQ(307u, ins.samplesTaken());
    EXPECT_TRUE(ins.at(last - 10.0));
}

}  // namespace
}  // namespace vdamf
