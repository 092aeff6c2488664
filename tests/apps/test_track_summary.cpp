// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: what it says about the entries and poses that it read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationGPS.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <fstream>
#include <string>

#include "apps/track_fixture.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/velodyne_packets.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kStart = 1.7e9;

mrpt::obs::CObservationRobotPose pose(double time)
{
    mrpt::obs::CObservationRobotPose observation;
    observation.timestamp = mrpt::Clock::fromDouble(kStart + time);
    observation.sensorLabel = "ins";
    return observation;
}

std::string scan(double time)
{
    VelodyneFiring firing;
    firing.range.assign(16, 10.0F);
    firing.intensity.assign(16, 0.5F);
    auto observation = encodeVelodyne(VelodyneModel::VLP16, kStart + time,
                                      std::vector<VelodyneFiring>(24, firing));
    observation.sensorLabel = "roof";
    return serialized(observation);
}

class TrackSummary : public TrackProgram
{
protected:
    Outcome run(const std::string& bytes, const std::string& options = "")
    {
        make("a.rawlog", bytes);
        return track(in("a.rawlog") + " --overwrite --tracks " + path("t.csv") + options);
    }
};

TEST_F(TrackSummary, SaysHowManyEntriesWereReadUnknownAndDamagedAndWhere)
{
    const std::string unknown = std::string("\x86") + "a::Odd" + '\0' + "payload\x88";
    std::string damaged = serialized(pose(0.25));
    damaged.erase(60, 9);
    const std::string head = serialized(pose(0.0)) + scan(0.1);
    const Outcome result =
        run(head + unknown + serialized(pose(0.2)) + damaged + serialized(pose(0.4)));
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_THAT(result.output,
                AllOf(HasSubstr("entries            4 read, 1 of unknown classes, 1 damaged\n"),
                      HasSubstr("byte " + std::to_string(head.size()) + ": unknown class a::Odd"),
                      HasSubstr("byte " +
                                std::to_string(head.size() + unknown.size() +
                                               serialized(pose(0.2)).size()) +
                                ": mrpt::obs::CObservationRobotPose")));
}

TEST_F(TrackSummary, SaysWhatIsWrongWithThePoses)
{
    const Outcome result =
        run(serialized(pose(0.0)) + serialized(pose(0.2)) + serialized(pose(0.1)) + scan(0.15) +
            serialized(pose(0.2)) + serialized(pose(1.5)) + serialized(pose(0.05)));
    EXPECT_EQ(result.exitCode, 0) << result.output;
    EXPECT_THAT(result.output,
                AllOf(HasSubstr("'ins', 5 samples, 2 out of order, 1 of a time that was there\n"),
                      HasSubstr("1 times without poses, the longest 1.30 s"),
                      HasSubstr("the clock of the poses goes back 1 times")));
}

TEST_F(TrackSummary, SaysThatPosesThatErrAreCorrectedByWhatStands)
{
    const Outcome simulated = runApp(
        "vdamf-simulate",
        VDAMF_SOURCE_DIR "/datasets/scenarios/noisy_ins.ini -q --set scenario.duration_s=2 -o " +
            path("n.rawlog"));
    ASSERT_EQ(simulated.exitCode, 0) << simulated.output;
    const std::string tracked = in("n.rawlog") + " --overwrite --tracks " + path("t.csv");
    EXPECT_THAT(track(tracked).output, HasSubstr("  corrected        in "));
    EXPECT_THAT(track(tracked + " --set alignment.enabled=false").output,
                Not(HasSubstr("corrected")));

    // Where the world of the poses lies in that of the tracks stands beside these, and is no pose.
    ASSERT_EQ(track(in("n.rawlog") + out("a.rawlog") + " --tracks " + path("a.csv")).exitCode, 0);
    const Contents annotated(path("a.rawlog"));
    int alignments = 0;
    for (const RawlogEntry& entry : annotated.entries)
    {
        const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(entry.object);
        if (!pose || pose->sensorLabel != "vdamf_tracks_alignment") continue;
        ++alignments;
        EXPECT_LT(pose->pose.mean.norm(), 1.0);
    }
    EXPECT_GT(alignments, 5);
    ASSERT_EQ(track(in("a.rawlog") + " --tracks " + path("b.csv")).exitCode, 0);
    EXPECT_EQ(contentOf("a.csv"), contentOf("b.csv"));
    const Outcome page = runApp("vdamf-report", path("a.rawlog") + " -o " + path("a.html"));
    EXPECT_EQ(page.exitCode, 0) << page.output;
}

TEST_F(TrackSummary, AStandingSensorNeedsNoPoses)
{
    const Outcome without = run(scan(0.1) + scan(0.2));
    EXPECT_EQ(without.exitCode, 1);
    EXPECT_THAT(without.output, HasSubstr("no INS pose at the time of any scan"));
    const Outcome standing = run(scan(0.1) + scan(0.2), " --set ins.source=standing");
    EXPECT_EQ(standing.exitCode, 0) << standing.output;
    EXPECT_THAT(standing.output, AllOf(HasSubstr("INS poses          none, standing\n"),
                                       HasSubstr("frames             2 of 2 scans")));
}

}  // namespace
}  // namespace vdamf
