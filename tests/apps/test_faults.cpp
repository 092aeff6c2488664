// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track on full disks, lost folders, broken pipes and after signals: no frame that was
// finished is lost.
#include <sys/mount.h>

#include <csignal>

#include "apps/faults_fixture.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr rlim_t kSmallDisk = 300 << 10;

TEST_F(Faults, AFileThatMayNotGrowKeepsWhatIsInIt)
{
    ProcessOptions options;
    options.largestFile = kSmallDisk;
    options.errors = path("errors");
    const ProcessEnd end = runLimited("vdamf-track", job(kStreet), options);
    EXPECT_EQ(end.exitCode, 1) << "signal " << end.signal;
    EXPECT_THAT(contentOf("errors"), AllOf(HasSubstr("a.rawlog"), HasSubstr("too large"),
                                           HasSubstr(" frames done, those written before are in")));
    EXPECT_FALSE(fs::exists(at("a.rawlog")));
    const Contents log(at("a.rawlog.partial"));
    EXPECT_EQ(brokenEntries(log), 0U);
    EXPECT_GT(annotatedScans(log), 2U);
    EXPECT_GE(framesIn("t.csv.partial"), annotatedScans(log));
}

TEST_F(Faults, AFullDiskKeepsWhatIsOnIt)
{
    fs::create_directory(at("disk"));
    if (::mount("tmpfs", at("disk").c_str(), "tmpfs", 0, "size=300k") != 0)
        GTEST_SKIP() << "this user may not mount a small disk";
    const Outcome run = track("-i " + kStreet + out("disk/a.rawlog"));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, AllOf(HasSubstr("disk/a.rawlog"), HasSubstr("No space left"),
                                  HasSubstr("free some space")));
    std::size_t frames = 0;
    {
        const Contents log(at("disk/a.rawlog.partial"));
        EXPECT_EQ(brokenEntries(log), 0U);
        frames = annotatedScans(log);
    }
    ::umount(at("disk").c_str());
    EXPECT_GT(frames, 2U);
}

TEST_F(Faults, AFolderThatVanishesIsNamed)
{
    fs::create_directory(at("gone"));
    const std::string whole = street();
    makePipe("pipe");
    ProcessOptions options;
    options.errors = path("errors");
    LimitedProcess process("vdamf-track", {"-i", path("pipe"), "--tracks", path("gone/t.csv")},
                           options);
    Feed feed(at("pipe"));
    feed.write(std::string_view(whole).substr(0, whole.size() / 8));
    ASSERT_TRUE(grows("gone/t.csv.partial", 1000));
    fs::remove_all(at("gone"));
    feed.write(std::string_view(whole).substr(whole.size() / 8, whole.size() / 8));
    feed.close();
    EXPECT_EQ(process.wait().exitCode, 1);
    EXPECT_THAT(contentOf("errors"), AllOf(HasSubstr("gone/t.csv"), HasSubstr("No such file")));
}

TEST_F(Faults, AFolderThatTakesNoFilesIsNamed)
{
    const Outcome run = track("-i " + kStreet + " -o /proc/a.rawlog");
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("/proc/a.rawlog"));
}

TEST_F(Faults, APipeThatEndsEarlyIsATruncatedInput)
{
    const std::string whole = street();
    makePipe("pipe");
    ProcessOptions options;
    options.errors = path("errors");
    LimitedProcess process("vdamf-track", job(path("pipe")), options);
    Feed(at("pipe")).write(std::string_view(whole).substr(0, whole.size() / 5));
    EXPECT_EQ(process.wait().exitCode, 1);
    EXPECT_THAT(contentOf("errors"), HasSubstr("truncated"));
    const Contents log(at("a.rawlog"));
    EXPECT_FALSE(log.truncated);
    EXPECT_GT(annotatedScans(log), 15U);
}

TEST_F(Faults, SignalsEndARunThatWaitsForAPipe)
{
    const std::string whole = street();
    std::signal(SIGHUP, SIG_DFL);  // programs leave it ignored where it is
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    {
        makePipe("pipe");
        std::vector<std::string> arguments = job(path("pipe"));
        arguments.push_back("--overwrite");
        LimitedProcess process("vdamf-track", arguments);
        Feed feed(at("pipe"));
        feed.write(std::string_view(whole).substr(0, whole.size() / 5));
        ASSERT_TRUE(grows("t.csv.partial", 4000));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        process.send(signal);
        const ProcessEnd end = process.wait();
        EXPECT_EQ(end.exitCode, 1);
        EXPECT_FALSE(end.late);
        EXPECT_FALSE(fs::exists(at("a.rawlog")));
        const Contents log(at("a.rawlog.partial"));
        EXPECT_FALSE(log.truncated);
        EXPECT_EQ(brokenEntries(log), 0U);
        EXPECT_EQ(annotatedScans(log), framesIn("t.csv.partial"));
        EXPECT_GT(annotatedScans(log), 5U);
        fs::remove(at("pipe"));
    }
}

TEST_F(Faults, AReaderThatGoesAwayIsAFailure)
{
    makePipe("pipe");
    ProcessOptions options;
    options.output = path("pipe");
    options.errors = path("errors");
    LimitedProcess process(
        "vdamf-track", {"-i", kStreet, "-o", "/dev/stdout", "--tracks", path("t.csv")}, options);
    const int reader = ::open(at("pipe").c_str(), O_RDONLY);
    char some[1000];
    EXPECT_GT(::read(reader, some, sizeof some), 0);
    ::close(reader);
    const ProcessEnd end = process.wait();
    EXPECT_EQ(end.exitCode, 1) << "signal " << end.signal;
    EXPECT_THAT(contentOf("errors"), HasSubstr("Broken pipe"));
    EXPECT_GT(framesIn("t.csv.partial"), 2U);
}

TEST_F(Faults, StreamsAreFilesLikeOthers)
{
    make("in.rawlog", plainStreet(2 << 20));
    const std::string app = VDAMF_APPS_DIR "/vdamf-track -q -i ";
    ASSERT_EQ(runShell(app + path("in.rawlog") + out("file.rawlog")).exitCode, 0);
    const std::string input = "cat " + path("in.rawlog") + " | ";
    ASSERT_EQ(runShell(input + app + "/dev/stdin" + out("stdin.rawlog")).exitCode, 0);
    ASSERT_EQ(
        runShell(input + app + "/dev/stdin -o /dev/stdout | cat > " + path("both.rawlog")).exitCode,
        0);
    const std::string expected = contentOf("file.rawlog");
    EXPECT_TRUE(contentOf("stdin.rawlog") == expected);
    EXPECT_TRUE(contentOf("both.rawlog") == expected);
}

}  // namespace
}  // namespace vdamf
