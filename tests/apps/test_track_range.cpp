// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: which scans are frames, in which order, and what the output's head says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/scan.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
namespace
{
using mrpt::obs::CObservation;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Observations = std::vector<CObservation::Ptr>;

class TrackRange : public TrackProgram
{
protected:
    // The street up to its scan `scans`, without it.
    static Observations street(int scans)
    {
        Observations all;
        RawlogReader reader(kStreet);
        while (const auto entry = reader.next())
        {
            auto o = std::dynamic_pointer_cast<CObservation>(entry->object);
            if (isScan(*o) && scans-- == 0) break;
            all.push_back(std::move(o));
        }
        return all;
    }

    // First all poses, then the scans: nothing has to be waited for.
    static std::pair<Observations, Observations> posesAndScans(int scans)
    {
        std::pair<Observations, Observations> both;
        for (const auto& o : street(scans)) (isScan(*o) ? both.second : both.first).push_back(o);
        return both;
    }

    void write(const std::string& name, const Observations& observations) const
    {
        RawlogWriter::Options options;
        options.existing = OutputFile::Existing::Overwrite;
        RawlogWriter writer(at(name), options);
        for (const auto& o : observations) writer.write(*o);
        writer.commit();
    }

    static std::string originOf(const mrpt::obs::CObservationComment& comment)
    {
        const std::size_t begin = comment.text.find("origin = ") + 9;
        return comment.text.substr(begin, comment.text.find('\n', begin) - begin);
    }
};

TEST_F(TrackRange, MayEndInsideASensoryFrame)
{
    const auto [poses, scans] = posesAndScans(4);
    mrpt::obs::CSensoryFrame first;
    for (const auto& pose : poses) first.insert(pose);
    for (const auto& scan : scans) first.insert(scan);
    RawlogWriter writer(at("in.rawlog"), {});
    writer.write(first);
    writer.commit();
    const Outcome run = track("-i " + path("in.rawlog") + out("a.rawlog") + " --frames 0:2");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames             2 of 2 scans"));
    const Contents log(at("a.rawlog"));
    ASSERT_GT(log.entries.size(), 2U);
    EXPECT_TRUE(log.as<mrpt::obs::CSensoryFrame>(1));
    int tables = 0;
    for (std::size_t i = 2; i < log.entries.size(); ++i)
        if (log.as<mrpt::obs::CObservationRawDAQ>(i)) ++tables;
    EXPECT_EQ(tables, 2);
}

TEST_F(TrackRange, LooksAtNoScanOutsideOfIt)
{
    Observations all = street(8);
    int scans = 0;
    for (auto& o : all)
    {
        if (!isScan(*o) || (++scans > 3 && scans < 7)) continue;
        auto broken = mrpt::obs::CObservationPointCloud::Create();  // without points
        broken->timestamp = o->timestamp;
        o = broken;
    }
    write("in.rawlog", all);
    const Outcome run = track(in("in.rawlog") + out("a.rawlog") + " --frames 3:6");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("frames             3 of 3 scans"), Not(HasSubstr("skipped"))));
}

TEST_F(TrackRange, BehindTheLastScanIsNamedAsTheReason)
{
    Observations all = street(5);
    // The first scan has no pose: that is not why there is no frame.
    const auto firstScan =
        std::find_if(all.begin(), all.end(), [](const auto& o) { return isScan(*o); });
    std::rotate(all.begin(), firstScan, firstScan + 1);
    all.front()->timestamp -= std::chrono::seconds(100);
    write("in.rawlog", all);
    const Outcome run = track(in("in.rawlog") + out("a.rawlog") + " --frames 50:60");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("no frame in the range"), HasSubstr("frames 0 to 4"),
                                  Not(HasSubstr("INS pose"))));
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(TrackRange, HeadHasTheTimeAndOriginOfTheFirstFrame)
{
    const std::string tables = " --tracks " + path("t.csv") + " --overwrite";
    ASSERT_EQ(track("-q -i " + kStreet + out("whole.rawlog") + " --frames :25").exitCode, 0);
    ASSERT_EQ(track("-q -i " + kStreet + out("a.rawlog") + tables + " --frames 20:25").exitCode, 0);
    const auto whole = Contents(at("whole.rawlog")).as<mrpt::obs::CObservationComment>(0);
    const auto part = Contents(at("a.rawlog")).as<mrpt::obs::CObservationComment>(0);
    ASSERT_TRUE(whole && part);
    const double first = readTracks(at("t.csv")).front().time;
    EXPECT_NEAR(mrpt::Clock::toDouble(part->timestamp), first, 1e-5);
    EXPECT_EQ(originOf(*part), originOf(*whole));
    EXPECT_FALSE(originOf(*part).empty());
}

