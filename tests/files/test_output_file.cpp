// SPDX-License-Identifier: BSD-3-Clause
// An output file appears whole or not at all, and every failure is reported.
#include <gmock/gmock.h>

#include <cstdio>

#include "temporary_folder.h"
#include "vdamf/files/folder.h"
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

TEST_F(OutputFileTest, OutputsAreNeitherInputsNorEachOther)
{
    const auto problem = [&](const std::vector<std::filesystem::path>& outputs) -> std::string
    {
        try
        {
            checkOutputPaths(outputs, {{at("c.ini"), "the configuration"}, {"", "nothing"}});
        }
        catch (const std::runtime_error& error)
        {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(problem({at("a"), at("b")}), "");
    EXPECT_THAT(problem({at("a"), at("c.ini")}), HasSubstr("c.ini: is the configuration"));
    EXPECT_THAT(problem({at("a"), at("./a")}), HasSubstr("named for two outputs"));
    EXPECT_THAT(problem({"not_there", "./not_there"}), HasSubstr("named for two outputs"));
    EXPECT_THAT(problem({at("a"), at("a.partial")}), HasSubstr("named for two outputs"));
    EXPECT_THAT(problem({"/dev/stdout", "/dev/stdout"}), HasSubstr("named for two outputs"));
    EXPECT_EQ(problem({"/dev/null", "/dev/null"}), "");
    std::filesystem::create_symlink(at("c.ini"), at("link"));
    EXPECT_THAT(problem({at("link")}), HasSubstr("is the configuration"));
}

TEST_F(OutputFileTest, KeepLeavesThePartial)
{
    OutputFile(at("out"), Existing::Refuse, Unfinished::Keep).write("so far");
    EXPECT_EQ(filesInFolder(), 1U);
    EXPECT_EQ(contentOf("out.partial"), "so far");
}

TEST_F(OutputFileTest, NothingWrittenLeavesNothing)
{
    OutputFile(at("out"), Existing::Refuse, Unfinished::Keep);
    EXPECT_EQ(filesInFolder(), 0U);
}

TEST_F(OutputFileTest, RefusesWhatAnInterruptedRunSaved)
{
    make("out.partial", "a longer text of an earlier run");
    const std::string error =
        errorOf([&] { OutputFile(at("out"), Existing::Refuse, Unfinished::Discard); });
    EXPECT_THAT(error, HasSubstr("out.partial: holds what an interrupted run saved"));
    EXPECT_THAT(error, HasSubstr("--overwrite"));
    EXPECT_EQ(contentOf("out.partial"), "a longer text of an earlier run");
    OutputFile file(at("out"), Existing::Overwrite, Unfinished::Discard);
    file.write("new");
    file.commit();
    EXPECT_EQ(contentOf("out"), "new");
    EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(OutputFileTest, TakesAnEmptyPartial)
{
    make("out.partial", "");
    OutputFile file(at("out"), Existing::Refuse, Unfinished::Discard);
    file.write("new");
    file.commit();
    EXPECT_EQ(contentOf("out"), "new");
}

TEST_F(OutputFileTest, WritesThroughSymbolicLinks)
{
    make("real/out", "old");
    std::filesystem::create_symlink("real/out", at("near"));
    std::filesystem::create_symlink(at("near"), at("link"));
    EXPECT_THAT(errorOf([&] { OutputFile(at("link"), Existing::Refuse, Unfinished::Discard); }),
                HasSubstr("exists already"));
    OutputFile file(at("link"), Existing::Overwrite, Unfinished::Discard);
    EXPECT_EQ(file.partialPath().filename(), "out.partial");
    EXPECT_EQ(file.partialPath(), partialPathOf(at("link")));
    file.write("new");
    EXPECT_EQ(contentOf("real/out"), "old");
    file.commit();
    EXPECT_EQ(contentOf("real/out"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(at("link")));
    EXPECT_TRUE(std::filesystem::is_symlink(at("near")));
    EXPECT_EQ(filesInFolder(), 3U);
}

TEST_F(OutputFileTest, WritesThroughALinkToNothing)
{
    std::filesystem::create_symlink("new", at("link"));
    std::filesystem::create_symlink("gone/new", at("astray"));
    std::filesystem::create_symlink("loop", at("loop"));
    OutputFile file(at("link"), Existing::Refuse, Unfinished::Discard);
    file.write("text");
    file.commit();
    EXPECT_EQ(contentOf("new"), "text");
    EXPECT_TRUE(std::filesystem::is_symlink(at("link")));
    const auto errorFor = [&](const char* name)
    { return errorOf([&] { OutputFile(at(name), Existing::Refuse, Unfinished::Discard); }); };
    EXPECT_THAT(errorFor("astray"), HasSubstr("there is no folder"));
    EXPECT_THAT(errorFor("loop"), HasSubstr("too many symbolic links"));
}

TEST_F(OutputFileTest, KnowsTheNamesOfOneFile)
{
    make("out", "");
    std::filesystem::create_symlink("out", at("link"));
    std::filesystem::create_symlink("new", at("ahead"));
    EXPECT_TRUE(sameFile(at("out"), at("link")));
    EXPECT_TRUE(sameFile(at("new"), at("ahead")));
    EXPECT_TRUE(sameFile(at("new"), at(".") / "new"));
    EXPECT_FALSE(sameFile(at("out"), at("new")));
}

TEST_F(OutputFileTest, WritesToDescriptorsDirectly)
{
    const std::filesystem::path path = make("redirected", "");
    std::FILE* opened = std::fopen(path.c_str(), "w");
    ASSERT_NE(opened, nullptr);
    const std::string name = "/dev/fd/" + std::to_string(::fileno(opened));
    {
        OutputFile file(name, Existing::Refuse, Unfinished::Discard);
        file.write("one,");
        file.commit();
    }
    std::fputs("two", opened);
    std::fclose(opened);
    EXPECT_EQ(contentOf("redirected"), "one,two");
    EXPECT_TRUE(isStandardOutput("/dev/stdout"));
    EXPECT_TRUE(isStandardOutput("/dev/fd/1"));
    EXPECT_FALSE(isStandardOutput(name));
    EXPECT_FALSE(isStandardOutput(path));
    EXPECT_THAT(errorOf([] { OutputFile("/dev/fd/987", Existing::Refuse, Unfinished::Keep); }),
                HasSubstr("/dev/fd/987: cannot open"));
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

TEST_F(OutputFileTest, WhatAnInterruptedRunSavedStaysUntilThereIsMore)
{
    for (const Unfinished unfinished : {Unfinished::Discard, Unfinished::Keep})
    {
        make("out.partial", "hours of work");
        {
            OutputFile file(at("out"), Existing::Overwrite, unfinished);
            file.write("");
        }
        EXPECT_EQ(contentOf("out.partial"), "hours of work");
    }
    OutputFile file(at("out"), Existing::Overwrite, Unfinished::Keep);
    file.write("new");
    EXPECT_EQ(contentOf("out.partial"), "new");
    file.commit();
    EXPECT_EQ(contentOf("out"), "new");
    make("none.partial", "hours of work");
    OutputFile(at("none"), Existing::Overwrite, Unfinished::Keep).commit();
    EXPECT_EQ(contentOf("none"), "") << "an output that is empty";
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

TEST_F(OutputFileTest, AFolderThatCannotBeMadeIsNamed)
{
    make("file", "");
    EXPECT_EQ(errorOf([&] { makeFolder(at("file/in/it")); }),
              at("file/in/it").string() + ": cannot make this folder: Not a directory");
    makeFolder(at("new/in/it"));
    makeFolder(at("new/in/it"));
    EXPECT_TRUE(std::filesystem::is_directory(at("new/in/it")));
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
