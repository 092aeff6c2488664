// SPDX-License-Identifier: BSD-3-Clause
// Scenarios from many starts, and which changes their table calls more than chance.
#include "regression/starts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression_rows.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RegressionStarts, AreTrackedAndScoredFromTheirFrameOn)
{
    RegressionScenario drive;
    drive.name = "drive";
    drive.track = {"--set", "a.b=1"};
    drive.score = {"--min-points", "20"};
    const auto all = withStarts({drive}, 3);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[2].name, "drive/start_2");
    EXPECT_THAT(all[2].track, ElementsAre("--set", "a.b=1", "--frames", "2:2147483647"));
    EXPECT_THAT(all[0].score, ElementsAre("--min-points", "20", "--tracked-span"));
}

std::vector<RegressionRow> rowsOf(const std::vector<double>& values)
{
    std::vector<RegressionRow> rows;
    for (const double value : values)
        rows.push_back(regressionRow("drive/start_" + std::to_string(rows.size()), value));
    return rows;
}

TEST(RegressionStarts, TellMeanAndStandardDeviation)
{
    const std::string table = startsTable(rowsOf({0.5, 0.6, 0.7}), {});
    EXPECT_THAT(table, HasSubstr("drive                    3   0.600 0.100"));
    EXPECT_THAT(table, Not(HasSubstr("change")));
}

TEST(RegressionStarts, TellChangesFromChance)
{
    const std::vector<RegressionRow> before = rowsOf({0.5, 0.6, 0.7});
    EXPECT_THAT(startsTable(rowsOf({0.51, 0.62, 0.71}), before),
                HasSubstr("  change                 3  +0.013 0.003*"));
    EXPECT_THAT(startsTable(rowsOf({0.51, 0.58, 0.73}), before),
                HasSubstr("  change                 3  +0.007 0.015 "));
}

TEST(RegressionStarts, CompareWhatBothHave)
{
    EXPECT_THAT(startsTable(rowsOf({0.6, 0.7}), rowsOf({0.5})),
                HasSubstr("  change                 1  +0.100 0.000 "))
        << "one alone is never sure";
    RegressionRow unknown = regressionRow("drive/start_0", 0.6);
    unknown.values[*metricIndex("vehicles_hota")].reset();
    EXPECT_THAT(startsTable({unknown}, rowsOf({0.5})),
                HasSubstr("drive                    1              -"));
}
}  // namespace
}  // namespace vdamf