TEST_F(TrackRange, HeadWaitsForLatePoses)
{
    Observations all;
    int scans = 0;
    for (const auto& o : street(40))
    {
        scans += isScan(*o) ? 1 : 0;
        if (isScan(*o) || scans > 25) all.push_back(o);
    }
    write("in.rawlog", all);
    const Outcome run = track(in("in.rawlog") + out("a.rawlog") + " --tracks " + path("t.csv"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const Contents log(at("a.rawlog"));
    const auto comment = log.as<mrpt::obs::CObservationComment>(0);
    ASSERT_TRUE(comment);
    EXPECT_NEAR(mrpt::Clock::toDouble(comment->timestamp), readTracks(at("t.csv")).front().time,
                1e-5);
    EXPECT_FALSE(originOf(*comment).empty());
    EXPECT_TRUE(isScan(*log.as<CObservation>(1)));
    // Where less may be held back, the first scan's time must do.
    TrackRawlogJob job;
    job.input = at("in.rawlog");
    job.output = at("b.rawlog");
    job.heldBytes = 1000;
    trackRawlog(job, std::atomic<bool>(false));
    const auto early = Contents(at("b.rawlog")).as<mrpt::obs::CObservationComment>(0);
    ASSERT_TRUE(early);
    EXPECT_EQ(early->timestamp, all.front()->timestamp);
    EXPECT_EQ(Contents(at("b.rawlog")).entries.size(), log.entries.size());
}

TEST_F(TrackRange, SortsScansSlightlyOutOfOrder)
{
    auto [all, scans] = posesAndScans(20);
    Observations swapped = all;
    for (std::size_t i = 0; i < 20; ++i) all.push_back(scans[i]);
    for (std::size_t i = 0; i < 20; ++i) swapped.push_back(scans[i ^ 1U]);
    write("sorted.rawlog", all);
    write("swapped.rawlog", swapped);
    ASSERT_EQ(track(in("sorted.rawlog") + " --tracks " + path("a.csv")).exitCode, 0);
    const Outcome run =
        track(in("swapped.rawlog") + " --tracks " + path("b.csv") + out("b.rawlog"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, Not(HasSubstr("skipped")));
    EXPECT_EQ(contentOf("a.csv"), contentOf("b.csv"));
    // Each annotation stands behind its scan, in the file's order.
    const Contents log(at("b.rawlog"));
    for (std::size_t i = 0; i + 1 < log.entries.size(); ++i)
    {
        const auto o = log.as<CObservation>(i);
        if (!isScan(*o)) continue;
        EXPECT_EQ(log.as<CObservation>(i + 1)->timestamp, o->timestamp);
    }
}

TEST_F(TrackRange, OneWildStampCostsOneScan)
{
    for (const int hours : {-24, 24})
    {
        Observations all = street(20);
        int scans = 0;
        for (const auto& o : all)
            if (isScan(*o) && ++scans == 6) o->timestamp += std::chrono::hours(hours);
        write("in.rawlog", all);
        const Outcome run = track("--overwrite" + in("in.rawlog") + out("a.rawlog"));
        ASSERT_EQ(run.exitCode, 0);
        EXPECT_THAT(run.output, HasSubstr("frames             19 of 20 scans"));
    }
}

TEST_F(TrackRange, SaysWhatToDoWithTwoSensorsInOne)
{
    Observations all;
    for (const auto& o : street(10))
    {
        all.push_back(o);
        if (!isScan(*o)) continue;
        const auto copy = std::dynamic_pointer_cast<CObservation>(o->duplicateGetSmartPtr());
        copy->sensorLabel = "rear";
        all.push_back(copy);
    }
    write("in.rawlog", all);
    Outcome run = track(in("in.rawlog") + " --tracks " + path("a.csv"));
    ASSERT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("10 scans skipped: at the time of the frame before"),
                      HasSubstr("'rear'"), HasSubstr("'velodyne'"), HasSubstr("[scan] label")));
    run = track(in("in.rawlog") + " --set scan.label=rear --tracks " + path("b.csv"));
    EXPECT_THAT(run.output, Not(HasSubstr("skipped")));
    EXPECT_EQ(contentOf("a.csv"), contentOf("b.csv"));
}

TEST_F(TrackRange, TellsOfScansWithoutAStamp)
{
    Observations all = street(6);
    int scans = 0;
    for (const auto& o : all)
        if (isScan(*o) && ++scans > 4) o->timestamp = INVALID_TIMESTAMP;
    write("some.rawlog", all);
    Outcome run = track(in("some.rawlog") + out("a.rawlog"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("2 scans skipped: without a time stamp"),
                      HasSubstr("frames             4 of 4"), Not(HasSubstr("pose at"))));
    for (const auto& o : all)
        if (isScan(*o)) o->timestamp = INVALID_TIMESTAMP;
    write("none.rawlog", all);
    run = track(in("none.rawlog") + out("b.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("none of its 6 scans has a time stamp"),
                                  Not(HasSubstr("pose at"))));
}

}  // namespace
}  // namespace vdamf
