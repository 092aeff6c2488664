// SPDX-License-Identifier: BSD-3-Clause
// Whose folder and files vdamf-sweep writes over and removes.
#include <gmock/gmock.h>

#include "apps/sweep_fixture.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

TEST_F(SweepProgram, WritesOverNothingThatItReads)
{
    fs::create_directory(at("out"));
    fs::copy(VDAMF_SOURCE_DIR "/models/vehicle.txt", at("out/best.ini"));
    const std::string model = contentOf("out/best.ini");
    make("conf.ini", "[discriminator]\nmodel = out/best.ini\n");
    const auto expectRefusal = [&]
    {
        const Outcome refused = sweep("out");
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_THAT(refused.output, HasSubstr("best.ini: is discriminator.model"));
        EXPECT_EQ(contentOf("out/best.ini"), model);
    };
    writeSweep("config = conf.ini", "measurement.sigma_m = 0.1, 0.2");
    expectRefusal();
    writeSweep("", "discriminator.model = none, out/best.ini");
    expectRefusal();
    writeSweep("", "measurement.sigma_m = 0.1, 0.2", "set = discriminator.model=out/best.ini\n");
    expectRefusal();
}

TEST_F(SweepProgram, WhatIsNotOfASweepStays)
{
    writeSweep("", "measurement.sigma_m = 0.1, 0.2");
    for (const char* name : {"sweep.ini", "table.csv", "times.csv", "report.html", "best.ini",
                             "best.ini.partial", "runs/notes.txt"})
    {
        fs::remove_all(at("own"));
        make(std::string("own/") + name, "mine");
        for (const char* how : {"", "--no-resume", "--dry-run"})
        {
            const Outcome refused = sweep("own", how);
            EXPECT_EQ(refused.exitCode, 2) << name << how;
            EXPECT_THAT(refused.output, HasSubstr("is no folder of a sweep"));
            EXPECT_THAT(refused.output, HasSubstr(at("own").string()));
            EXPECT_EQ(contentOf(std::string("own/") + name), "mine");
            EXPECT_EQ(std::distance(fs::directory_iterator(at("own")), {}), 1) << name << how;
        }
    }
}

TEST_F(SweepProgram, ForgetsRunsAndNothingElse)
{
    writeSweep("", "measurement.sigma_m = 0.1");
    make("out/notes.txt", "mine");
    ASSERT_EQ(sweep("out").exitCode, 0);
    make("out/runs/notes.txt", "mine");
    const Outcome again = sweep("out", "--no-resume");
    EXPECT_EQ(again.exitCode, 0);
    EXPECT_THAT(again.output, Not(HasSubstr("done before")));
    EXPECT_EQ(contentOf("out/notes.txt"), "mine");
    EXPECT_EQ(contentOf("out/runs/notes.txt"), "mine");
}

TEST_F(SweepProgram, ForgetsNoRunThatItReads)
{
    writeSweep("", "measurement.sigma_m = 0.1");
    ASSERT_EQ(sweep("out").exitCode, 0);
    const fs::path run = fs::directory_iterator(at("out/runs"))->path();
    writeSweep("config = " + (run / "config.ini").string(), "measurement.sigma_m = 0.1");
    const Outcome refused = sweep("out", "--no-resume");
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.output,
                HasSubstr("config.ini: is the configuration, and would be removed"));
    EXPECT_TRUE(fs::exists(run / "metrics.json"));
    EXPECT_EQ(sweep("out").exitCode, 0);
    fs::copy(VDAMF_SOURCE_DIR "/datasets/street/truth.csv", run / "truth.csv");
    fs::create_symlink(run / "truth.csv", at("late_truth.csv"));
    fs::create_symlink(VDAMF_SOURCE_DIR "/datasets/street/street.rawlog", at("late.rawlog"));
    writeSweep("", "measurement.sigma_m = 0.1", "[recordings late]\nrawlogs = late.rawlog\n");
    EXPECT_THAT(sweep("out", "--no-resume").output,
                HasSubstr("late_truth.csv: is a truth, and would be removed"));
    EXPECT_TRUE(fs::exists(run / "truth.csv"));
}

}  // namespace
}  // namespace vdamf
