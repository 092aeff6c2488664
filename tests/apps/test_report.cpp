// SPDX-License-Identifier: BSD-3-Clause
// vdamf-report: what it makes of an annotated rawlog, and what it says where it cannot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include <mrpt/obs/CObservationRawDAQ.h>

#include "apps/track_fixture.h"
#include "report/page_data.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/rawlog/annotated_rawlog.h"
#include "vdamf/rawlog/annotation_table.h"
#include "vdamf/rawlog/rawlog_writer.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

class Report : public TrackProgram
{
protected:
    Outcome report(const std::string& arguments) const { return runApp("vdamf-report", arguments); }
    void trackStreet(const std::string& more) const
    {
        const Outcome run = track("-q -i " + kStreet + out("t.rawlog") + " " + more);
        ASSERT_EQ(run.exitCode, 0) << run.output;
    }
};

const std::string kTruth = " --truth " VDAMF_SOURCE_DIR "/datasets/street/truth.csv";

/// All that a run hands to its listener.
struct Seen
{
    std::vector<LadarFrame> frames;
    std::vector<FrameResult> results;

    FrameListener listener()
    {
        return [this](const LadarFrame& frame, const FrameResult& result, double)
        {
            frames.push_back(frame);
            results.push_back(result);
        };
    }
};

TEST_F(Report, ReplaysWhatWasTracked)
{
    TrackRawlogJob job;
    job.input = kStreet;
    job.output = at("t.rawlog");
    job.firstFrame = 30;
    job.lastFrame = 36;
    job.version = "1.2.3";
    job.configuration.tracker.ground.minRange = 3.5;
    const std::atomic<bool> stop{false};
    Seen tracked;
    trackRawlog(job, stop, tracked.listener());
    const Annotations annotations = readAnnotations(at("t.rawlog"));
    EXPECT_EQ(annotations.version, "1.2.3");
    EXPECT_EQ(annotations.insSource, "CObservationRobotPose 'ins'");
    EXPECT_EQ(annotations.configurationProblem, "");
    EXPECT_EQ(annotations.configuration.tracker.ground.minRange, 3.5);
    Seen replayed;
    const ReplaySummary summary =
        replayRawlog(at("t.rawlog"), annotations, stop, replayed.listener());
    EXPECT_EQ(summary.frames, 6U);
    EXPECT_EQ(summary.tablesUnused, 0U);
    ASSERT_EQ(replayed.frames.size(), tracked.frames.size());
    for (std::size_t f = 0; f < tracked.frames.size(); ++f)
    {
        EXPECT_EQ(replayed.frames[f].time, tracked.frames[f].time);
        EXPECT_EQ(replayed.frames[f].sensor, tracked.frames[f].sensor);
        EXPECT_EQ(replayed.frames[f].points.x, tracked.frames[f].points.x);
        EXPECT_EQ(replayed.frames[f].points.z, tracked.frames[f].points.z);
        const auto& a = replayed.results[f].tracks;
        const auto& b = tracked.results[f].tracks;
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k)
        {
            EXPECT_EQ(a[k].id, b[k].id);
            EXPECT_EQ(a[k].status, b[k].status);
            EXPECT_EQ(a[k].box.x, b[k].box.x);
            EXPECT_EQ(a[k].nis, b[k].nis);
            EXPECT_EQ(a[k].measuredBox.has_value(), b[k].measuredBox.has_value());
        }
    }
}

TEST_F(Report, IsOnePageOfTheRun)
{
    trackStreet("--frames 20:30 --tracks " + path("t.csv"));
    const Outcome run = report(path("t.rawlog") + " -o " + path("r.html") + kTruth);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("r.html: 10 frames"));
    const nlohmann::json data = test::runOf(contentOf("r.html"));
    EXPECT_EQ(data["facts"]["title"], "t.rawlog");
    EXPECT_THAT(data["facts"]["configuration"].get<std::string>(), HasSubstr("[clustering]"));
    ASSERT_EQ(data["frames"]["time"].size(), 10U);
    EXPECT_EQ(data["frames"]["points"][0].get<int>() > 5000, true);
    EXPECT_GT(data["tracks"].size(), 10U);
    EXPECT_GT(data["truth"]["objects"].size(), 10U);
    EXPECT_FALSE(data["truth"]["metrics"]["clear_mot"]["recall"].is_null());
    // The rows of the table are those of the page.
    std::size_t rows = 0;
    for (const auto& track : data["tracks"]) rows += track["frame"].size();
    std::ifstream table(at("t.csv"));
    std::size_t lines = 0;
    for (std::string line; std::getline(table, line);) ++lines;
    EXPECT_EQ(rows + 1, lines);
}

