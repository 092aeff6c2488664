// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track on bad command lines, broken input and interrupted runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <set>
#include <thread>

#include <mrpt/obs/CObservation.h>

#include "apps/track_fixture.h"
#include "vdamf/evaluation/tables.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/rawlog_writer.h"
#include "vdamf/rawlog/scan.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class TrackErrors : public TrackProgram
{
};

TEST_F(TrackErrors, RefusesBadConfigurationBeforeAnyOutput)
{
    make("typo.ini", "[clustering]\ngap_n = 0.4\n");
    Outcome run = track("-i " + kStreet + out("a.rawlog") + " -c " + path("typo.ini"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, AllOf(HasSubstr("typo.ini:2"), HasSubstr("gap_n"), HasSubstr("gap_m")));
    run = track("-i " + kStreet + out("a.rawlog") + " --set clustering.gap_m=0.4x");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, AllOf(HasSubstr("clustering.gap_m"), HasSubstr("0.4x")));
    run = track("-i " + kStreet + out("a.rawlog") + " --set measurement.sigma_m=50");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("sigma_m"));
    run = track("-i " + kStreet + out("a.rawlog") + " -c " + path("missing.ini"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("missing.ini"));
    run = track("-i " + kStreet + out("a.rawlog") + " --tracks " + path("t.csv") +
                " --set 'scan.label=front #1'");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("scan.label = 'front #1': expected a text without"));
    for (const char* bad : {"--frames 5", "--frames 9:3", "--frames a:b", "--nonsense", "-o"})
        EXPECT_EQ(track("-i " + kStreet + out("a.rawlog") + " " + bad).exitCode, 2) << bad;
    EXPECT_EQ(track(out("a.rawlog")).exitCode, 2);
    EXPECT_EQ(track("-i " + kStreet).exitCode, 2);
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(TrackErrors, NamesWhatIsWrongWithTheInput)
{
    make("text.rawlog", "This is not a rawlog.\n");
    make("empty.rawlog", "");
    fs::create_directory(at("folder"));
    for (const char* bad : {"text.rawlog", "empty.rawlog", "missing.rawlog", "folder"})
    {
        const Outcome run = track(in(bad) + out("a.rawlog"));
        EXPECT_EQ(run.exitCode, 1) << bad;
        EXPECT_THAT(run.output, HasSubstr(bad));
        EXPECT_FALSE(fs::exists(at("a.rawlog")));
        EXPECT_FALSE(fs::exists(at("a.rawlog.partial"))) << bad;
    }
}

