// SPDX-License-Identifier: BSD-3-Clause
// vdamf-track and vdamf-import on a disk that fails in the middle (tests/failing_disk): what was
// read or written before is kept, and the message tells the failure from the end of a file.
#include "apps/faults_fixture.h"

namespace vdamf
{
namespace
{
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class FailingDisk : public Faults
{
protected:
    void SetUp() override
    {
#ifdef __SANITIZE_ADDRESS__
        GTEST_SKIP() << "the sanitizer's library has to be the first one that is loaded";
#endif
    }

    /// `plan`: see failing_disk.cpp.
    Outcome run(const std::string& plan, const std::string& app, const std::string& arguments) const
    {
        return runShell("VDAMF_FAILING='" + plan + "' LD_PRELOAD='" VDAMF_FAILING_DISK "' '" +
                        VDAMF_APPS_DIR "/" + app + "' " + arguments);
    }

    std::string outputs() const
    {
        return out("a.rawlog") + " --tracks " + path("t.csv");
    }

    /// Frames in the rawlog and in the table, which are equal.
    std::size_t framesKept(const std::string& ending = "") const
    {
        const Contents log(at("a.rawlog" + ending));
        EXPECT_EQ(brokenEntries(log), 0U);
        EXPECT_EQ(framesIn("t.csv" + ending), annotatedScans(log));
        return annotatedScans(log);
    }
};

TEST_F(FailingDisk, AReadErrorKeepsAllFramesBefore)
{
    make("in.rawlog", plainStreet(2 << 20));
    const std::string third = std::to_string((2 << 20) / 3);
    const Outcome failed =
        run("read:" + third + ":in.rawlog", "vdamf-track", in("in.rawlog") + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output,
                AllOf(HasSubstr("in.rawlog: read error: Input/output error at byte " + third),
                      HasSubstr("frames before are done"), Not(HasSubstr("truncated")),
                      Not(HasSubstr("file ends"))));
    const std::size_t kept = framesKept();
    fs::resize_file(at("in.rawlog"), (2 << 20) / 3);
    const Outcome cut = track(in("in.rawlog") + outputs() + " --overwrite");
    EXPECT_THAT(cut.output, HasSubstr("truncated"));
    EXPECT_EQ(kept, framesKept()) << "as many as of a file that ends there";
    EXPECT_GT(kept, 5U);
}

TEST_F(FailingDisk, AReadErrorInAGzFileIsNotItsEnd)
{
    const Outcome failed =
        run("read:400000:street.rawlog", "vdamf-track", "-i " + kStreet + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, AllOf(HasSubstr("street.rawlog: read error: Input/output error"),
                                     Not(HasSubstr("truncated")), Not(HasSubstr("ends early"))));
    EXPECT_GT(framesKept(), 5U);
}

TEST_F(FailingDisk, AFileThatCannotBeReadAtAllIsNamed)
{
    const Outcome failed = run("read:0:street.rawlog", "vdamf-track", "-i " + kStreet + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, HasSubstr("street.rawlog: cannot read: Input/output error"));
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(FailingDisk, AWriteErrorLeavesTheFramesBefore)
{
    const Outcome failed =
        run("write:300000:a.rawlog.partial", "vdamf-track", "-i " + kStreet + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, HasSubstr("a.rawlog.partial: cannot write: Input/output error"));
    EXPECT_FALSE(fs::exists(at("a.rawlog")));
    const Contents log(at("a.rawlog.partial"));
    EXPECT_EQ(brokenEntries(log), 0U);
    EXPECT_GT(annotatedScans(log), 2U);
    EXPECT_GE(framesIn("t.csv.partial"), annotatedScans(log));
}

TEST_F(FailingDisk, WhatDoesNotReachTheDiskIsNotCalledWhole)
{
    make("in.rawlog", plainStreet(1 << 20));
    const Outcome failed =
        run("fsync:0:a.rawlog.partial", "vdamf-track", in("in.rawlog") + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, HasSubstr("a.rawlog.partial: cannot write: Input/output error"));
    EXPECT_FALSE(fs::exists(at("a.rawlog")));
    EXPECT_GT(annotatedScans(Contents(at("a.rawlog.partial"))), 2U);
}

TEST_F(FailingDisk, AnErrorOnClosingIsAFailure)
{
    make("in.rawlog", plainStreet(1 << 20));
    const Outcome failed = run("close:0:a.rawlog", "vdamf-track", in("in.rawlog") + outputs());
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, HasSubstr("a.rawlog: cannot close: Input/output error"));
}

TEST_F(FailingDisk, TablesThatCannotBeReadAreNotShortOnes)
{
    const std::string truth = VDAMF_SOURCE_DIR "/datasets/street/truth.csv";
    make("tracks.csv", "time_s,track_id\n");
    const Outcome failed = run("read:20000:truth.csv", "vdamf-evaluate",
                               "--tracks " + path("tracks.csv") + " --truth " + truth);
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_THAT(failed.output, HasSubstr("truth.csv: cannot read: Input/output error"));
}

}  // namespace
}  // namespace vdamf
