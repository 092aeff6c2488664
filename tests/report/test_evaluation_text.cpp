// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/evaluation_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "evaluation/example_pairs.h"
#include "vdamf/report/evaluation_plots.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
using testing::Not;

struct Tables
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;
};

/// A car, its track 0.3 m ahead of it, and a track on nothing.
Tables shiftedTables(bool withProbability)
{
    Tables tables;
    for (int k = 0; k < 40; ++k)
    {
        TruthRow truth = exampleCar(100.0 + 0.1 * k);
        truth.box.x += 0.5 * k;
        truth.sensor->x += 0.4 * k;
        tables.truth.push_back(truth);
        tables.tracks.push_back(moved(trackOn(truth, 1), 0.3, 0.0));
        tables.tracks.push_back(moved(trackOn(truth, 2), 0.0, 40.0));
        if (!withProbability) continue;
        tables.tracks[tables.tracks.size() - 2].report.vehicleProbability = 0.9;
        tables.tracks.back().report.vehicleProbability = 0.2;
    }
    return tables;
}

Evaluation shifted(bool withProbability)
{
    const Tables tables = shiftedTables(withProbability);
    return evaluate(tables.truth, tables.tracks);
}

std::size_t longestLine(const std::string& text)
{
    std::istringstream lines(text);
    std::size_t longest = 0;
    for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
    return longest;
}

TEST(EvaluationText, SaysWhatMatters)
{
    const std::string text = evaluationText(shifted(false));
    EXPECT_THAT(text, HasSubstr("40 frames (3.9 s), 1 objects in 40 rows, tracks in 80"));
    EXPECT_THAT(text, HasSubstr("recall      1.000  precision   0.500"));
    EXPECT_THAT(text, HasSubstr("false alarms a frame 1.00, identity switches 0"));
    EXPECT_THAT(text, HasSubstr("    along the heading          0.300     0.300     0.300     0.300"
                                "        40"));
    EXPECT_THAT(text, HasSubstr("  10-20            40    0.30    0.30"));
    EXPECT_THAT(text, HasSubstr("so every tracked bush and wall off the labels is a false alarm"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(EvaluationText, FitsATerminal)
{
    for (const bool withProbability : {false, true})
    {
        const Evaluation evaluation = shifted(withProbability);
        EXPECT_LE(longestLine(evaluationText(evaluation)), 80U);
        EXPECT_LE(longestLine(objectsText(evaluation)), 80U);
    }
}

TEST(EvaluationText, TellsOfTheDiscriminatorWhereThereIsOne)
{
    const std::string text = evaluationText(shifted(true));
    EXPECT_THAT(text, HasSubstr("Discriminator (40 rows of vehicles, 40 of clutter, 2 tracks)"));
    EXPECT_THAT(text, HasSubstr("area under the ROC        1.0000"));
    EXPECT_THAT(text, HasSubstr("miss rate at FPR 1 %           -"));
    EXPECT_THAT(text, Not(HasSubstr("bush")));
}

TEST(EvaluationText, OfNothingTracked)
{
    const Evaluation evaluation = evaluate(shiftedTables(false).truth, {});
    const std::string text = evaluationText(evaluation) + objectsText(evaluation);
    EXPECT_THAT(text, HasSubstr("recall      0.000  precision       -"));
    EXPECT_THAT(text, HasSubstr("0 % ever tracked"));
    EXPECT_THAT(text, HasSubstr("Discriminator: there are no tracks to tell apart"));
    EXPECT_THAT(text, Not(HasSubstr("false alarm.")));
    EXPECT_THAT(text, HasSubstr("too few values to tell"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(EvaluationText, OneLineAnObject)
{
    EXPECT_THAT(objectsText(shifted(false)),
                HasSubstr("  car             Car             40     40      1    0.86     0.00"));
}

TEST(EvaluationCharts, HaveTheirNames)
{
    const Evaluation with = shifted(true);
    std::vector<std::string> names;
    for (const NamedChart& named : evaluationCharts(with))
    {
        names.push_back(named.name);
        EXPECT_THAT(chartsSvg({named.chart}), Not(HasSubstr("nothing to show"))) << named.name;
    }
    EXPECT_EQ(names, evaluationChartNames());
    EXPECT_EQ(evaluationCharts(shifted(false)).size(), names.size() - 2);
}

TEST(EvaluationCharts, TheDiscriminatorsCurveIsDrawn)
{
    const auto charts = evaluationCharts(shifted(true));
    const Chart& roc = charts[charts.size() - 2].chart;
    ASSERT_EQ(roc.curves.front().points.size(), 3U);
    EXPECT_EQ(roc.curves.front().points[1], Eigen::Vector2d(0.0, 1.0));
}

}  // namespace
}  // namespace vdamf