TEST_F(TrackErrors, NamesWhatIsMissingInTheRawlog)
{
    RawlogReader reader(kStreet);
    {
        RawlogWriter poses(at("poses.rawlog"), {});
        RawlogWriter scans(at("scans.rawlog"), {});
        for (int k = 0; k < 60; ++k)
        {
            const auto entry = reader.next();
            const auto o = std::dynamic_pointer_cast<mrpt::obs::CObservation>(entry->object);
            (isScan(*o) ? scans : poses).writeBytes(entry->bytes);
        }
        poses.commit();
        scans.commit();
    }
    Outcome run = track(in("poses.rawlog") + out("a.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("poses.rawlog"), HasSubstr("no scans")));
    run = track(in("scans.rawlog") + out("a.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("scans.rawlog"), HasSubstr("INS pose")));
    run = track("-i " + kStreet + out("a.rawlog") + " --set scan.label=front");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("'front'"));
    EXPECT_EQ(filesInFolder(), 2U) << "no output of a failed run stays";
}

TEST_F(TrackErrors, NamesThePosesThatAreNotThere)
{
    const Outcome run = track("-i " + kStreet + out("a.rawlog") +
                              " --frames 0:5 --set ins.source=gps --set ins.label=mine");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("poses: none with source = gps labelled 'mine'"));
}

TEST_F(TrackErrors, KeepsWhatWasDoneBeforeATruncation)
{
    std::ifstream file(kStreet, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(file), {}};
    make("cut.rawlog", whole.substr(0, whole.size() / 4));
    const Outcome run = track(in("cut.rawlog") + out("a.rawlog") + " --tracks " + path("t.csv"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("cut.rawlog"), HasSubstr("truncated")));
    const Contents log(at("a.rawlog"));
    EXPECT_FALSE(log.truncated);
    std::set<double> times;
    for (const TrackRow& row : readTracks(at("t.csv"))) times.insert(row.time);
    EXPECT_GT(times.size(), 15U);
}

TEST_F(TrackErrors, NamesTheDamageThatLeftNoScan)
{
    const std::string whole = readTextFile(kStreet);
    make("cut.rawlog", whole.substr(0, 1000));
    const Outcome run = track(in("cut.rawlog") + " --tracks " + path("t.csv"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("no scans"), HasSubstr("truncated: the gz stream")));
}

TEST_F(TrackErrors, GuardsItsOutputs)
{
    make("there.rawlog", "precious");
    Outcome run = track("-i " + kStreet + out("there.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("there.rawlog"), HasSubstr("--overwrite")));
    EXPECT_EQ(contentOf("there.rawlog"), "precious");
    run = track("-i " + kStreet + " --overwrite -o " + kStreet);
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("is the input"));
    run = track("-i " + kStreet + out("x.out") + " --frames 0:3 --picture " + path("x.out"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("two outputs"));
    make("input.rawlog", contentOf("there.rawlog"));
    run = track(in("input.rawlog") + " --overwrite --picture " + path("input.rawlog"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(contentOf("input.rawlog"), "precious");
    make("old.rawlog.partial", "precious");
    run = track(in("old.rawlog.partial") + out("old.rawlog"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("is the input"));
    EXPECT_EQ(contentOf("old.rawlog.partial"), "precious");
    fs::copy(VDAMF_SOURCE_DIR "/models/vehicle.txt", at("model.txt"));
    run = track("-i " + kStreet + out("model.txt") +
                " --overwrite --set discriminator.model=" + path("model.txt"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.output, HasSubstr("model.txt: is discriminator.model"));
    run = track("-i " + kStreet + out("no/such/folder.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("no/such/folder.rawlog"));
    run = track("-i " + kStreet + " -o /dev/full");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("/dev/full"), Not(HasSubstr("frames done"))));
}

TEST_F(TrackErrors, InterruptedRunLeavesAReadablePart)
{
    const pid_t child = ::fork();
    if (child == 0)
    {
        const std::string app = std::string(VDAMF_APPS_DIR) + "/vdamf-track";
        const std::string output = path("a.rawlog");
        ::freopen("/dev/null", "w", stdout);
        ::freopen(path("said.txt").c_str(), "w", stderr);
        const std::string table = path("t.csv");
        ::execl(app.c_str(), app.c_str(), "-i", kStreet.c_str(), "-o", output.c_str(), "--tracks",
                table.c_str(), nullptr);
        ::_exit(127);
    }
    for (int k = 0; k < 500 && !fs::exists(at("a.rawlog.partial")); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_FALSE(fs::exists(at("a.rawlog")));
    ASSERT_TRUE(fs::exists(at("a.rawlog.partial")));
    const Contents log(at("a.rawlog.partial"));
    EXPECT_FALSE(log.truncated);
    EXPECT_GT(log.entries.size(), 2U);
    EXPECT_THAT(contentOf("said.txt"), HasSubstr(" frames done are in " + path("a.rawlog.partial") +
                                                 " and " + path("t.csv.partial")));
}

TEST_F(TrackErrors, AnEmptyValueIsBadUseInEveryProgram)
{
    const auto expect =
        [](const std::string& app, const std::string& arguments, const std::string& option)
    {
        const Outcome run = runApp(app, arguments);
        EXPECT_EQ(run.exitCode, 2) << app << ": " << run.output;
        EXPECT_THAT(run.output, HasSubstr(app + ": " + option + ": its value is empty"));
    };
    const std::string input = "-i " + kStreet + " --frames 0:3 ";
    expect("vdamf-track", input + "-c '' --tracks " + path("t.csv"), "--config");
    expect("vdamf-track", input + "-o '' --tracks " + path("t.csv"), "--output");
    expect("vdamf-track", input + "--tracks= -q", "--tracks");
    expect("vdamf-track", input + "--set '' --tracks " + path("t.csv"), "--set");
    expect("vdamf-report", "'' -o " + path("r.html"), "input");
    expect("vdamf-evaluate", "--tracks a.csv --truth b.csv --json ''", "--json");
    expect("vdamf-train", "classifier list.ini -o x -c ''", "--config");
    EXPECT_EQ(filesInFolder(), 0U);
}

}  // namespace
}  // namespace vdamf
