// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track through its command line, on the shipped dataset.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation3DScene.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRawDAQ.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>
#include <map>
#include <set>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/box_overlap.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/annotation.h"
#include "vdamf/rawlog/annotation_table.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

// Entries that vdamf-track added.
bool isAdded(const RawlogEntry& entry)
{
    if (std::dynamic_pointer_cast<mrpt::obs::CObservation3DScene>(entry.object)) return true;
    if (std::dynamic_pointer_cast<mrpt::obs::CObservationComment>(entry.object)) return true;
    const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry.object);
    return observation && isAnnotation(*observation);
}

TEST_F(TrackProgram, AnnotatesEveryFrameBehindItsScan)
{
    const Outcome run =
        track("-i " + kStreet + out("a.rawlog") + " --tracks " + path("t.csv") + " --frames 0:30");
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, AllOf(HasSubstr("frames             30"), HasSubstr("matched filter")));
    const Contents log(at("a.rawlog"));
    const auto comment = log.as<mrpt::obs::CObservationComment>(0);
    ASSERT_TRUE(comment);
    EXPECT_THAT(comment->text, AllOf(HasSubstr("table_columns = time_s,track_id,status"),
                                     HasSubstr("origin = "), HasSubstr("[clustering]")));

    std::map<std::string, int> rowsOfTime;
    std::map<std::string, int> published;
    for (const TrackRow& row : readTracks(at("t.csv")))
    {
        const std::string time = std::to_string(row.time);
        ++rowsOfTime[time];
        if (row.report.status == TrackStatus::Confirmed ||
            row.report.status == TrackStatus::Coasting)
            ++published[time];
    }
    int scans = 0;
    for (std::size_t i = 0; i < log.entries.size(); ++i)
    {
        const auto scan = log.as<mrpt::obs::CObservationVelodyneScan>(i);
        if (!scan) continue;
        ++scans;
        const std::string time = std::to_string(mrpt::Clock::toDouble(scan->timestamp));
        const auto table = log.as<mrpt::obs::CObservationRawDAQ>(i + 1);
        ASSERT_TRUE(table);
        EXPECT_EQ(table->sensorLabel, "vdamf_tracks");
        EXPECT_EQ(table->timestamp, scan->timestamp);
        EXPECT_EQ(table->AIN_channel_count, annotationColumns().size());
        EXPECT_EQ(table->AIN_double.size(),
                  annotationColumns().size() * static_cast<std::size_t>(rowsOfTime[time]));
        std::size_t next = i + 2;
        for (int k = 0; k < published[time]; ++k, ++next)
        {
            const auto pose = log.as<mrpt::obs::CObservationRobotPose>(next);
            ASSERT_TRUE(pose);
            EXPECT_EQ(pose->timestamp, scan->timestamp);
            EXPECT_THAT(pose->sensorLabel, HasSubstr("vdamf_track_"));
            EXPECT_GT(pose->pose.cov(0, 0), 0.0);
        }
        const auto scene = log.as<mrpt::obs::CObservation3DScene>(next);
        ASSERT_TRUE(scene);
        EXPECT_EQ(scene->timestamp, scan->timestamp);
    }
    EXPECT_EQ(scans, 30);
}

TEST_F(TrackProgram, KeepsEveryInputByte)
{
    ASSERT_EQ(track("-q -i " + kStreet + out("a.rawlog")).exitCode, 0);
    std::string original;
    for (const RawlogEntry& entry : Contents(kStreet).entries) original += entry.bytes;
    std::string kept;
    for (const RawlogEntry& entry : Contents(at("a.rawlog")).entries)
        if (!isAdded(entry)) kept += entry.bytes;
    EXPECT_TRUE(original == kept) << original.size() << " bytes in, " << kept.size() << " kept";
}

TEST_F(TrackProgram, SameInputSameBytes)
{
    const std::string frames = "-q --frames 0:25 -i " + kStreet;
    ASSERT_EQ(track(frames + out("a.rawlog") + " --tracks " + path("a.csv")).exitCode, 0);
    ASSERT_EQ(track(frames + out("b.rawlog") + " --tracks " + path("b.csv")).exitCode, 0);
    EXPECT_TRUE(contentOf("a.csv") == contentOf("b.csv"));
    EXPECT_TRUE(contentOf("a.rawlog") == contentOf("b.rawlog"));
}

