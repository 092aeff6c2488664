// SPDX-License-Identifier: BSD-3-Clause
// vdamf-evaluate where something is wrong: exit codes, messages, and what stays untouched.
#include <gmock/gmock.h>

#include "apps/evaluate_fixture.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;
using EvaluateAppErrors = EvaluateAppTest;

TEST_F(EvaluateAppErrors, TheSameInputGivesTheSameBytes)
{
    writeTables(unchanged);
    metrics();
    const std::string first = contentOf("m.json");
    metrics();
    EXPECT_EQ(contentOf("m.json"), first);
    // On standard output the JSON stands alone.
    EXPECT_EQ(evaluate("--json /dev/stdout").output, first);
}

TEST_F(EvaluateAppErrors, KeepsInputsAndExistingFiles)
{
    writeTables(unchanged);
    const std::string truth = contentOf("truth.csv");
    const std::string path = at("truth.csv").string();
    EXPECT_EQ(evaluate("--overwrite --json '" + path + "'").exitCode, 2);
    EXPECT_EQ(evaluate("--overwrite --json '" + at("./x/../tracks.csv").string() + "'").exitCode,
              2);
    EXPECT_EQ(contentOf("truth.csv"), truth);
    const std::string twice = at("two.svg").string();
    EXPECT_EQ(evaluate("--json '" + twice + "' --plots '" + twice + "'").exitCode, 2);
    make("m.json", "mine");
    const Outcome refused =
        evaluate("--plots '" + at("a.svg").string() + "' --json '" + at("m.json").string() + "'");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("--overwrite"));
    EXPECT_EQ(contentOf("m.json"), "mine");
    EXPECT_EQ(filesInFolder(), 3U);  // the tables and m.json
    EXPECT_EQ(evaluate("--plots '" + at("m.json").string() + "'").exitCode, 2);
    const std::string both = at("n.json").string();
    EXPECT_EQ(evaluate("--json '" + both + "' --plots '" + both + "'").exitCode, 2);
    const Outcome picture = evaluate("--plots '" + at("charts.png").string() + "'");
    EXPECT_EQ(picture.exitCode, 2);
    EXPECT_THAT(picture.output, HasSubstr("charts.png: charts are .svg"));
    const Outcome loud = evaluate("--plots '" + at("charts.SVG").string() + "'");
    EXPECT_THAT(loud.output, HasSubstr("charts.SVG: charts are .svg"));
    EXPECT_EQ(filesInFolder(), 3U);
}

TEST_F(EvaluateAppErrors, AFolderOfChartsMayHaveADotInItsName)
{
    writeTables(unchanged);
    const Outcome run = evaluate("--plots '" + at("drive.0005").string() + "'");
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_FALSE(std::filesystem::is_empty(at("drive.0005")));
}

TEST_F(EvaluateAppErrors, AFailedJobSaysWhereAndWhy)
{
    writeTables(unchanged);
    EXPECT_EQ(evaluate(">/dev/full").exitCode, 1);
    EXPECT_EQ(evaluate("--json /dev/full").exitCode, 1);
    EXPECT_EQ(evaluate("--json /none/m.json").exitCode, 1);
    const std::string good = contentOf("truth.csv");
    const auto outcomeOf = [&](const char* file, const std::string& content)
    {
        make(file, content);
        const Outcome run = evaluate();
        EXPECT_EQ(run.exitCode, 1) << run.output;
        return run.output;
    };
    EXPECT_THAT(outcomeOf("truth.csv", ""), HasSubstr("truth.csv"));
    EXPECT_THAT(outcomeOf("truth.csv", "time_s,x_m\n"), HasSubstr("truth.csv:1: "));
    std::string bad = good;
    bad.replace(bad.find("4.0000"), 6, "4.o000");
    EXPECT_THAT(outcomeOf("truth.csv", bad), HasSubstr("truth.csv:2: column 'length_m'"));
    EXPECT_THAT(outcomeOf("truth.csv", truthHeader()), HasSubstr("vdamf-evaluate: "));
    EXPECT_THAT(outcomeOf("truth.csv", "\xff\xfe" + std::string(100, '\0')),
                HasSubstr("truth.csv"));
    make("truth.csv", good);
    EXPECT_THAT(outcomeOf("tracks.csv", tracksHeader() + "1,2,3\n"), HasSubstr("tracks.csv:2: "));
    std::filesystem::remove(at("tracks.csv"));
    EXPECT_THAT(evaluate().output, HasSubstr("tracks.csv"));
}

