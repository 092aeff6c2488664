// SPDX-License-Identifier: BSD-3-Clause
// Folders of clouds to rawlogs: order, times, poses.
#include "vdamf/rawlog/cloud_import.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <fstream>

#include "../files/temporary_folder.h"
#include "example_objects.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;

class CloudImportTest : public TemporaryFolder
{
protected:
    CloudImportTest()
    {
        std::filesystem::create_directory(at("in"));
        job_.folder = at("in");
        job_.output.rawlog = at("o.rawlog");
        job_.output.existing = OutputFile::Existing::Overwrite;
    }

    /// A cloud of one hit, at x.
    void cloud(const std::string& name, double x, const std::string& time = "") const
    {
        std::ofstream file(at("in") / name);
        file << "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                "property float z\n"
             << (time.empty() ? "" : "property double time\n") << "end_header\n";
        for (int i = 0; i < 2; ++i)
            file << x << " " << i << " 1 " << (time.empty() ? "" : i == 0 ? "0" : time) << "\n";
    }

    std::vector<Scan> scans() const
    {
        RawlogReader reader(job_.output.rawlog);
        std::vector<Scan> all;
        for (const RawlogEntry& entry : test::entriesOf(reader))
        {
            const auto one = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry.object);
            if (one && isScan(*one)) all.push_back(*scanFrom(*one));
        }
        return all;
    }

    std::string error()
    {
        try
        {
            importClouds(job_);
        }
        catch (const std::runtime_error& failure)
        {
            return failure.what();
        }
        return "none";
    }

    CloudImport job_;
};

TEST_F(CloudImportTest, NamesAreSortedByTheirNumbers)
{
    cloud("scan_10.ply", 10);
    cloud("scan_9.ply", 9);
    cloud("scan_008.ply", 8);
    job_.rate = 5.0;
    const CloudImportSummary summary = importClouds(job_);
    EXPECT_EQ(summary.scans, 3U);
    EXPECT_EQ(summary.points, 6U);
    const auto all = scans();
    ASSERT_EQ(all.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_FLOAT_EQ(all[i].points.x[0], static_cast<float>(8 + i));
        EXPECT_NEAR(all[i].time, 0.2 * static_cast<double>(i), 1e-6);
    }
}

TEST_F(CloudImportTest, TimesAreFromAFileOrNamesOrPoses)
{
    cloud("1700000000.25.ply", 1);
    cloud("1700000000.5.ply", 2);
    EXPECT_EQ(importClouds(job_).times, "the names of the files");
    EXPECT_NEAR(scans().at(0).time, 1700000000.25, 1e-6);
    job_.poses = make("p.tum", "100 0 0 0 0 0 0 1\n101 1 0 0 0 0 0 1\n");
    importClouds(job_);
    EXPECT_NEAR(scans().at(1).time, 101.0, 1e-6);
    job_.times = make("times.txt", "100.25\n100.75\n");
    importClouds(job_);
    EXPECT_NEAR(scans().at(1).time, 100.75, 1e-6);
    job_.poses.clear();
    job_.times = make("times.txt", "2011-09-26 13:02:25.5\n2011-09-26 13:02:26.5\n");
    importClouds(job_);
    EXPECT_NEAR(scans().at(1).time, 1317042146.5, 1e-6);
}

TEST_F(CloudImportTest, TextsMayBeginWithAByteOrderMark)
{
    const std::string mark = "\xEF\xBB\xBF";
    cloud("1.ply", 1);
    cloud("2.ply", 2);
    job_.poses = make("p.tum", mark + "# t x y z\n1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n");
    job_.times = make("times.txt", mark + "1\n1.5\n");
    EXPECT_EQ(error(), "none");
    EXPECT_NEAR(scans().at(1).time, 1.5, 1e-6);
    job_.poses.clear();
    job_.times = make("times.txt", mark + "2011-09-26 13:02:25.5\n2011-09-26 13:02:26.5\n");
    EXPECT_EQ(error(), "none");
    EXPECT_NEAR(scans().at(1).time, 1317042146.5, 1e-6);
}

TEST_F(CloudImportTest, PosesOfAnotherClockAreRefused)
{
    cloud("1.ply", 1);
    cloud("2.ply", 2);
    job_.rate = 10.0;
    job_.poses = make("p.tum", "1700000000 0 0 0 0 0 0 1\n1700000001 1 0 0 0 0 0 1\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("p.tum: its poses are at 1700000000.000 to"),
                               HasSubstr("the scans at 0.000 to 0.100 s")));
    EXPECT_FALSE(std::filesystem::exists(job_.output.rawlog));
    job_.poses = make("p.tum", "0.05 0 0 0 0 0 0 1\n0.2 1 0 0 0 0 0 1\n");
    EXPECT_EQ(error(), "none") << "some have one";
}

TEST_F(CloudImportTest, TimesInAnotherUnitAreRefusedButInNames)
{
    cloud("a.ply", 1);
    for (const std::string time :
         {"1317044500414000034", "1317044500414000", "1317044500414", "1e30", "-1e30"})
    {
        job_.times = make("times.txt", "# s\n" + time + "\n");
        EXPECT_THAT(error(), HasSubstr("times.txt:2: '" + time + "' is no time in seconds"));
        job_.times.clear();
        job_.poses = make("p.tum", time + " 0 0 0 0 0 0 1\n");
        EXPECT_THAT(error(), HasSubstr("p.tum:1: '" + time + "' is no time in seconds"));
        job_.poses.clear();
    }
    std::filesystem::remove(at("in/a.ply"));
    for (const std::string name :
         {"1317044500", "1317044500.25", "1317044500250", "1317044500250.5", "1317044500250000034"})
    {
        cloud(name + ".ply", 1);
        ASSERT_EQ(error(), "none") << name;
        EXPECT_NEAR(scans().at(0).time, 1317044500.0, 0.26) << name;
        std::filesystem::remove(at("in/" + name + ".ply"));
    }
    cloud("1000000000000000000000.5.ply", 1);
    EXPECT_THAT(error(), HasSubstr("times of the clouds are not known"));
}

