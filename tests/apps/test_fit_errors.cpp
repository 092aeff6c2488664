// SPDX-License-Identifier: BSD-3-Clause
// vdamf-fit on tables that are none, and with bad command lines.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "apps/fit_fixture.h"
#include "vdamf/files/text_file.h"
#include "vdamf/rawlog/filter_file.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
namespace fs = std::filesystem;

using FitErrors = FitProgram;

TEST_F(FitErrors, MalformedTablesAreErrorsWithTheirPlace)
{
    struct Case
    {
        std::string table;
        const char* message;
    };
    const Case cases[] = {
        {"", "clusters.csv:1: the file is empty"},
        {kFitHeader, "clusters.csv: the table has no rows"},
        {"cluster,sensor_x_m,sensor_y_m,x,y_m\na,0,0,1,2\n", "the column 'x_m' is missing"},
        {kFitHeader + "a,0,0,1\n", "clusters.csv:2: expected 5 cells"},
        {kFitHeader + "a,0,0,1,2\na,0,0,1,two\n", "clusters.csv:3:"},
        {kFitHeader + ",0,0,1,2\n", "clusters.csv:2:"},
        {kFitHeader + "a,0,0,1,2\nb,0,0,1,2\na,0,0,1,2\n", "clusters.csv:4:"},
        {kFitHeader + "a,0,0,1,2\na,0,1,1,2\n", "sensor_y_m"},
    };
    for (const Case& one : cases)
    {
        EXPECT_EQ(fit(one.table), 1);
        EXPECT_THAT(output_, HasSubstr(one.message));
        EXPECT_FALSE(fs::exists(at("fits.csv")));
        EXPECT_FALSE(fs::exists(at("fits.csv.partial")));
    }
}

TEST_F(FitErrors, BadUseEndsWithTwoAndOutputsAreNotReplaced)
{
    make("clusters.csv", kFitHeader + twoFaces("car", kCar, {0.0, 0.0}));
    EXPECT_EQ(run(""), 2);
    EXPECT_EQ(run("-i clusters.csv"), 2);
    EXPECT_EQ(run("-i clusters.csv -o ./clusters.csv --overwrite"), 2);
    EXPECT_EQ(run("-i clusters.csv -o fits.csv --set measurement.optimiser=x"), 2);
    EXPECT_THAT(output_, HasSubstr("optimizer"));
    EXPECT_EQ(run("-i clusters.csv -o fits.csv -c missing.ini"), 2);
    EXPECT_EQ(run("-i missing.csv -o fits.csv"), 1);
    EXPECT_THAT(output_, HasSubstr("missing.csv"));
    EXPECT_FALSE(fs::exists(at("fits.csv")));
    EXPECT_EQ(run("-i clusters.csv -o fits.csv -q"), 0);
    EXPECT_EQ(output_, "");
    EXPECT_EQ(run("-i clusters.csv -o fits.csv"), 1);
    EXPECT_THAT(output_, HasSubstr("--overwrite"));
    EXPECT_EQ(run("-i clusters.csv -o /dev/stdout"), 0);
    EXPECT_THAT(output_, testing::StartsWith("cluster,points,x_m"));
    EXPECT_EQ(run("--help"), 0);
    EXPECT_THAT(output_, HasSubstr("Example"));
}

TEST_F(FitErrors, NothingThatTheConfigurationNamesIsWrittenOver)
{
    make("clusters.csv", kFitHeader + twoFaces("car", kCar, {0.0, 0.0}));
    fs::copy_file(VDAMF_SOURCE_DIR "/models/vehicle.txt", at("vehicle.txt"));
    FilterBank bank;
    bank.record = {"a program", "data", "options", "held out"};
    bank.filters.emplace_back();
    make("filters.txt", toText(bank));
    make("c.ini",
         "[discriminator]\nmodel = vehicle.txt\n[measurement]\nfilter_file = filters.txt\n");
    EXPECT_EQ(run("-i clusters.csv -c c.ini --overwrite -o filters.txt"), 2);
    EXPECT_THAT(output_, HasSubstr("filters.txt: is measurement.filter_file"));
    EXPECT_EQ(run("-i clusters.csv -c c.ini --overwrite -o vehicle.txt"), 2);
    EXPECT_THAT(output_, HasSubstr("vehicle.txt: is discriminator.model"));
    EXPECT_EQ(readTextFile(at("filters.txt")), toText(bank));
    EXPECT_EQ(run("-i clusters.csv -c c.ini -o fits.csv"), 0) << output_;
}

TEST_F(FitErrors, WhatIsInterruptedLeavesNothing)
{
    // A pipe that has given some clusters and stays open.
    make("some.csv", kFitHeader + twoFaces("a", kCar, {0.0, 0.0}) +
                         twoFaces("b", kCar, {0.0, 0.0}) + twoFaces("c", kCar, {0.0, 0.0}));
    const Outcome outcome = runShell("cd '" + at("").string() +
                                     "' && mkfifo pipe && { (cat some.csv; sleep 0.5; cat some.csv "
                                     "| tail -n +2; sleep 2) > pipe & } && "
                                     "timeout --preserve-status -s INT 0.3 '" VDAMF_APPS_DIR
                                     "/vdamf-fit' -i pipe -o fits.csv");
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("interrupted"));
    EXPECT_FALSE(fs::exists(at("fits.csv")));
    EXPECT_FALSE(fs::exists(at("fits.csv.partial")));
}

}  // namespace
}  // namespace vdamf