TEST_F(Report, JudgesByTheTruthOfTheFramesTracked)
{
    trackStreet("--frames 60:80");
    const Outcome run = report(path("t.rawlog") + " -o " + path("r.html") + kTruth);
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("truth.csv: 100 of its 120 frames are none that were "
                                      "tracked: left out"));
    const nlohmann::json truth = test::runOf(contentOf("r.html"))["truth"];
    EXPECT_EQ(truth["metrics"]["scored"]["frames"], 20);
    EXPECT_GT(truth["metrics"]["clear_mot"]["recall"].get<double>(), 0.5);
    for (const auto& mistake : truth["mistakes"])
        EXPECT_LE(mistake["frames"].get<int>(), 20) << mistake.dump();
}

TEST_F(Report, ComesFromTheTrackerItselfWithTimes)
{
    trackStreet("--frames 20:23 --report " + path("r.html") + " --scene " + path("r.3Dscene"));
    const nlohmann::json data = test::runOf(contentOf("r.html"));
    EXPECT_EQ(data["frames"]["time"].size(), 3U);
    EXPECT_EQ(data["facts"]["stages"].size(), 11U);
    EXPECT_EQ(data["truth"], nullptr);
    EXPECT_GT(fs::file_size(at("r.3Dscene")), 10000U);
    ASSERT_EQ(report(path("t.rawlog") + " -q -o " + path("again.html")).exitCode, 0);
    EXPECT_EQ(test::runOf(contentOf("again.html"))["tracks"], data["tracks"]);
}

TEST_F(Report, TellsWhatWasLostOfItsInput)
{
    trackStreet("--frames 0:30");
    fs::resize_file(at("t.rawlog"), fs::file_size(at("t.rawlog")) / 2);
    const Outcome cut =
        report("'" + at("t.rawlog").string() + "' -o '" + at("t.html").string() + "'");
    EXPECT_EQ(cut.exitCode, 1);
    EXPECT_THAT(cut.output, AllOf(HasSubstr("t.rawlog: truncated: "), HasSubstr("frames before")));
    EXPECT_GT(fs::file_size(at("t.html")), 100000U) << "what there is";
}

TEST_F(Report, LeavesOutTablesThatMakeNoSense)
{
    trackStreet("--frames 0:30");
    const auto names = annotationColumns();
    const auto id =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), "track_id") - names.begin());
    std::size_t tables = 0;
    const auto damage = [&](const std::string& name, std::size_t first, std::size_t last)
    {
        RawlogWriter writer(at(name), {});
        tables = 0;
        for (const RawlogEntry& entry : Contents(at("t.rawlog")).entries)
        {
            auto* table = dynamic_cast<mrpt::obs::CObservationRawDAQ*>(entry.object.get());
            const bool holdsTracks = table != nullptr && !table->AIN_double.empty();
            tables += holdsTracks ? 1 : 0;
            if (!holdsTracks || tables <= first || tables > last)
            {
                writer.writeBytes(entry.bytes);
                continue;
            }
            table->AIN_double[id] = 8.000000001;
            writer.write(*table);
        }
        writer.commit();
        return report(path(name) + " -o " + path(name + ".html"));
    };
    const Outcome two = damage("two.rawlog", 3, 5);
    EXPECT_EQ(two.exitCode, 0);
    EXPECT_THAT(two.output, HasSubstr("two.rawlog: 2 of its tables of tracks cannot be read, their "
                                      "frames are left out; the first one, at "));
    EXPECT_THAT(two.output, HasSubstr(" s: an impossible track_id: 8.000000001"));
    EXPECT_EQ(test::runOf(contentOf("two.rawlog.html"))["frames"]["time"].size(), 28U);
    const Outcome all = damage("all.rawlog", 0, 30);
    EXPECT_EQ(all.exitCode, 1);
    EXPECT_THAT(all.output, HasSubstr("all.rawlog: none of its 30 tables of tracks can be read"));
}

