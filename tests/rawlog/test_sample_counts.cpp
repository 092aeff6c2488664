// SPDX-License-Identifier: BSD-3-Clause
// How much is read of MRPT's sample rawlogs, and of damaged ones beside MRPT's own reader.
#include <gtest/gtest.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "../files/temporary_folder.h"
#include "example_objects.h"
#include "sample_rawlogs.h"
#include "two_readers.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
struct Counts
{
    std::size_t entries = 0;
    std::size_t observations = 0;
    std::size_t scans = 0;
    std::size_t points = 0;
};

void count(const mrpt::obs::CObservation& observation, const std::filesystem::path& rawlog,
           Counts& counts)
{
    ++counts.observations;
    if (!isScan(observation)) return;
    ++counts.scans;
    counts.points += scanFrom(observation, ExternalFiles(rawlog))->points.size();
}

Counts countsOf(const std::filesystem::path& rawlog)
{
    Counts counts;
    RawlogReader reader(rawlog);
    while (const auto entry = reader.next())
    {
        ++counts.entries;
        if (auto one = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object))
            count(*one, rawlog, counts);
        if (auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry->object))
            for (const auto& one : *frame) count(*one, rawlog, counts);
    }
    EXPECT_EQ(reader.summary().unknown + reader.summary().damaged, 0U);
    EXPECT_FALSE(reader.summary().truncated);
    return counts;
}

TEST(SampleCounts, EveryPointIsRead)
{
    struct Sample
    {
        const char* name;
        Counts expected;
    };
    for (const Sample& sample : {Sample{"test_velodyne_VLP16.rawlog", {1, 1, 1, 22591}},
                                 Sample{"rot_scan_velodyne.rawlog", {1, 1, 1, 11305}},
                                 Sample{"rot_scan_2d.rawlog", {1, 1, 1, 359}},
                                 Sample{"test_rtk_path.rawlog", {692, 692, 0, 0}},
                                 Sample{"test-3d-obs-ground.rawlog", {1, 1, 1, 37662}},
                                 Sample{"tests_rgbd.rawlog", {1, 1, 1, 273225}},
                                 Sample{"test-imu-obs-format3.rawlog", {1, 1, 0, 0}},
                                 Sample{"test-imu-obs-format4.rawlog", {1, 1, 0, 0}}})
    {
        SCOPED_TRACE(sample.name);
        const auto path = test::sampleRawlog(sample.name);
        if (path.empty()) GTEST_SKIP() << test::whereSamplesAre();
        const Counts counts = countsOf(path);
        EXPECT_EQ(counts.entries, sample.expected.entries);
        EXPECT_EQ(counts.observations, sample.expected.observations);
        EXPECT_EQ(counts.scans, sample.expected.scans);
        EXPECT_EQ(counts.points, sample.expected.points);
    }
}

class DamagedCounts : public TemporaryFolder
{
protected:
    static constexpr int kObservations = 100;

    /// Single observations, `what` before number 10.
    std::filesystem::path rawlogWith(const std::string& what)
    {
        std::string bytes;
        for (int i = 0; i < kObservations; ++i)
            bytes += (i == 10 ? what : "") + serialized(test::odometry(i));
        return make("damaged.rawlog", bytes);
    }
};

TEST_F(DamagedCounts, WhereMrptStopsReadingGoesOn)
{
    const auto whole = rawlogWith("");
    EXPECT_EQ(test::countByMrpt(whole), 100U);
    EXPECT_EQ(test::countByUs(whole), 100U);
    const auto unknown = rawlogWith(test::unknownObject("mrpt::obs::CNew", "payload"));
    EXPECT_EQ(test::countByMrpt(unknown), 10U);
    EXPECT_EQ(test::countByUs(unknown), 100U);
    const auto garbage = rawlogWith(std::string(40, '\x7f'));
    EXPECT_EQ(test::countByMrpt(garbage), 10U);
    EXPECT_EQ(test::countByUs(garbage), 100U);
    std::string hit = serialized(test::odometry(7));
    hit[hit.size() / 2] = '\xff';
    hit.erase(hit.size() / 2 + 1, 5);
    const auto cut = rawlogWith(hit);
    EXPECT_LT(test::countByMrpt(cut), 20U);
    EXPECT_GE(test::countByUs(cut), 100U);
}

TEST_F(DamagedCounts, SensoryFramesWithoutActionsAreRead)
{
    std::string bytes;
    for (int i = 0; i < 5; ++i)
    {
        mrpt::obs::CSensoryFrame frame;
        frame.insert(mrpt::obs::CObservationOdometry::Create(test::odometry(i)));
        bytes += serialized(frame);
    }
    const auto path = make("frames.rawlog", bytes);
    EXPECT_EQ(test::countByMrpt(path), 0U);
    EXPECT_EQ(test::countByUs(path), 5U);
}

TEST_F(DamagedCounts, OfAnOverwrittenGzFileTheOtherMembersAreRead)
{
    RawlogWriter::Options options;
    options.memberBytes = 2000;
    RawlogWriter writer(at("whole.rawlog"), options);
    for (int i = 0; i < kObservations; ++i) writer.write(test::odometry(i));
    writer.commit();
    std::string bytes = contentOf("whole.rawlog");
    bytes.replace(bytes.size() / 3, 40, std::string(40, 'x'));
    const auto path = make("hit.rawlog", bytes);
    EXPECT_LT(test::countByMrpt(path), 50U);
    EXPECT_GT(test::countByUs(path), 70U);
}

}  // namespace
}  // namespace vdamf