TEST_F(EvaluateAppErrors, ABadCommandLineIsTwo)
{
    for (const char* bad :
         {"--nonsense", "--overlap 0", "--overlap 1.5", "--min-points -1", "--region-fov-deg 361",
          "--classes Cyclists", "--max-range-m x", "extra"})
    {
        EXPECT_EQ(evaluate(bad).exitCode, 2) << bad;
    }
    EXPECT_EQ(runApp("vdamf-evaluate", "").exitCode, 2);
    EXPECT_EQ(runApp("vdamf-evaluate", "--truth t.csv").exitCode, 2);
    EXPECT_EQ(runApp("vdamf-evaluate", "--help").exitCode, 0);
    EXPECT_EQ(runApp("vdamf-evaluate", "--version").exitCode, 0);
}

/// Rows of some frames alone.
auto onlyFrames(int first, int last)
{
    return [=](TrackRow row, int frame) -> std::vector<TrackRow>
    {
        if (frame < first || frame > last) return {};
        return {std::move(row)};
    };
}

TEST_F(EvaluateAppErrors, SaysHowMuchTruthIsOutsideOfTheTracksTimes)
{
    writeTables(onlyFrames(3, 12));
    const Outcome all = evaluate();
    EXPECT_EQ(all.exitCode, 0) << all.output;
    EXPECT_THAT(all.output,
                HasSubstr("truth.csv (100.000000 to 101.900000 s): 10 of its 20 frames"));
    EXPECT_THAT(all.output, HasSubstr("tracks.csv (100.300000 to 101.200000 s)"));
    EXPECT_THAT(all.output, HasSubstr("--tracked-span"));
    EXPECT_EQ(metrics()["clear_mot"]["recall"], 0.5);
    EXPECT_EQ(metrics("--tracked-span")["clear_mot"]["recall"], 1.0);
    EXPECT_EQ(metrics("--tracked-span")["scored"]["frames"], 10);
    EXPECT_EQ(metrics("--tracked-span")["options"]["tracked_span"], true);
    EXPECT_EQ(metrics()["options"]["tracked_span"], false);
    EXPECT_THAT(evaluate("--tracked-span").output, Not(HasSubstr("vdamf-evaluate:")));
}

TEST_F(EvaluateAppErrors, FramesInsideWithoutTracksAreNoWarning)
{
    writeTables(
        [](TrackRow row, int frame) -> std::vector<TrackRow>
        {
            if (frame == 5 || frame == 6) return {};
            return {std::move(row)};
        });
    EXPECT_THAT(evaluate().output, Not(HasSubstr("vdamf-evaluate:")));
    EXPECT_EQ(metrics("--tracked-span")["clear_mot"]["recall"], 0.9);
}

TEST_F(EvaluateAppErrors, SaysWhereTimesOfTheTablesLieBesideEachOther)
{
    writeTables(
        [](TrackRow row, int frame)
        {
            row.time += frame >= 10 && frame < 15 ? 0.02 : 0.0;
            return std::vector<TrackRow>{std::move(row)};
        });
    EXPECT_THAT(evaluate().output, HasSubstr("5 of the 20 frames"));
    EXPECT_THAT(evaluate().output, HasSubstr("up to 0.0200 s beside frames of"));
}

TEST_F(EvaluateAppErrors, SaysHowFarOffTimesAreWhereNoneMeet)
{
    writeTables(
        [](TrackRow row, int /*frame*/)
        {
            row.time += 0.0011;
            return std::vector<TrackRow>{std::move(row)};
        });
    const Outcome run = evaluate();
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("20 of the 20 frames"));
    EXPECT_THAT(run.output, HasSubstr("up to 0.0011 s beside frames of"));
    EXPECT_THAT(run.output, HasSubstr("no frame of the truth"));
}

TEST_F(EvaluateAppErrors, ASpanNeedsTracksInTheTruthsTime)
{
    writeTables(onlyFrames(50, 60));
    const Outcome none = evaluate("--tracked-span");
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.output, HasSubstr("tracks.csv: has no rows"));
    writeTables(
        [](TrackRow row, int /*frame*/)
        {
            row.time += 1000.0;
            return std::vector<TrackRow>{std::move(row)};
        });
    const Outcome other = evaluate("--tracked-span");
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_THAT(other.output, HasSubstr("none of its frames (100.000000 to 101.900000 s)"));
}

TEST_F(EvaluateAppErrors, ErrorsOfScoringNameTheTables)
{
    writeTables(
        [](TrackRow row, int /*frame*/)
        {
            row.time += 1000.0;
            return std::vector<TrackRow>{std::move(row)};
        });
    const std::string names =
        "truth " + at("truth.csv").string() + ", tracks " + at("tracks.csv").string() + ": ";
    EXPECT_THAT(evaluate().output, HasSubstr(names + "no frame of the truth"));
    EXPECT_THAT(evaluate().output, Not(HasSubstr("--tracked-span"))) << "nothing beside the error";
    make("truth.csv", truthHeader());
    EXPECT_THAT(evaluate().output, HasSubstr(names + "the truth has no rows"));
}

}  // namespace
}  // namespace vdamf