TEST_F(Report, SaysWhereTheFramesOfJoinedRunsAreTheSame)
{
    trackStreet("--frames 0:10");
    make("joined.rawlog", contentOf("t.rawlog") + contentOf("t.rawlog"));
    const Outcome joined = report(path("joined.rawlog") + " -o " + path("joined.html"));
    EXPECT_EQ(joined.exitCode, 0);
    EXPECT_THAT(joined.output, AllOf(HasSubstr("joined.rawlog: 10 of its tables of tracks"),
                                     HasSubstr("joined.html: 10 frames")));
}

TEST_F(Report, CountsWhatItCannotReadAsTheTrackerDoes)
{
    trackStreet("--frames 0:5 --set output.gz_level=0");
    make("odd.rawlog", contentOf("t.rawlog") + "\x86" + "a::Odd" + '\0' + "payload\x88");
    const Outcome odd =
        report("'" + at("odd.rawlog").string() + "' -o '" + at("odd.html").string() + "'");
    EXPECT_EQ(odd.exitCode, 0);
    EXPECT_THAT(odd.output, AllOf(HasSubstr("odd.rawlog: 1 entry of unknown classes"),
                                  HasSubstr(": unknown class a::Odd")));
}

TEST_F(Report, NeedsNoFileThatTheConfigurationNames)
{
    fs::copy(VDAMF_SOURCE_DIR "/models/vehicle.txt", at("own.txt"));
    trackStreet("--frames 0:5 --set ground.min_height_m=0.31 --set discriminator.model='" +
                at("own.txt").string() + "'");
    fs::remove(at("own.txt"));
    const Annotations annotations = readAnnotations(at("t.rawlog"));
    EXPECT_EQ(annotations.configurationProblem, "");
    EXPECT_EQ(annotations.configuration.tracker.ground.minHeight, 0.31);
    EXPECT_EQ(annotations.configuration.tracker.discriminator.model, at("own.txt").string());
}

TEST_F(Report, SaysWhatIsWrong)
{
    const auto expect = [&](const std::string& arguments, int exitCode, const std::string& words)
    {
        const Outcome run = report(arguments);
        EXPECT_EQ(run.exitCode, exitCode) << arguments;
        EXPECT_THAT(run.output, AllOf(StartsWith("vdamf-report: "), HasSubstr(words)));
    };
    const std::string to = " -o " + path("r.html");
    expect(kStreet + to, 1, "street.rawlog: has no tables of tracks");
    expect(path("none.rawlog") + to, 1, "none.rawlog");
    expect(kStreet, 2, "--output is required");
    expect(kStreet + to + " --region-fov-deg nan", 2, "0 to 360");
    for (const std::string option :
         {"--region-fov-deg 80", "--max-range-m 9", "--min-points 9", "--vehicles-only"})
        expect(kStreet + to + " " + option, 2, "requires --truth");
    trackStreet("--frames 0:3");
    expect(path("t.rawlog") + " -o " + path("t.rawlog"), 2, "is the input");
    expect(path("t.rawlog") + to + " --truth " + path("none.csv"), 1, "none.csv");
    make("head.csv", truthHeader());
    expect(
        path("t.rawlog") + to + " --truth " + path("head.csv"), 1,
        "truth " + path("head.csv") + ", tracks " + path("t.rawlog") + ": the truth has no rows");
    make("r.html", "precious");
    expect(path("t.rawlog") + to, 1, "--overwrite");
    EXPECT_EQ(contentOf("r.html"), "precious");
    EXPECT_EQ(report(path("t.rawlog") + to + " --overwrite").exitCode, 0);
    EXPECT_THAT(report("--version").output, testing::MatchesRegex("vdamf-report [0-9.]+\n"));
}

}  // namespace
}  // namespace vdamf
