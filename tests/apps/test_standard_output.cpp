// SPDX-License-Identifier: BSD-3-Clause
// What programs say where their standard output cannot be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "apps/train_fixture.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;

class StandardOutput : public TrainFixture
{
protected:
    void isMissed(const std::string& app, const std::string& arguments)
    {
        EXPECT_EQ(run(app, arguments + " > /dev/full"), 1) << app << ' ' << arguments;
        EXPECT_THAT(output_, HasSubstr(app + ": cannot write to the standard output: No space"));
    }
};

TEST_F(StandardOutput, IsMissedWithTheOutputsKept)
{
    make("scene.ini", "[scenario]\nduration_s = 0.2\n[sensor]\nmodel = VLP-16\n");
    isMissed("vdamf-simulate", "scene.ini -o scene.rawlog");
    EXPECT_TRUE(std::filesystem::exists(at("scene.rawlog")));
    EXPECT_EQ(run("vdamf-simulate", "scene.ini -o quiet.rawlog -q > /dev/full"), 0) << output_;

    make("sources.ini", "[simulated cars]\nkind = car\nclusters = 5\n");
    isMissed("vdamf-train", "filter sources.ini -o filter.txt --folds 0 --global 2 --local 2 -q");
    EXPECT_TRUE(std::filesystem::exists(at("filter.txt")));

    const std::string street = "-q --frames 0:3 -i " + kStreetFolder + "street.rawlog";
    ASSERT_EQ(run("vdamf-track", street + " -o tracked.rawlog"), 0) << output_;
    isMissed("vdamf-report", "tracked.rawlog -o page.html");
    EXPECT_TRUE(std::filesystem::exists(at("page.html")));
}

TEST_F(StandardOutput, IsMissedByAllThatTellsOfItself)
{
    for (const char* app : {"vdamf-evaluate", "vdamf-fit", "vdamf-import", "vdamf-report",
                            "vdamf-simulate", "vdamf-sweep", "vdamf-track", "vdamf-train"})
        for (const char* option : {"--help", "--version"}) isMissed(app, option);
}
}  // namespace
}  // namespace vdamf
