// SPDX-License-Identifier: BSD-3-Clause
// vdamf-sweep through its command line: what it leaves, and what it does when it is stopped.
#include <gmock/gmock.h>

#include "apps/sweep_fixture.h"

namespace vdamf
{
namespace
{
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

TEST_F(SweepProgram, LeavesWholeRunsTablesAPageAndTheBestConfiguration)
{
    writeSweep("", "measurement.sigma_m = 0.1 : 0.1 : 0.3");
    const Outcome first = sweep("out");
    ASSERT_EQ(first.exitCode, 0) << first.output;
    EXPECT_THAT(first.output, HasSubstr("3 of 3"));
    EXPECT_EQ(runsIn("out"), 3U);
    for (const fs::directory_entry& run : fs::directory_iterator(at("out/runs")))
        for (const char* name : {"config.ini", "tracks.csv", "metrics.json", "log.txt"})
            EXPECT_GT(fs::file_size(run.path() / name), 0U) << name;
    EXPECT_TRUE(fs::is_empty(at("out/tasks")));
    EXPECT_THAT(contentOf("out/table.csv"),
                AllOf(HasSubstr("setting,recording,measurement.sigma_m,status,run,hota.hota,"),
                      HasSubstr("\n3,street,0.3,done,")));
    EXPECT_THAT(contentOf("out/report.html"), HasSubstr("</html>"));
    EXPECT_THAT(contentOf("out/best.ini"),
                HasSubstr("# Best mean of hota.hota over 1 recording\n"));
    // What is best can be tracked with.
    const Outcome config =
        runApp("vdamf-track", "--print-config -c '" + at("out/best.ini").string() + "'");
    EXPECT_EQ(config.exitCode, 0) << config.output;
}

TEST_F(SweepProgram, RunsThatAreDoneAreSkipped)
{
    writeSweep("", "measurement.sigma_m = 0.1 : 0.1 : 0.3");
    ASSERT_EQ(sweep("out").exitCode, 0);
    const std::string table = contentOf("out/table.csv");
    EXPECT_THAT(sweep("out", "--dry-run").output, HasSubstr("3 runs, 3 of them done"));
    const Outcome again = sweep("out");
    EXPECT_THAT(again.output, HasSubstr("3 were done before"));
    EXPECT_EQ(contentOf("out/table.csv"), table);
    writeSweep("", "measurement.sigma_m = 0.1 : 0.1 : 0.4");
    EXPECT_THAT(sweep("out").output, HasSubstr("4 runs (3 were done before)"));
    EXPECT_THAT(sweep("out", "--no-resume").output, Not(HasSubstr("done before")));
}

TEST_F(SweepProgram, AnotherModelOfTheSameNameIsAnotherRun)
{
    const std::string model = VDAMF_SOURCE_DIR "/models/vehicle.txt";
    fs::create_directory(at("models"));
    fs::copy(model, at("models/a.txt"));
    fs::copy(model, at("models/b.txt"));
    make("models/conf.ini", "[discriminator]\nmodel = a.txt\n");
    writeSweep("config = models/conf.ini\n", "discriminator.model = a.txt, models/b.txt");
    const Outcome first = sweep("out");
    ASSERT_EQ(first.exitCode, 0) << first.output;
    EXPECT_EQ(runsIn("out"), 2U);
    EXPECT_THAT(sweep("out").output, HasSubstr("2 were done before"));
    std::string other = contentOf("models/b.txt");
    other.replace(other.find("record vdamf-train"), 6, "record another");
    make("models/b.txt", other);
    EXPECT_THAT(sweep("out").output, HasSubstr("1 were done before"));
    // From any folder: the paths in it are absolute.
    const Outcome config = runApp(
        "vdamf-track", "--print-config -c '" + at("out/best.ini").string() + "' | grep ^model");
    EXPECT_THAT(config.output, HasSubstr(at("models").string())) << config.output;
}

TEST_F(SweepProgram, NoModelIsNoFile)
{
    make("conf.ini", "[discriminator]\nmodel = none\n");
    writeSweep("config = conf.ini\n", "measurement.sigma_m = 0.2");
    const Outcome off = sweep("off");
    EXPECT_EQ(off.exitCode, 0) << off.output;
    writeSweep("", "discriminator.model = none");
    const Outcome varied = sweep("varied");
    EXPECT_EQ(varied.exitCode, 0) << varied.output;
}

TEST_F(SweepProgram, KilledAndStartedAgainGivesTheSameTable)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.04 : 0.38");
    ASSERT_EQ(sweep("whole", "-q").exitCode, 0);
    const pid_t process = start("killed", "-j 1");
    ASSERT_TRUE(waitFor([&] { return runsIn("killed") >= 2; }));
    ::kill(process, SIGKILL);
    EXPECT_EQ(waitForExit(process), 137);
    const std::size_t done = runsIn("killed");
    ASSERT_LT(done, 8U);
    for (const fs::directory_entry& run : fs::directory_iterator(at("killed/runs")))
        EXPECT_TRUE(fs::exists(run.path() / "metrics.json") && fs::exists(run.path() / "log.txt"));
    const Outcome again = sweep("killed");
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("done before"));
    EXPECT_EQ(contentOf("killed/table.csv"), contentOf("whole/table.csv"));
    EXPECT_EQ(runsIn("killed"), 8U);
    EXPECT_TRUE(fs::is_empty(at("killed/tasks")));
    const fs::path one = fs::directory_iterator(at("killed/runs"))->path();
    fs::remove(one / "metrics.json");
    EXPECT_THAT(sweep("killed").output, HasSubstr("remove the folder " + one.string()));
    for (const char* bytes : {"", "{\"hota\": {", "{}", "[1]"})
    {
        make(fs::relative(one / "metrics.json", at("")).string(), bytes);
        const Outcome damaged = sweep("killed");
        EXPECT_EQ(damaged.exitCode, 1);
        EXPECT_THAT(damaged.output, AllOf(HasSubstr("metrics.json: is damaged; remove the folder " +
                                                    one.string() + " to do this run again"),
                                          Not(HasSubstr("json.exception"))));
    }
}

