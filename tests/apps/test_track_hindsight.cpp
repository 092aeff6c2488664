// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: what the whole run tells, told in each frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/evaluation.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/annotated_rawlog.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;

class TrackHindsight : public TrackProgram
{
protected:
    const std::string hindsight_ = " --set output.hindsight=true ";
};

TEST_F(TrackHindsight, TellsInEachFrameWhatTheRunTells)
{
    const std::string street = "-q -i " + kStreet;
    ASSERT_EQ(track(street + " --tracks " + path("then.csv")).exitCode, 0);
    const Outcome run = track(street + hindsight_ + out("h.rawlog") + " --tracks " + path("h.csv") +
                              " --report " + path("h.html"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    const std::vector<TrackRow> then = readTracks(at("then.csv"));
    const std::vector<TrackRow> told = readTracks(at("h.csv"));
    ASSERT_EQ(then.size(), told.size());
    std::map<std::uint64_t, std::set<double>> lengths;
    std::map<std::uint64_t, int> confirmed;
    std::size_t published = 0;
    for (std::size_t k = 0; k < then.size(); ++k)
    {
        ASSERT_EQ(then[k].report.id, told[k].report.id);
        ASSERT_EQ(then[k].time, told[k].time);
        EXPECT_EQ(then[k].report.points, told[k].report.points);
        if (told[k].report.isVehicle.value())
            lengths[told[k].report.id].insert(told[k].report.box.length);
        confirmed[told[k].report.id] += then[k].report.status == TrackStatus::Confirmed ? 1 : 0;
        published += told[k].report.status == TrackStatus::Confirmed ? 1 : 0;
        published -= then[k].report.status == TrackStatus::Confirmed ? 1 : 0;
    }
    EXPECT_GT(published, 20U) << "frames of tracks before they were confirmed";
    for (const auto& [id, all] : lengths)
    {
        if (confirmed[id] > 5)
        {
            EXPECT_EQ(all.size(), 1U) << "track " << id;
        }
    }

    const std::vector<TruthRow> truth = readTruth(VDAMF_SOURCE_DIR "/datasets/street/truth.csv");
    EvaluationOptions options;
    options.scoring.minPoints = 20;
    options.scoring.maxRange = 60.0;
    const Evaluation before = evaluate(truth, then, options);
    const Evaluation after = evaluate(truth, told, options);
    EXPECT_LT(after.errors.position.rms, 0.8 * before.errors.position.rms);
    EXPECT_GT(after.clearMot.recall, before.clearMot.recall);

    const Annotations annotations = readAnnotations(at("h.rawlog"));
    EXPECT_TRUE(annotations.configuration.output.hindsight) << "its head says so";
    std::size_t rows = 0;
    for (const auto& [time, tracks] : annotations.tables)
        for (const TrackReport& report : tracks)
            EXPECT_NEAR(report.box.length, told[rows++].report.box.length, 1e-4);
    EXPECT_EQ(rows, told.size());
    EXPECT_THAT(contentOf("h.html"), HasSubstr("</html>"));
}

TEST_F(TrackHindsight, TellsItsProgressOverBothReadings)
{
    TrackRawlogJob job;
    job.input = kStreet;
    job.tracks = at("t.csv");
    job.lastFrame = 20;
    job.configuration.output.hindsight = true;
    std::vector<double> first;
    std::vector<double> second;
    trackRawlog(
        job, std::atomic<bool>(false),
        [&](const LadarFrame&, const FrameResult&, double share) { second.push_back(share); },
        [&](double share) { first.push_back(share); });
    ASSERT_EQ(first.size(), 20U);
    ASSERT_EQ(second.size(), 20U);
    first.insert(first.end(), second.begin(), second.end());
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
    EXPECT_GE(first.front(), 0.0);
    EXPECT_LE(first.back(), 1.0);
}

TEST_F(TrackHindsight, AFirstReadingThatIsStoppedLeavesNothing)
{
    TrackRawlogJob job;
    job.input = kStreet;
    job.output = at("h.rawlog");
    job.configuration.output.hindsight = true;
    std::atomic<bool> stop(false);
    const TrackRawlogSummary summary = trackRawlog(job, stop, {}, [&](double) { stop = true; });
    EXPECT_TRUE(summary.interrupted);
    EXPECT_EQ(summary.frames, 0U);
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(TrackHindsight, NeedsAFileThatCanBeReadTwice)
{
    const Outcome run =
        runShell("cat " + kStreet + " | " VDAMF_APPS_DIR "/vdamf-track -q -i /dev/stdin" +
                 hindsight_ + out("h.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("/dev/stdin: "), HasSubstr("hindsight"),
                                  HasSubstr("reads it twice")));
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(TrackHindsight, AMissingInputIsSaidToBeMissing)
{
    const Outcome run = track("-q" + in("no.rawlog") + hindsight_ + out("h.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("no.rawlog: "), HasSubstr("No such file")));
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(TrackHindsight, ACutRawlogIsToldUpToTheCut)
{
    const std::string whole = readTextFile(kStreet);
    make("cut.rawlog", whole.substr(0, whole.size() / 2));
    const Outcome run = track("-q" + in("cut.rawlog") + hindsight_ + " --tracks " + path("t.csv"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("truncated"));
    EXPECT_GT(readTracks(at("t.csv")).size(), 100U);
}

TEST_F(TrackHindsight, WithoutFramesItLeavesNothing)
{
    const Outcome run = track("-q --frames 5000: -i " + kStreet + hindsight_ + out("h.rawlog"));
    EXPECT_NE(run.exitCode, 0);
    EXPECT_THAT(run.output, HasSubstr("frame 5000"));
    EXPECT_EQ(filesInFolder(), 0U);
}
}  // namespace
}  // namespace vdamf
