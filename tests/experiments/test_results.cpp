// SPDX-License-Identifier: BSD-3-Clause
// Tables, the best setting, the front, and the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vdamf/experiments/results.h"
#include "vdamf/experiments/sweep_page.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Four settings of two keys on two recordings. The second one fails once, the fourth one does not
// know its position error once.
SweepResults example()
{
    SweepResults results;
    results.keys = {"measurement.filter", "measurement.sigma_m"};
    results.settings = {
        {{"paper", "0.1"}}, {{"paper", "0.2"}}, {{"lines", "0.1"}}, {{"lines", "0.2"}}};
    results.recordings = {"a", "b<c"};
    results.metrics = {"hota.hota", "errors.position_m.median"};
    results.goal = {"hota.hota", true};
    const auto add = [&](std::size_t setting, std::size_t recording, const std::string& failure,
                         std::optional<double> hota, std::optional<double> position, double ms)
    {
        const std::string run = "run" + std::to_string(2 * setting + recording);
        results.rows.push_back({setting, recording, run, failure, {hota, position}, {10, 1.5, ms}});
    };
    add(0, 0, "", 0.5, 0.2, 4.0);
    add(0, 1, "", 0.6, 0.3, 6.0);
    add(1, 0, "", 0.9, 0.1, 1.0);
    add(1, 1, "it broke & fell", std::nullopt, std::nullopt, 0.0);
    add(2, 0, "", 0.7, 0.1, 8.0);
    add(2, 1, "", 0.7, 0.1, 8.0);
    add(3, 0, "", 0.61, std::nullopt, 9.0);
    add(3, 1, "", 1.0 / 3.0, 0.1, 9.0);
    return results;
}

TEST(SweepResults, TableHasNoTimes)
{
    EXPECT_EQ(tableCsv(example()),
              "setting,recording,measurement.filter,measurement.sigma_m,status,run,hota.hota,"
              "errors.position_m.median\n"
              "1,a,paper,0.1,done,run0,0.5,0.2\n"
              "1,b<c,paper,0.1,done,run1,0.6,0.3\n"
              "2,a,paper,0.2,done,run2,0.9,0.1\n"
              "2,b<c,paper,0.2,failed,run3,,\n"
              "3,a,lines,0.1,done,run4,0.7,0.1\n"
              "3,b<c,lines,0.1,done,run5,0.7,0.1\n"
              "4,a,lines,0.2,done,run6,0.61,\n"
              "4,b<c,lines,0.2,done,run7,0.333333333,0.1\n");
    EXPECT_THAT(timesCsv(example()), HasSubstr("\n1,b<c,run1,10,1.5,6\n2,a,run2,10,1.5,1\n3,a,"));
}

TEST(SweepResults, ASettingWithAFailedRunIsNotTheBest)
{
    SweepResults results = example();
    EXPECT_EQ(bestSetting(results), 2U);
    const std::vector<SettingSummary> all = summaries(results);
    EXPECT_EQ(all[0].means[0], 0.55);
    EXPECT_EQ(all[0].msPerFrame, 5.0);
    EXPECT_EQ(all[1].means[0], std::nullopt);
    EXPECT_EQ(all[1].failures, 1U);
    EXPECT_EQ(all[3].means[1], std::nullopt);
    results.goal = {"errors.position_m.median", false};
    EXPECT_EQ(bestSetting(results), 2U);
    results.goal.highest = true;
    EXPECT_EQ(bestSetting(results), 0U);
    results.rows.resize(4);
    for (SweepRow& row : results.rows) row.failure = "no";
    EXPECT_EQ(bestSetting(results), std::nullopt);
}

TEST(SweepResults, ARecordingThatFailsWithEverySettingDoesNotCount)
{
    SweepResults results = example();
    EXPECT_TRUE(silentRecordings(results).empty());
    for (SweepRow& row : results.rows)
        if (row.recording == 1) row.failure = "no such file";
    EXPECT_THAT(silentRecordings(results), ElementsAre("b<c"));
    EXPECT_EQ(bestSetting(results), 1U);
    EXPECT_EQ(summaries(results)[1].means[0], 0.9);
    EXPECT_EQ(summaries(results)[1].msPerFrame, 1.0);
    EXPECT_EQ(summaries(results)[0].failures, 1U);
    EXPECT_THAT(sweepPage(results, "x"), HasSubstr("b&lt;c has no hota.hota with any setting"));
}

TEST(SweepResults, TheFrontHoldsWhatNothingElseBeats)
{
    SweepResults results = example();
    EXPECT_THAT(paretoFront(results), ElementsAre(0U, 2U));
    results.rows[2].failure = "no";
    for (const std::size_t row : {0U, 1U}) results.rows[row].times.trackingMsPerFrame = 8.5;
    EXPECT_THAT(paretoFront(results), ElementsAre(2U));
}

TEST(SweepPage, HoldsAllThatThereIsToSee)
{
    const std::string page = sweepPage(example(), "a & b");
    EXPECT_THAT(page, HasSubstr("<title>a &amp; b"));
    EXPECT_THAT(page, HasSubstr("b&lt;c"));
    EXPECT_THAT(page, Not(HasSubstr("b<c")));
    EXPECT_THAT(page, HasSubstr("failed: it broke &amp; fell"));
    EXPECT_THAT(page, HasSubstr("<tr id=\"setting-3\" class=\"best\">"));
    EXPECT_THAT(page, HasSubstr("measurement.filter (1 paper, 2 lines)"));
    EXPECT_THAT(page, HasSubstr("data-setting=\"3\""));
    // The heat map: position error of the one setting that knows it for lines and 0.2.
    EXPECT_THAT(page, HasSubstr("measurement.sigma_m = 0.1, measurement.filter = lines: 0.7<"));
    for (const char* from : {"http:", "https:", "src=", "href=", "@import"})
    {
        std::string text = page;
        for (std::size_t i; (i = text.find("http://www.w3.org/2000/svg")) != std::string::npos;)
            text.erase(i, 26);
        EXPECT_THAT(text, Not(HasSubstr(from))) << "the page must need no network";
    }
}

TEST(SweepPage, OfAlmostNothing)
{
    SweepResults results = example();
    results.keys = {"scan.label"};
    results.settings = {{{""}}};
    results.rows = {results.rows[3]};
    results.rows[0].setting = 0;
    EXPECT_THAT(sweepPage(results, "x"), HasSubstr("no setting has hota.hota"));
}

}  // namespace
}  // namespace vdamf