TEST_F(TrackProgram, StockToolsReadTheAnnotatedRawlog)
{
    if (runShell("command -v rawlog-edit").exitCode != 0)
        GTEST_SKIP() << "rawlog-edit is not installed (package mrpt-apps)";
    ASSERT_EQ(track("-q --frames 0:20 -i " + kStreet + out("a.rawlog")).exitCode, 0);
    const Contents log(at("a.rawlog"));
    const Outcome info = runShell("rawlog-edit --info -i " + path("a.rawlog"));
    EXPECT_EQ(info.exitCode, 0);
    EXPECT_THAT(info.output, AllOf(HasSubstr("vdamf_tracks"), HasSubstr("velodyne"),
                                   HasSubstr(std::to_string(log.entries.size()))));
    ASSERT_EQ(runShell("rawlog-edit --keep-label velodyne,ins -i " + path("a.rawlog") + " -o " +
                       path("kept.rawlog"))
                  .exitCode,
              0);
    std::string kept;
    for (const RawlogEntry& entry : Contents(at("kept.rawlog")).entries) kept += entry.bytes;
    std::string original;
    for (const RawlogEntry& entry : log.entries)
        if (!isAdded(entry)) original += entry.bytes;
    EXPECT_TRUE(kept == original);
}

TEST_F(TrackProgram, FollowsTheVehiclesOfTheStreet)
{
    ASSERT_EQ(track("-q -i " + kStreet + " --tracks " + path("t.csv")).exitCode, 0);
    std::map<long, std::vector<TrackReport>> frames;
    for (const TrackRow& row : readTracks(at("t.csv")))
        if (row.report.status == TrackStatus::Confirmed)
            frames[std::lround(1e3 * row.time)].push_back(row.report);
    int boxes = 0;
    int overlapping = 0;
    std::set<std::uint64_t> vanIds;
    for (const TruthRow& truth : readTruth(VDAMF_SOURCE_DIR "/datasets/street/truth.csv"))
    {
        if (truth.points < 20) continue;
        ++boxes;
        for (const TrackReport& track : frames[std::lround(1e3 * truth.time)])
        {
            if (birdsEyeIou(track.box, truth.box) < 0.5) continue;
            ++overlapping;
            if (truth.objectId == "van_ahead") vanIds.insert(track.id);
        }
    }
    std::printf("street: %d of %d vehicle boxes with 20 hits or more overlap by half\n",
                overlapping, boxes);
    EXPECT_GT(boxes, 1000);
    EXPECT_GT(overlapping, 0.8 * boxes);
    EXPECT_EQ(vanIds.size(), 1U);
}

TEST_F(TrackProgram, ReadsActionsAndSensoryFrames)
{
    // The first two seconds of the street as pairs of action and sensory frame.
    RawlogReader reader(kStreet);
    {
        RawlogWriter writer(at("pairs.rawlog"), {});
        mrpt::obs::CSensoryFrame frame;
        for (int scans = 0; scans < 20;)
        {
            const auto entry = reader.next();
            ASSERT_TRUE(entry);
            const auto o = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object);
            frame.insert(o);
            if (!isScan(*o)) continue;
            writer.write(mrpt::obs::CActionCollection());
            writer.write(frame);
            frame.clear();
            ++scans;
        }
        writer.commit();
    }
    const Outcome pairs =
        track(in("pairs.rawlog") + out("p.rawlog") + " --tracks " + path("p.csv"));
    ASSERT_EQ(pairs.exitCode, 0) << pairs.output;
    const Outcome plain = track("-i " + kStreet + " --frames 0:19 --tracks " + path("o.csv"));
    ASSERT_EQ(plain.exitCode, 0) << plain.output;
    // The last scan of the pairs lacks the pose behind it, the others are the same.
    const std::string shared = contentOf("o.csv");
    EXPECT_EQ(contentOf("p.csv").substr(0, shared.size()), shared);
    const Contents log(at("p.rawlog"));
    EXPECT_EQ(log.entries[1].kind, RawlogEntry::Kind::Action);
    EXPECT_TRUE(log.as<mrpt::obs::CSensoryFrame>(2));
    EXPECT_TRUE(log.as<mrpt::obs::CObservationRawDAQ>(3));
}

TEST_F(TrackProgram, ShippedConfigurationIsTheBuiltInOne)
{
    const Outcome printed = track("--print-config");
    EXPECT_EQ(printed.exitCode, 0);
    std::ifstream file(VDAMF_SOURCE_DIR "/config.ini");
    const std::string shipped{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(printed.output == shipped)
        << "config.ini differs; regenerate it: vdamf-track --print-config > config.ini";
    make("c.ini", shipped);
    EXPECT_TRUE(track("--print-config -c " + path("c.ini")).output == shipped);
}

}  // namespace
}  // namespace vdamf