TEST_F(SweepProgram, InterruptedItSaysHowToGoOn)
{
    writeSweep("", "measurement.sigma_m = 0.10 : 0.01 : 0.40");
    const pid_t process = start("out", "-j 1");
    ASSERT_TRUE(waitFor([&] { return runsIn("out") >= 1; }));
    EXPECT_THAT(sweep("out").output, HasSubstr("another vdamf-sweep works in this folder"));
    ::kill(process, SIGINT);
    EXPECT_EQ(waitForExit(process), 1);
    EXPECT_THAT(contentOf("out.txt"), HasSubstr("interrupted: the runs that are done stay"));
    EXPECT_FALSE(fs::exists(at("out/table.csv")));
}

TEST_F(SweepProgram, AFailedRunIsToldWithItsLog)
{
    make("bad/broken.rawlog", "this is no rawlog");
    make("bad/truth.csv", "neither a truth");
    writeSweep("", "measurement.sigma_m = 0.1, 0.2",
               "[recordings bad]\nrawlogs = bad/*.rawlog\ntruth = {folder}/truth.csv\n");
    const Outcome outcome = sweep("out");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("broken, setting 1 failed: "),
                                      HasSubstr("2 runs failed; their logs are in")));
    EXPECT_EQ(runsIn("out"), 2U);
    EXPECT_THAT(contentOf("out/table.csv"),
                AllOf(HasSubstr("1,street,0.1,done"), HasSubstr("1,broken,0.1,failed")));
    EXPECT_THAT(contentOf("out/report.html"), HasSubstr("broken.rawlog"));
    EXPECT_THAT(outcome.output, HasSubstr("broken has no hota.hota with any setting"));
    EXPECT_THAT(contentOf("out/best.ini"),
                HasSubstr("# Best mean of hota.hota over 1 of 2 recordings; the others have none"));
    std::size_t logs = 0;
    for (const fs::directory_entry& task : fs::directory_iterator(at("out/tasks")))
        logs += fs::exists(task.path() / "log.txt") ? 1 : 0;
    EXPECT_EQ(logs, 2U);
}

TEST_F(SweepProgram, ARangeBehindTheEndIsToldByItsKey)
{
    const std::string street = VDAMF_SOURCE_DIR "/datasets/street/";
    fs::create_symlink(street + "street.rawlog", at("late.rawlog"));
    writeSweep("", "measurement.sigma_m = 0.1",
               "[recordings late]\nrawlogs = late.rawlog\ntruth = " + street +
                   "truth.csv\nfirst_frame = 500\n");
    const Outcome outcome = sweep("out");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("setting 1 failed: first_frame = 500: "),
                      HasSubstr("late.rawlog: no frame in the range asked for: it begins at "
                                "frame 500, the rawlog has the frames 0 to 119")));
}

TEST_F(SweepProgram, FramesOutOfTheRangeAreNotScored)
{
    writeSweep("goal = max scored.frames", "measurement.sigma_m = 0.1");
    ASSERT_EQ(sweep("middle").exitCode, 0);
    // Rows end with position's median and the frames that were scored.
    EXPECT_THAT(contentOf("middle/table.csv"), ContainsRegex(",8\n$"));
    const std::string street = VDAMF_SOURCE_DIR "/datasets/street/";
    const std::string recording =
        "rawlogs = " + street + "street.rawlog\ntruth = " + street + "truth.csv\n";
    make("sweep.ini",
         "[sweep]\nmetrics = clear_mot.recall, scored.frames\ngoal = max "
         "clear_mot.recall\n[vary]\nmeasurement.sigma_m = 0.1\n[recordings]\n" +
             recording + "first_frame = 112\n");
    ASSERT_EQ(sweep("end").exitCode, 0);
    EXPECT_THAT(contentOf("end/table.csv"), ContainsRegex(",0\\.[4-9][0-9]*,8\n$"));
}

