// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track: where outputs go, what is never replaced, and what full disks do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/csv.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
namespace fs = std::filesystem;

class TrackOutputs : public TrackProgram
{
protected:
    // On the first frames of the street.
    Outcome brief(const std::string& arguments) const
    {
        return track("--frames 0:3 -i " + kStreet + " " + arguments);
    }
};

TEST_F(TrackOutputs, AnOutputThatIsTheInputIsBadUse)
{
    make("in.rawlog", "precious");
    const std::string input = "-i " + path("in.rawlog") + " --overwrite ";
    fs::create_symlink("in.rawlog", at("link"));
    for (const std::string& output : {out("in.rawlog"), " --tracks " + path("link"),
                                      " --nis " + path("in.rawlog"), " --picture " + path("link")})
    {
        const Outcome run = track(input + output);
        EXPECT_EQ(run.exitCode, 2) << output;
        EXPECT_THAT(run.output, AllOf(StartsWith("vdamf-track: "), HasSubstr("is the input")));
    }
    EXPECT_EQ(contentOf("in.rawlog"), "precious");
    const Outcome run = brief(out("x") + " --nis " + path("x"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("two outputs"));
}

TEST_F(TrackOutputs, AreNotReplacedWhereAnInterruptedRunSavedThem)
{
    make("a.rawlog.partial", "rescued");
    const Outcome refused = brief(out("a.rawlog") + " --tracks " + path("t.csv"));
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, AllOf(HasSubstr("a.rawlog.partial: holds what an interrupted run"),
                                      HasSubstr("--overwrite")));
    EXPECT_EQ(contentOf("a.rawlog.partial"), "rescued");
    make("t.csv.partial", "rescued");
    EXPECT_EQ(brief(out("b.rawlog") + " --tracks " + path("t.csv")).exitCode, 1);
    EXPECT_EQ(filesInFolder(), 2U) << "no other output was begun";
    EXPECT_EQ(brief(out("a.rawlog") + " --overwrite").exitCode, 0);
    EXPECT_FALSE(fs::exists(at("a.rawlog.partial")));
}

TEST_F(TrackOutputs, GoThroughSymbolicLinks)
{
    make("disk/old.csv", "old");
    fs::create_symlink("disk/old.csv", at("t.csv"));
    const Outcome run = brief("--overwrite --tracks " + path("t.csv"));
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(fs::is_symlink(at("t.csv")));
    EXPECT_FALSE(readTracks(at("disk/old.csv")).empty());
}

TEST_F(TrackOutputs, AFullStandardOutputIsAFailure)
{
    const std::string app = VDAMF_APPS_DIR "/vdamf-track ";
    Outcome run = runShell(app + "--print-config > /dev/full");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(StartsWith("vdamf-track: "), HasSubstr("No space left")));
    run = runShell(app + "--frames 0:3 -i " + kStreet + out("a.rawlog") + " > /dev/full");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("No space left"));
    EXPECT_TRUE(fs::exists(at("a.rawlog")));
}

TEST_F(TrackOutputs, MayBeTheStandardOutput)
{
    for (const char* option : {"-o -", "--tracks -", "--nis -", "--picture -"})
    {
        const Outcome run = brief(option);
        EXPECT_EQ(run.exitCode, 2) << option;
        EXPECT_THAT(run.output, HasSubstr("/dev/stdout"));
    }
    EXPECT_FALSE(fs::exists("-"));
    const std::string app = VDAMF_APPS_DIR "/vdamf-track --frames 0:3 -i " + kStreet;
    const std::string table = " --tracks /dev/stdout ";
    ASSERT_EQ(brief("--tracks " + path("t.csv")).exitCode, 0);
    ASSERT_EQ(runShell(app + table + " > " + path("file.csv")).exitCode, 0);
    ASSERT_EQ(runShell(app + table + " | cat > " + path("pipe.csv")).exitCode, 0);
    EXPECT_EQ(contentOf("file.csv"), contentOf("t.csv"));
    EXPECT_EQ(contentOf("pipe.csv"), contentOf("t.csv"));
}

TEST_F(TrackOutputs, TellOfConsistency)
{
    const Outcome run =
        track("-i " + kStreet + " --tracks " + path("t.csv") + " --nis " + path("nis.csv"));
    ASSERT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, AllOf(HasSubstr("NIS of updates"), HasSubstr("95 % band"),
                                  HasSubstr("with too few updates")));
    std::map<std::int64_t, std::pair<std::int64_t, double>> expected;  // updates, sum of NIS
    for (const TrackRow& row : readTracks(at("t.csv")))
    {
        if (!row.report.nis || row.report.status != TrackStatus::Confirmed) continue;
        auto& [updates, sum] = expected[static_cast<std::int64_t>(row.report.id)];
        ++updates;
        sum += *row.report.nis;
    }
    CsvReader table(at("nis.csv"), {"track_id", "updates", "mean_nis_per_dof", "lower_bound",
                                    "upper_bound", "within_95", "verdict"});
    std::size_t rows = 0;
    for (; table.next(); ++rows)
    {
        const auto [updates, sum] = expected.at(table.integer("track_id"));
        EXPECT_EQ(table.integer("updates"), updates);
        const double mean = sum / (3.0 * static_cast<double>(updates));
        EXPECT_NEAR(table.number("mean_nis_per_dof"), mean, 1e-3 * (1.0 + mean));
        EXPECT_LT(table.number("lower_bound"), 1.0);
        EXPECT_GT(table.number("upper_bound"), 1.0);
        EXPECT_EQ(table.text("verdict") == "too_few", updates < 30);
    }
    EXPECT_EQ(rows, expected.size());
    EXPECT_GT(rows, 20U);
}

TEST_F(TrackOutputs, ConfigurationsAreReadWhole)
{
    make("mac.ini", "[ground]\r# a remark\rmin_range_m = 3.5\r");
    const Outcome run = track("--print-config -c " + path("mac.ini"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.output, HasSubstr("min_range_m = 3.5\n"));
    const Outcome crossed =
        brief(out("a.rawlog") + " --set ground.min_range_m=20 --set ground.max_range_m=20");
    EXPECT_EQ(crossed.exitCode, 2);
    EXPECT_THAT(crossed.output,
                AllOf(HasSubstr("ground.min_range_m = 20"), HasSubstr("ground.max_range_m = 20")));
    EXPECT_EQ(brief(out("a.rawlog") + " --set clustering.gap_m=0.9").exitCode, 2);
}

TEST_F(TrackOutputs, NamesItselfInVersionAndErrors)
{
    EXPECT_THAT(track("--version").output, testing::MatchesRegex("vdamf-track [0-9.]+\n"));
    EXPECT_THAT(track("--nonsense").output, StartsWith("vdamf-track: "));
    EXPECT_THAT(track("-o").output, StartsWith("vdamf-track: "));
}

TEST_F(TrackOutputs, OfARawlogTrackedAgainAreThoseOfTheNewRun)
{
    ASSERT_EQ(brief("-q" + out("once.rawlog")).exitCode, 0);
    const Outcome again = track("-q --frames 0:3" + in("once.rawlog") + out("again.rawlog"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("entries of an earlier run (its head, tracks and scenes)"));
    EXPECT_TRUE(contentOf("again.rawlog") == contentOf("once.rawlog"));
    // Where no rawlog is written, nothing is left out of it.
    const Outcome table =
        track("-q --frames 0:3" + in("once.rawlog") + " --tracks " + path("t.csv"));
    EXPECT_EQ(table.output, "");
}

}  // namespace
}  // namespace vdamf
