// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/run_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/example_run.h"
#include "report/page_data.h"

namespace vdamf
{
namespace
{
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

RunReport exampleReport(int frames)
{
    RunReport report;
    for (int f = 0; f < frames; ++f)
    {
        const double time = 1.7e9 + 0.1 * f;
        report.add(test::exampleFrame(time), test::exampleResult(time));
    }
    return report;
}

TruthRow exampleTruth(double time, const std::string& id, double y)
{
    TruthRow row;
    row.time = time;
    row.objectId = id;
    row.objectClass = "Car";
    row.box = {5022.0, y, 0.0, 4.0, 2.0};
    row.height = 1.5;
    row.speed = 8.0;
    row.points = 100;
    return row;
}

TEST(RunReport, CarriesFramesAndTracks)
{
    const std::string page = exampleReport(3).html({"a <run> & more", "1.2", "[ini]", {}, {}});
    EXPECT_THAT(page, HasSubstr("<title>a &lt;run> &amp; more</title>"));
    const json run = test::runOf(page);
    EXPECT_EQ(run["facts"]["title"], "a <run> & more");
    EXPECT_EQ(run["frames"]["time"], json::parse("[0.0, 0.1, 0.2]"));
    EXPECT_EQ(run["frames"]["sensor"][1], json::parse("[5000.0, 200.0, 11.8]"));
    ASSERT_EQ(run["tracks"].size(), 1U);
    const json& track = run["tracks"][0];
    EXPECT_EQ(track["id"], 7);
    EXPECT_EQ(track["frame"], json::parse("[0, 1, 2]"));
    EXPECT_EQ(track["status"][2], "confirmed");
    EXPECT_EQ(track["x"][0], 5022.0);
    EXPECT_EQ(track["speed"][0], 8.0);
    EXPECT_EQ(track["faces"][0], "B");
    EXPECT_EQ(track["probability"][0], nullptr);
    EXPECT_EQ(track["forward"][0], 0.5);
    EXPECT_EQ(track["axes"][0], 0.5);
    EXPECT_EQ(track["varHeading"][0], 0.0004);
    EXPECT_EQ(track["measured"][0], json::parse("[5022.1, 200.1, 0.01, 4.2, 2.1]"));
    EXPECT_EQ(run["truth"], nullptr);
    const auto groups = test::decoded(test::dataOf(page, "hits2"));
    ASSERT_EQ(groups.size(), 4U);
    EXPECT_EQ(groups[3].track, 7U);
}

TEST(RunReport, IsOneFileThatAsksForNothingElse)
{
    const std::string page = exampleReport(1).html({});
    for (const char* word : {"src=\"http", "href=\"http", "import ", "<link rel=\"stylesheet\"",
                             "fetch(", "XMLHttpRequest", "@import"})
        EXPECT_THAT(page, Not(HasSubstr(word)));
    EXPECT_THAT(page, Not(HasSubstr("<!--data-->")));
    EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
}

TEST(RunReport, JudgesByTheTruth)
{
    ReportTruth truth;
    for (int f = 0; f < 3; ++f)
    {
        truth.rows.push_back(exampleTruth(1.7e9 + 0.1 * f, "found", 200.0));
        truth.rows.push_back(exampleTruth(1.7e9 + 0.1 * f, "missed", 230.0));
    }
    const json run = test::runOf(exampleReport(3).html({}, truth));
    const json& judged = run["truth"];
    ASSERT_EQ(judged["objects"].size(), 2U);
    EXPECT_EQ(judged["objects"][0]["id"], "found");
    EXPECT_EQ(judged["objects"][1]["frame"], json::parse("[0, 1, 2]"));
    EXPECT_EQ(judged["matches"][1], json::parse(R"({"pairs": [[0, 7, 1.0]], "missed": [1],
                                                    "false": []})"));
    ASSERT_EQ(judged["mistakes"].size(), 1U);
    EXPECT_EQ(judged["mistakes"][0]["kind"], "never_found");
    EXPECT_EQ(judged["mistakes"][0]["object"], 1);
    EXPECT_EQ(judged["mistakes"][0]["last"], 2);
    EXPECT_EQ(judged["metrics"]["clear_mot"]["recall"], 0.5);
}

TEST(RunReport, LeavesOutTruthOfFramesThatWereNotTracked)
{
    ReportTruth truth;
    for (int f = -5; f < 20; ++f)
        truth.rows.push_back(exampleTruth(1.7e9 + 0.1 * f, "found", 200.0));
    const json judged = test::runOf(exampleReport(3).html({}, truth))["truth"];
    EXPECT_EQ(judged["objects"][0]["frame"], json({0, 1, 2}));
    EXPECT_EQ(judged["mistakes"], json::array());
    EXPECT_EQ(judged["metrics"]["clear_mot"]["recall"], 1.0);
    // Also where the run has no tracks that could say that nothing fits.
    RunReport empty;
    empty.add(test::exampleFrame(1.8e9), test::exampleResult(1.8e9, {}));
    EXPECT_THROW(empty.html({}, truth), std::runtime_error);
}

TEST(RunReport, HasTheSameBytesEachTime)
{
    const RunFacts facts{"run", "1", "", {{"a", "b"}}, {{"reading", 1.5}}};
    EXPECT_EQ(exampleReport(2).html(facts), exampleReport(2).html(facts));
}

TEST(RunReport, TakesTextThatIsNoUtf8)
{
    const std::string page = exampleReport(1).html({"file\xff\xc3.\xc3\xa4", "", "", {}, {}});
    const std::string title = "file\xef\xbf\xbd\xef\xbf\xbd.\xc3\xa4";
    EXPECT_EQ(test::runOf(page)["facts"]["title"], title);
    EXPECT_THAT(page, HasSubstr("<title>" + title));
    EXPECT_THAT(page, Not(HasSubstr("\xff")));
}

TEST(RunReport, NeedsAFrame)
{
    EXPECT_THROW(RunReport().html({}), std::runtime_error);
}

}  // namespace
}  // namespace vdamf