TEST_F(SweepProgram, RecordingsWithTheSameContentAreOneRun)
{
    const std::string street = VDAMF_SOURCE_DIR "/datasets/street/";
    fs::create_symlink(street + "street.rawlog", at("copy.rawlog"));
    writeSweep("", "measurement.sigma_m = 0.1, 0.2",
               "[recordings copy]\nrawlogs = copy.rawlog\ntruth = " + street +
                   "truth.csv\nfirst_frame = 20\nlast_frame = 28\n");
    ASSERT_EQ(sweep("out").exitCode, 0);
    EXPECT_EQ(runsIn("out"), 2U);
    EXPECT_THAT(contentOf("out/table.csv"), HasSubstr("\n2,copy,0.2,done,"));
}

TEST_F(SweepProgram, SearchesAndDraws)
{
    writeSweep("plan = optimise\ncount = 5\ngoal = min errors.position_m.median",
               "measurement.sigma_m = 0.1 : 0.4");
    const Outcome search = sweep("search");
    EXPECT_EQ(search.exitCode, 0) << search.output;
    EXPECT_LE(runsIn("search"), 5U);
    EXPECT_GE(runsIn("search"), 3U);
    EXPECT_THAT(contentOf("search/table.csv"), HasSubstr("\n1,street,0.25,done"));
    const std::string table = contentOf("search/table.csv");
    EXPECT_EQ(sweep("search").exitCode, 0);
    EXPECT_EQ(contentOf("search/table.csv"), table);
    writeSweep("plan = random\ncount = 3\nseed = 5", "measurement.sigma_m = log 0.05 : 0.5");
    EXPECT_EQ(sweep("drawn").exitCode, 0);
    EXPECT_EQ(runsIn("drawn"), 3U);
}

TEST_F(SweepProgram, SearchGoesRoundValuesThatAreNotAllowedTogether)
{
    // No gap may be above max_gap_m, which is 0.8.
    writeSweep("plan = optimise\ncount = 4", "clustering.gap_m = 0.3 : 1.5");
    const Outcome search = sweep("search");
    EXPECT_EQ(search.exitCode, 0) << search.output;
    EXPECT_THAT(search.output,
                HasSubstr("setting clustering.gap_m = 0.9:\nbuilt-in configuration: "
                          "clustering.gap_m = 0.9 must not be above clustering.max_gap_m = 0.8; it "
                          "counts as worse than the worst\n"));
    EXPECT_GE(runsIn("search"), 1U);
    EXPECT_TRUE(fs::exists(at("search/best.ini")));
    writeSweep("plan = optimise\ncount = 3", "clustering.gap_m = 0.81 : 1.5");
    const Outcome none = sweep("none");
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.output, HasSubstr("no setting whose values are allowed together"));
}

TEST_F(SweepProgram, BadUse)
{
    writeSweep("", "measurement.sigma = 0.1, 0.2");
    const Outcome unknown = sweep("out");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.output, HasSubstr("did you mean 'sigma_m'?"));
    EXPECT_FALSE(fs::exists(at("out")));
    EXPECT_EQ(runApp("vdamf-sweep", "").exitCode, 2);
    EXPECT_EQ(runApp("vdamf-sweep", "-c x.ini --engine cloud").exitCode, 2);
    EXPECT_EQ(runApp("vdamf-sweep", "--help").exitCode, 0);
    writeSweep("", "measurement.sigma_m = 0.1, 0.2");
    const Outcome own = sweep(".");
    EXPECT_EQ(own.exitCode, 2);
    EXPECT_THAT(own.output, HasSubstr("sweep.ini"));
    EXPECT_THAT(runApp("vdamf-sweep", "--print-metrics").output, HasSubstr("\nhota.hota\n"));
    const std::string program = "'" VDAMF_APPS_DIR "/vdamf-sweep' ";
    for (const std::string& what :
         {std::string("--print-metrics"), arguments("out") + " --dry-run"})
    {
        const Outcome full = runShell(program + what + " > /dev/full");
        EXPECT_EQ(full.exitCode, 1) << what;
        EXPECT_THAT(full.output, HasSubstr("cannot write to the standard output")) << what;
    }
}

TEST_F(SweepProgram, TheExamplePasses)
{
    const Outcome plan =
        runApp("vdamf-sweep", "-c '" VDAMF_SOURCE_DIR "/datasets/sweeps/street.ini' --dry-run");
    EXPECT_EQ(plan.exitCode, 0) << plan.output;
    EXPECT_THAT(plan.output, HasSubstr("12 runs, "));
}

}  // namespace
}  // namespace vdamf
