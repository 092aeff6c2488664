// SPDX-License-Identifier: BSD-3-Clause
// vdamf-import through its command line: exit codes, messages, files.
#include <gmock/gmock.h>

#include "apps/command_line.h"
#include "files/temporary_folder.h"
#include "rawlog/kitti_example_drive.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;

Outcome import(const std::string& arguments)
{
    return runApp("vdamf-import", arguments);
}

class ImportAppTest : public TemporaryFolder
{
protected:
    ImportAppTest() : drive_(at("day")) {}

    std::string arguments(const std::string& more = "") const
    {
        return "kitti-raw '" + drive_.folder().string() + "' -o '" + at("o.rawlog").string() +
               "' --truth '" + at("truth.csv").string() + "' " + more;
    }

    KittiExampleDrive drive_;
};

TEST_F(ImportAppTest, ImportsAndSummarises)
{
    const Outcome run = import(arguments());
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("frames      3 (0.2 s)"));
    EXPECT_THAT(run.output, HasSubstr("points      12 (4 a frame)"));
    EXPECT_THAT(run.output, HasSubstr("labels      5 of 2 objects"));
    EXPECT_EQ(readTruth(at("truth.csv")).size(), 5U);
    EXPECT_GT(std::filesystem::file_size(at("o.rawlog")), 500U);
}

TEST_F(ImportAppTest, QuietItSaysNothing)
{
    const Outcome run = import(arguments("--quiet"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(run.output, "");
    EXPECT_EQ(readTruth(at("truth.csv")).size(), 5U);
}

TEST_F(ImportAppTest, KeepsExistingFilesUnlessTold)
{
    ASSERT_EQ(import(arguments()).exitCode, 0);
    const std::string before = contentOf("o.rawlog");
    const Outcome refused = import(arguments());
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, HasSubstr("o.rawlog: exists already; use --overwrite"));
    EXPECT_EQ(import(arguments("--overwrite")).exitCode, 0);
    // The same input gives the same bytes.
    EXPECT_EQ(contentOf("o.rawlog"), before);
    EXPECT_EQ(import(arguments("--overwrite --gz-level 0")).exitCode, 0);
    EXPECT_GT(contentOf("o.rawlog").size(), before.size());
}

TEST_F(ImportAppTest, AFailedJobSaysWhy)
{
    std::filesystem::remove(drive_.oxtsFile(1));
    const Outcome run = import(arguments());
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.output, HasSubstr("vdamf-import: "));
    EXPECT_THAT(run.output, HasSubstr("0000000001.txt: is missing"));
    EXPECT_EQ(filesInFolder(), 1U);  // the drive
    EXPECT_EQ(import("kitti-raw /none -o '" + at("o").string() + "'").exitCode, 1);
    EXPECT_EQ(import("kitti-raw '" + drive_.folder().string() + "' -o /none/o").exitCode, 1);
}

TEST_F(ImportAppTest, WritesToTheStandardOutput)
{
    ASSERT_EQ(import(arguments()).exitCode, 0);
    const std::string app = VDAMF_APPS_DIR "/vdamf-import kitti-raw '" + drive_.folder().string();
    const Outcome run = runShell(app + "' -o " + at("p.rawlog").string() +
                                 " --truth /dev/stdout > " + at("printed.csv").string());
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.output, HasSubstr("labels      5 of 2 objects"));
    EXPECT_EQ(contentOf("printed.csv"), contentOf("truth.csv"));
    const Outcome full = runShell(app + "' -o " + at("q.rawlog").string() + " > /dev/full");
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_THAT(full.output, HasSubstr("vdamf-import: cannot write to the standard output"));
}

TEST_F(ImportAppTest, ABadCommandLineIsTwo)
{
    for (const char* bad : {"", "kitti", "kitti-raw", "kitti-raw drive", "kitti-raw -o o",
                            "kitti-raw drive -o o --gz-level 10", "kitti-raw drive -o o --nonsense",
                            "kitti-raw drive -o o --gz-level x", "--nonsense"})
    {
        EXPECT_EQ(import(bad).exitCode, 2) << bad;
    }
    EXPECT_THAT(import("kitti-raw drive").output, HasSubstr("vdamf-import: --output is required"));
    EXPECT_THAT(import("--nonsense").output, ::testing::StartsWith("vdamf-import: "));
    const std::string drive = "kitti-raw '" + drive_.folder().string() + "' -o ";
    EXPECT_THAT(import(drive + "-").output, HasSubstr("/dev/stdout"));
    EXPECT_EQ(import(drive + "-").exitCode, 2);
    std::filesystem::create_symlink("one", at("other"));
    const Outcome twice = import(drive + at("one").string() + " --truth " + at("other").string());
    EXPECT_EQ(twice.exitCode, 2);
    EXPECT_THAT(twice.output, HasSubstr("is named for two outputs"));
}

TEST_F(ImportAppTest, HelpAndVersion)
{
    const Outcome help = import("--help");
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.output, HasSubstr("kitti-raw"));
    EXPECT_THAT(help.output, HasSubstr("Examples:"));
    EXPECT_THAT(help.output, HasSubstr("vdamf-track -i drive_0001.rawlog"));
    EXPECT_EQ(import("kitti-raw --help").exitCode, 0);
    EXPECT_THAT(import("kitti-raw --help").output, HasSubstr("Example:"));
    EXPECT_EQ(import("--version").exitCode, 0);
    EXPECT_THAT(import("--version").output, ::testing::MatchesRegex("vdamf-import [0-9.]+\n"));
}

}  // namespace
}  // namespace vdamf
