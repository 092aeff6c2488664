// SPDX-License-Identifier: BSD-3-Clause
// Which changes between two regression tables count, and what is better.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression_rows.h"
#include "regression/comparison.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// The comparison of one scenario in which one metric goes from one value to the other.
Comparison change(const std::string& metric, std::optional<double> before,
                  std::optional<double> after)
{
    RegressionRow old = regressionRow("street", 1.0);
    RegressionRow now = old;
    old.values[metricIndex(metric).value()] = before;
    now.values[metricIndex(metric).value()] = after;
    return compared({old}, {now});
}

Trend trendOf(const std::string& metric, std::optional<double> before, std::optional<double> after)
{
    const Comparison comparison = change(metric, before, after);
    EXPECT_EQ(comparison.changes.size(), 1U) << metric;
    return comparison.changes.at(0).trend;
}

TEST(RegressionComparison, KnowsWhichWayIsBetter)
{
    EXPECT_EQ(trendOf("recall", 0.5, 0.6), Trend::Better);
    EXPECT_EQ(trendOf("recall", 0.6, 0.5), Trend::Worse);
    EXPECT_EQ(trendOf("position_rms_m", 0.5, 0.4), Trend::Better);
    EXPECT_EQ(trendOf("flips", 1.0, 2.0), Trend::Worse);
    EXPECT_EQ(trendOf("frames", 100.0, 90.0), Trend::Changed);
}

TEST(RegressionComparison, ConsistencyIsBetterNearerToOne)
{
    EXPECT_EQ(trendOf("nees_pose_mean", 3.0, 1.2), Trend::Better);
    EXPECT_EQ(trendOf("nees_pose_mean", 0.9, 1.05), Trend::Better);
    EXPECT_EQ(trendOf("nees_pose_mean", 1.5, 0.3), Trend::Worse);
    EXPECT_EQ(trendOf("nees_pose_mean", 1.5, 0.0), Trend::Worse);
}

TEST(RegressionComparison, ValuesThatComeOrGoAreNeither)
{
    EXPECT_EQ(trendOf("position_rms_m", std::nullopt, 0.4), Trend::Changed);
    EXPECT_EQ(trendOf("position_rms_m", 0.4, std::nullopt), Trend::Changed);
    EXPECT_TRUE(change("position_rms_m", std::nullopt, std::nullopt).changes.empty());
}

TEST(RegressionComparison, WhatTheTableDoesNotShowIsNoChange)
{
    EXPECT_TRUE(change("position_rms_m", 0.07341, 0.07342).changes.empty());
    EXPECT_FALSE(change("position_rms_m", 0.0734, 0.0744).changes.empty());
    EXPECT_THAT(change("hota", 0.5, 0.5).unchanged, ElementsAre("street"));
}

TEST(RegressionComparison, TimesAreNoisy)
{
    EXPECT_TRUE(change("time_per_frame_ms", 5.0, 7.4).changes.empty());
    EXPECT_EQ(trendOf("time_per_frame_ms", 5.0, 7.6), Trend::Worse);
    EXPECT_EQ(trendOf("time_per_frame_ms", 5.0, 2.4), Trend::Better);
}

TEST(RegressionComparison, TellsScenariosOfOneTableOnly)
{
    const Comparison comparison = compared({regressionRow("gone", 1.0), regressionRow("kept", 1.0)},
                                           {regressionRow("kept", 1.0), regressionRow("new", 1.0)});
    EXPECT_THAT(comparison.unchanged, ElementsAre("kept"));
    EXPECT_THAT(comparison.onlyBefore, ElementsAre("gone"));
    EXPECT_THAT(comparison.onlyAfter, ElementsAre("new"));
}

TEST(RegressionComparison, WordsMarkBetterAndWorse)
{
    RegressionRow before = regressionRow("street", 1.0);
    RegressionRow after = before;
    after.values[metricIndex("recall").value()] = 0.5;
    after.values[metricIndex("position_rms_m").value()] = 0.25;
    const std::string words = inWords(compared({before}, {after}));
    EXPECT_THAT(words, HasSubstr("street                  better   position RMS cm 100 -> 25.0\n"));
    EXPECT_THAT(words, HasSubstr("WORSE    recall % 100 -> 50.0"));
    EXPECT_THAT(words, HasSubstr("recall % 0/1, position RMS cm 1/0"));
    EXPECT_THAT(words, Not(HasSubstr("changed")));
}

}  // namespace
}  // namespace vdamf
