// SPDX-License-Identifier: BSD-3-Clause
// The regression table: its numbers, what they look like, and the way into a file and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "benchmarks/regression_rows.h"
#include "files/temporary_folder.h"
#include "regression/tables.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;

class RegressionTables : public TemporaryFolder
{
};

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

const Metric& metric(const std::string& name)
{
    return metrics().at(metricIndex(name).value());
}

TEST_F(RegressionTables, MetricsHaveNamesOfTheirOwn)
{
    for (std::size_t k = 0; k < metrics().size(); ++k)
        EXPECT_EQ(metricIndex(metrics()[k].name), k) << metrics()[k].name;
    EXPECT_EQ(metricIndex("no_such"), std::nullopt);
}

TEST_F(RegressionTables, ShowsAsManyDecimalsAsThereIsRoomFor)
{
    const Metric& position = metric("position_rms_m");
    EXPECT_EQ(shown(position, 0.0734), "7.34");
    EXPECT_EQ(shown(position, 0.734), "73.4");
    EXPECT_EQ(shown(position, 7.34), "734");
    EXPECT_EQ(shown(position, 0.099996), "10.0");  // not "10.00", which would touch its neighbour
    EXPECT_EQ(shown(position, std::nullopt), "-");
    EXPECT_EQ(shown(metric("mota"), -4.6), "-460");
    EXPECT_EQ(shown(metric("flips"), 12.0), "12");
}

TEST_F(RegressionTables, TerminalLinesAreOfOneWidthBelow131)
{
    RegressionRow longName = regressionRow("two_wheelers_and_people_and_more", 123.456);
    const std::vector<std::string> lines =
        linesOf(terminalTable({regressionRow("a", 0.5), longName, regressionRow("c", 2.0)}));
    ASSERT_EQ(lines.size(), 6U);  // two of heading, three rows, the medians
    for (const std::string& line : lines)
    {
        EXPECT_EQ(line.size(), lines.front().size()) << line;
        EXPECT_LE(line.size(), 130U);
    }
    EXPECT_THAT(lines[3], HasSubstr("~"));
    EXPECT_THAT(lines[5], HasSubstr("median"));
}

TEST_F(RegressionTables, MedianRowLeavesOutWhatIsNotKnown)
{
    RegressionRow unknown = regressionRow("b", 5.0);
    unknown.values[metricIndex("flips").value()].reset();
    const std::vector<std::string> lines =
        linesOf(markdownTable({regressionRow("a", 1.0), unknown, regressionRow("c", 3.0)}));
    ASSERT_EQ(lines.size(), 6U);
    EXPECT_THAT(lines[0], HasSubstr("| position RMS cm |"));
    EXPECT_THAT(lines[3], HasSubstr("| - |"));
    // objects: of 1, 5, 3; flips: of 1 and 3
    EXPECT_THAT(lines[5], HasSubstr("| median | 3 | 3 |"));
    EXPECT_THAT(lines[5], HasSubstr("| 3 | 2 |"));
}

TEST_F(RegressionTables, CsvComesBackAsItWas)
{
    RegressionRow row = regressionRow("street", 0.12345);
    row.values[metricIndex("frames").value()] = 150.0;
    row.values[metricIndex("phantom_speed_p95_mps").value()].reset();
    for (const char* count : {"objects", "identity_switches", "flips"})
        row.values[metricIndex(count).value()] = 7.0;
    make("table.csv", toCsv({row}));
    const std::vector<RegressionRow> back = readRegressionTable(at("table.csv"));
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back[0].scenario, "street");
    EXPECT_EQ(back[0].values[0], 150.0);
    EXPECT_EQ(back[0].values, row.values);
}

TEST_F(RegressionTables, OlderTablesMayHaveFewerColumns)
{
    make("table.csv", "scenario,recall\nstreet,0.5\n");
    const std::vector<RegressionRow> rows = readRegressionTable(at("table.csv"));
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].values[metricIndex("recall").value()], 0.5);
    EXPECT_EQ(rows[0].values[metricIndex("hota").value()], std::nullopt);
}

TEST_F(RegressionTables, BadTablesAreNamed)
{
    make("table.csv", "scenario,recall\nstreet,half\n");
    const std::string error = errorOf([&] { readRegressionTable(at("table.csv")); });
    EXPECT_THAT(error, HasSubstr("table.csv:2"));
    EXPECT_THAT(error, HasSubstr("recall"));
}

// Else a table would differ from its own file.
TEST_F(RegressionTables, ValuesAreThoseOfTheFile)
{
    nlohmann::json evaluation;
    for (const Metric& one : metrics())
        if (*one.pointer != '\0') evaluation[nlohmann::json::json_pointer(one.pointer)] = 1.0 / 3.0;
    evaluation["phantom_speed_mps"]["p95"] = nullptr;
    const MetricValues values = valuesOf(evaluation, 2.5);
    EXPECT_EQ(values[metricIndex("recall").value()], 0.33333);
    EXPECT_EQ(values[metricIndex("phantom_speed_p95_mps").value()], std::nullopt);
    EXPECT_EQ(values[metricIndex("time_per_frame_ms").value()], 2.5);
}

TEST_F(RegressionTables, MissingKeysOfTheEvaluationAreErrors)
{
    const std::string error =
        errorOf([] { valuesOf(nlohmann::json::parse(R"({"scored": {"frames": 3}})"), {}); });
    EXPECT_THAT(error, HasSubstr("/scored/objects"));
}

}  // namespace
}  // namespace vdamf
