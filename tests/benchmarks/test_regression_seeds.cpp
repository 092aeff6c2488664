// SPDX-License-Identifier: BSD-3-Clause
// Scenarios with many seeds, and the table of their consistency.
#include "regression/seeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression_rows.h"

namespace vdamf
{
namespace
{
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(RegressionSeeds, OnlyWhatIsSimulatedHasSeeds)
{
    RegressionScenario simulated;
    simulated.name = "turn";
    const std::string file = VDAMF_SOURCE_DIR "/datasets/scenarios/lane_change.ini";
    simulated.make = {"vdamf-simulate", file};
    RegressionScenario recorded;
    recorded.name = "drive";
    recorded.make = {"vdamf-import", "kitti-raw"};
    const auto all = withSeeds({simulated, recorded}, 2);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].name, "turn/seed_1");
    ASSERT_GT(all[1].make.size(), 4U);
    EXPECT_THAT(std::vector<std::string>(all[1].make.begin(), all[1].make.begin() + 4),
                ElementsAre("vdamf-simulate", file, "--set", "scenario.seed=2"));
    EXPECT_THAT(all[1].make, Contains(StartsWith("object changing.length_m=")));
    EXPECT_NE(all[0].make[5], all[1].make[5]) << "of another start";
}

TEST(RegressionSeeds, TellsWhetherTheMeanIsInItsBand)
{
    std::vector<RegressionRow> rows;
    for (int k = 0; k < 50; ++k)
        rows.push_back(regressionRow("right/seed_1", k % 2 == 0 ? 0.9 : 1.1));
    rows.push_back(regressionRow("sure/seed_1", 30.0));
    rows.push_back(regressionRow("shy/seed_1", 0.0001));
    const std::string table = seedsTable(rows);
    // The band of 50 runs in three dimensions.
    EXPECT_THAT(table, HasSubstr("right                       50   1.00  0.79-1.24"));
    EXPECT_THAT(table, HasSubstr("30.00*"));
    EXPECT_THAT(table, HasSubstr("0.00."));
    EXPECT_THAT(table, Not(HasSubstr("1.00*")));
}

TEST(RegressionSeeds, AllScenesAreOnePopulation)
{
    std::vector<RegressionRow> rows;
    for (int k = 0; k < 50; ++k) rows.push_back(regressionRow("turn/seed", 0.5));
    EXPECT_THAT(seedsTable(rows), Not(HasSubstr("population"))) << "the scene is all there is";
    for (int k = 0; k < 50; ++k) rows.push_back(regressionRow("stop/seed", 1.5));
    EXPECT_THAT(seedsTable(rows), HasSubstr("all, as one population     100   1.00  0.85-1.17"));
}

TEST(RegressionSeeds, WhatIsNotKnownIsLeftOut)
{
    RegressionRow unknown = regressionRow("turn/seed_2", 5.0);
    unknown.values[*metricIndex("speed_rms_mps")].reset();
    const std::string table = seedsTable({regressionRow("turn/seed_1", 1.0), unknown});
    EXPECT_THAT(table, HasSubstr("1.000"));
}

}  // namespace
}  // namespace vdamf
