// SPDX-License-Identifier: BSD-3-Clause
// An output file appears whole or not at all, and every failure is reported.
#include <gmock/gmock.h>

#include "temporary_folder.h"
#include "vdamf/files/output_file.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using Existing = OutputFile::Existing;
using Unfinished = OutputFile::Unfinished;

class OutputFileTest : public TemporaryFolder
{
};

TEST_F(OutputFileTest, AppearsOnCommitOnly)
{
    OutputFile file(at("out.csv"), Existing::Refuse, Unfinished::Discard);
    file.write("one,");
    file.write("two");
    EXPECT_FALSE(std::filesystem::exists(at("out.csv")));
    EXPECT_EQ(file.partialPath(), at("out.csv.partial"));
    file.commit();
    EXPECT_EQ(contentOf("out.csv"), "one,two");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(OutputFileTest, DiscardLeavesNothing)
{
    OutputFile(at("out"), Existing::Refuse, Unfinished::Discard).write("lost");
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(OutputFileTest, KeepLeavesThePartial)
{
    OutputFile(at("out"), Existing::Refuse, Unfinished::Keep).write("so far");
    EXPECT_EQ(filesInFolder(), 1U);
    EXPECT_EQ(contentOf("out.partial"), "so far");
}

TEST_F(OutputFileTest, ReplacesAnOldPartial)
{
    make("out.partial", "a longer text of an earlier run");
    OutputFile file(at("out"), Existing::Refuse, Unfinished::Discard);
    file.write("new");
    file.commit();
    EXPECT_EQ(contentOf("out"), "new");
}

TEST_F(OutputFileTest, RefusesAnExistingFile)
{
    make("out", "precious");
    const std::string error =
        errorOf([&] { OutputFile(at("out"), Existing::Refuse, Unfinished::Discard); });
    EXPECT_THAT(error, HasSubstr(at("out").string()));
    EXPECT_THAT(error, HasSubstr("--overwrite"));
    EXPECT_EQ(contentOf("out"), "precious");
}

TEST_F(OutputFileTest, RefusesAFileThatAppearedMeanwhile)
{
    {
        OutputFile file(at("out"), Existing::Refuse, Unfinished::Discard);
        make("out", "precious");
        EXPECT_THAT(errorOf([&] { file.commit(); }), HasSubstr("--overwrite"));
    }
    EXPECT_EQ(contentOf("out"), "precious");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(OutputFileTest, OverwritesOnRequestAtCommitOnly)
{
    make("out", "old");
    OutputFile file(at("out"), Existing::Overwrite, Unfinished::Discard);
    file.write("new");
    EXPECT_EQ(contentOf("out"), "old");
    file.commit();
    EXPECT_EQ(contentOf("out"), "new");
}

TEST_F(OutputFileTest, TwoRunsDoNotShareAPartial)
{
    OutputFile first(at("out"), Existing::Overwrite, Unfinished::Discard);
    first.write("first");
    EXPECT_THAT(errorOf([&] { OutputFile(at("out"), Existing::Overwrite, Unfinished::Discard); }),
                HasSubstr("another run"));
    first.commit();
    EXPECT_EQ(contentOf("out"), "first");
}

TEST_F(OutputFileTest, NamesWhatCannotBeWritten)
{
    const auto errorFor = [](const std::filesystem::path& path)
    { return errorOf([&] { OutputFile(path, Existing::Overwrite, Unfinished::Discard); }); };
    std::filesystem::create_directories(at("folder"));
    EXPECT_THAT(errorFor(at("folder")), HasSubstr("this is a folder"));
    EXPECT_THAT(errorFor(at("folder/")), HasSubstr("this is a folder"));
    EXPECT_THAT(errorFor(at("none/out")), HasSubstr("there is no folder " + at("none").string()));
    EXPECT_THAT(errorFor(""), HasSubstr("empty"));
    EXPECT_THAT(errorFor("/proc/vdamf_out"), HasSubstr("/proc/vdamf_out.partial: cannot open"));
    if (::geteuid() != 0)
    {
        std::filesystem::permissions(
            at("folder"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
        EXPECT_THAT(errorFor(at("folder/out")), HasSubstr("Permission denied; choose a folder"));
    }
}

TEST_F(OutputFileTest, ReportsAFullDisk)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    OutputFile file("/dev/full", Existing::Refuse, Unfinished::Discard);
    const std::string error = errorOf([&] { file.write("text"); });
    EXPECT_THAT(error, HasSubstr("/dev/full: cannot write: No space left on device; free some"));
}

TEST_F(OutputFileTest, WritesToDevicesDirectly)
{
    OutputFile file("/dev/null", Existing::Refuse, Unfinished::Discard);
    file.write("text");
    file.commit();
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace vdamf