TEST_F(CloudImportTest, TimesBeforeZeroAreRefused)
{
    cloud("1.ply", 1);
    cloud("2.ply", 2);
    job_.times = make("times.txt", "-0.5\n1\n");
    EXPECT_THAT(error(), HasSubstr("times.txt:1: '-0.5' is no time in seconds; expected 0 (1970"));
    job_.times = make("times.txt", "0\n0.1\n");
    EXPECT_EQ(error(), "none");
    EXPECT_EQ(scans().at(0).time, 0.0);
    job_.times.clear();
    job_.poses = make("p.tum", "-1 0 0 0 0 0 0 1\n0 1 0 0 0 0 0 1\n");
    EXPECT_THAT(error(), HasSubstr("p.tum:1: '-1' is no time in seconds; expected 0 (1970"));
    job_.poses = make("p.tum", "0 0 0 0 0 0 0 1\n0.1 1 0 0 0 0 0 1\n");
    EXPECT_EQ(error(), "none");
    EXPECT_NEAR(scans().at(1).time, 0.1, 1e-6);
}

TEST_F(CloudImportTest, PosesOfEitherFormat)
{
    cloud("1.ply", 1);
    cloud("2.ply", 2);
    job_.rate = 10.0;
    job_.poses = make("kitti.txt", "1 0 0 5 0 1 0 6 0 0 1 7\n0 -1 0 8 1 0 0 9 0 0 1 10\n");
    job_.sensorInVehicle.translation().z() = 1.5;
    EXPECT_EQ(importClouds(job_).poses, 2U);
    RawlogReader reader(job_.output.rawlog);
    const auto entries = test::entriesOf(reader);
    ASSERT_EQ(entries.size(), 4U);
    const auto pose =
        std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(entries[2].object);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->pose.mean.y(), 9.0, 1e-12);
    EXPECT_NEAR(pose->pose.mean.yaw(), 1.5707963, 1e-6);
    EXPECT_FLOAT_EQ(scans().at(0).points.z[0], 2.5F);
}

TEST_F(CloudImportTest, HitsKeepTheirTimes)
{
    cloud("1.ply", 1, "0.08");
    job_.rate = 10.0;
    EXPECT_TRUE(importClouds(job_).pointTimes);
    const auto all = scans();
    ASSERT_EQ(all.at(0).points.time.size(), 2U);
    EXPECT_NEAR(all[0].points.time[1], 0.08F, 1e-5F);
    cloud("1.ply", 1, "80");
    EXPECT_THAT(error(), HasSubstr("span 80"));
    job_.pointTime = PointTime::Milliseconds;
    importClouds(job_);
    EXPECT_NEAR(scans().at(0).points.time[1], 0.08F, 1e-5F);
}

TEST_F(CloudImportTest, NoCloudIsWrittenOver)
{
    cloud("a.ply", 1);
    cloud("b.ply", 2);
    job_.rate = 10.0;
    job_.output.rawlog = at("in/b.ply");
    EXPECT_THAT(error(), HasSubstr("b.ply: is one of the clouds"));
    job_.output.rawlog = at("in/o.rawlog");
    EXPECT_EQ(importClouds(job_).scans, 2U);
    EXPECT_EQ(importClouds(job_).scans, 2U) << "an earlier output is none of them";
}

TEST_F(CloudImportTest, SaysWhatItCannotImport)
{
    EXPECT_THAT(error(), HasSubstr("holds no .pcd, .ply or .bin"));
    cloud("a.ply", 1);
    cloud("b.ply", 2);
    EXPECT_THAT(error(), HasSubstr("times of the clouds are not known"));
    job_.times = make("times.txt", "1\n2\n3\n");
    EXPECT_THAT(error(), HasSubstr("times.txt: holds 3 times"));
    job_.times = make("times.txt", "2\n1\n");
    EXPECT_THAT(error(), HasSubstr("times.txt:2: its time is not later"));
    job_.times.clear();
    job_.rate = 10.0;
    job_.poses = make("p.txt", "1 0 0 5 0 1 0 6 0 0 1 7\n");
    EXPECT_THAT(error(), HasSubstr("p.txt: holds 1 poses"));
    job_.poses = make("p.txt", "1 2 3\n");
    EXPECT_THAT(error(), HasSubstr("p.txt:1: 3 columns; expected 8"));
    job_.poses = make("p.txt", "1 0 0 0 0 0 0 2\n");
    EXPECT_THAT(error(), HasSubstr("p.txt:1: qx qy qz qw are no rotation"));
    job_.poses.clear();
    make("in/c.ply", "ply\n");
    EXPECT_THAT(error(), HasSubstr("c.ply:1: no PLY file"));
    EXPECT_FALSE(std::filesystem::exists(at("o.rawlog")));
    job_.folder = at("none");
    EXPECT_THAT(error(), HasSubstr("none: cannot list"));
}

}  // namespace
}  // namespace vdamf
