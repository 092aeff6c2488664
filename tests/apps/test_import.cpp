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

TEST_F(ImportAppTest, ABadCommandLineIsTwo)
{
    for (const char* bad : {"", "kitti", "kitti-raw", "kitti-raw drive", "kitti-raw -o o",
                            "kitti-raw drive -o o --gz-level 10", "kitti-raw drive -o o --nonsense",
                            "kitti-raw drive -o o --gz-level x", "--nonsense"})
    {
        EXPECT_EQ(import(bad).exitCode, 2) << bad;
    }
    EXPECT_THAT(import("kitti-raw drive").output, HasSubstr("--output is required"));
}

TEST_F(ImportAppTest, HelpAndVersion)
{
    const Outcome help = import("--help");
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.output, HasSubstr("kitti-raw"));
    EXPECT_THAT(help.output, HasSubstr("Example:"));
    EXPECT_EQ(import("kitti-raw --help").exitCode, 0);
    EXPECT_EQ(import("--version").exitCode, 0);
}

}  // namespace
}  // namespace vdamf
