// SPDX-License-Identifier: BSD-3-Clause
// What may stand behind a swept key, and the settings that come of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "files/temporary_folder.h"
#include "vdamf/experiments/optimise.h"
#include "vdamf/experiments/settings.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> valuesOf(const std::string& text)
{
    return parseSweptKey("section.key", text, 1).values;
}

std::string problemOf(const std::string& text)
{
    return errorOf([&] { parseSweptKey("section.key", text, 1); });
}

SweptKey keyOf(const std::string& name, const std::string& text)
{
    return parseSweptKey(name, text, 1);
}

TEST(SweptKey, ListsRangesAndLogRanges)
{
    EXPECT_THAT(valuesOf("0.10 : 0.05 : 0.30"), ElementsAre("0.1", "0.15", "0.2", "0.25", "0.3"));
    EXPECT_THAT(valuesOf("3 : -1 : 1"), ElementsAre("3", "2", "1"));
    EXPECT_THAT(valuesOf("0 : 0.4 : 1"), ElementsAre("0", "0.4", "0.8"));
    EXPECT_THAT(valuesOf("2 : 1 : 2"), ElementsAre("2"));
    EXPECT_THAT(valuesOf("log 0.01 : 1 : 5"), ElementsAre("0.01", "0.03162", "0.1", "0.3162", "1"));
    EXPECT_THAT(valuesOf("paper, face_lines"), ElementsAre("paper", "face_lines"));
    EXPECT_THAT(valuesOf("true"), ElementsAre("true"));
}

TEST(SweptKey, Intervals)
{
    const SweptKey linear = keyOf("a.b", "0.1 : 0.3");
    EXPECT_TRUE(linear.values.empty());
    EXPECT_EQ(valueAt(*linear.interval, 0.5), "0.2");
    EXPECT_EQ(valueAt(*linear.interval, 1.0), "0.3");
    const SweptKey logarithmic = keyOf("a.b", "log 0.01 : 1");
    EXPECT_EQ(valueAt(*logarithmic.interval, 0.5), "0.1");
}

TEST(SweptKey, WhatIsWrongIsToldInItsOwnWords)
{
    EXPECT_THAT(problemOf("0.3 : 0.05 : 0.1"), HasSubstr("the range is empty"));
    EXPECT_THAT(problemOf("0.1 : 0 : 0.3"), HasSubstr("the range is empty"));
    EXPECT_THAT(problemOf("0.3 : 0.3"), HasSubstr("the range is empty"));
    EXPECT_THAT(problemOf("log 0 : 1 : 5"), HasSubstr("must start above 0"));
    EXPECT_THAT(problemOf("log 1 : 2 : 1"), HasSubstr("count"));
    EXPECT_THAT(problemOf("log 1 : 2 : 2.5"), HasSubstr("count"));
    EXPECT_THAT(problemOf("0.1 : x : 3"), HasSubstr("expected a number, found 'x'"));
    EXPECT_THAT(problemOf("1 : 2 : 3 : 4"), HasSubstr("from : step : to"));
    EXPECT_THAT(problemOf("1, , 2"), HasSubstr("a value is missing"));
    EXPECT_THAT(problemOf(""), HasSubstr("a value is missing"));
    EXPECT_THAT(problemOf("1, 2, 1"), HasSubstr("'1' stands twice"));
    EXPECT_THAT(problemOf("0.2, 0.3, 2e-1"), HasSubstr("'0.2' and '2e-1' are the same number"));
    EXPECT_THAT(problemOf("0, -0"), HasSubstr("'0' and '-0' are the same number"));
    EXPECT_THAT(problemOf("0 : 1e-9 : 1"), HasSubstr("more than 10000 values"));
}

TEST(SweepSettings, AGridIsAllOfThem)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "1, 2"), keyOf("a.y", "1 : 1 : 3")};
    EXPECT_EQ(countOfSettings(keys), 6.0);
    const std::vector<SweepSetting> grid = gridSettings(keys);
    ASSERT_EQ(grid.size(), 6U);
    EXPECT_THAT(grid[0].values, ElementsAre("1", "1"));
    EXPECT_THAT(grid[1].values, ElementsAre("1", "2"));
    EXPECT_THAT(grid[5].values, ElementsAre("2", "3"));
    EXPECT_THAT(errorOf([] { gridSettings({keyOf("a.x", "0 : 1")}); }), HasSubstr("a.x"));
}

TEST(SweepSettings, DrawnOnesAreDifferentAndTheSameEveryTime)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "log 0.01 : 1"), keyOf("a.y", "1 : 1 : 3")};
    const std::vector<SweepSetting> drawn = randomSettings(keys, 200, 7);
    std::set<std::vector<std::string>> different;
    int small = 0;
    for (const SweepSetting& setting : drawn)
    {
        different.insert(setting.values);
        const double x = *parseNumber(setting.values[0]);
        EXPECT_GE(x, 0.01);
        EXPECT_LE(x, 1.0);
        small += x < 0.1 ? 1 : 0;
    }
    EXPECT_EQ(different.size(), 200U);
    EXPECT_NEAR(small, 100, 25);  // half of a log range lies below its middle
    EXPECT_EQ(randomSettings(keys, 3, 7)[2].values, drawn[2].values);
    EXPECT_NE(randomSettings(keys, 3, 8)[2].values, drawn[2].values);
}

TEST(SweepSettings, NoMoreAreDrawnThanThereAre)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "1, 2"), keyOf("a.y", "1 : 1 : 3")};
    EXPECT_EQ(randomSettings(keys, 6, 1).size(), 6U);
    EXPECT_THAT(errorOf([&] { randomSettings(keys, 7, 1); }), HasSubstr("only 6 settings"));
    const std::vector<SweptKey> narrow = {keyOf("a.x", "1 : 1.00001")};
    EXPECT_THAT(errorOf([&] { randomSettings(narrow, 7, 1); }), HasSubstr("too narrow"));
}

double valueOf(const SweepSetting& setting, std::size_t key)
{
    return *parseNumber(setting.values[key]);
}

TEST(OptimiseSettings, FindsTheTopOfAHill)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "0 : 10"), keyOf("a.y", "log 0.01 : 1")};
    for (const auto algorithm : {SweepOptimiser::Bobyqa, SweepOptimiser::NelderMead,
                                 SweepOptimiser::Subplex, SweepOptimiser::Direct})
    {
        double best = -1e9;
        std::size_t asked = 0;
        const auto hill = [&](const SweepSetting& setting) -> std::optional<double>
        {
            ++asked;
            const double x = valueOf(setting, 0) - 7.0;
            const double y = std::log(valueOf(setting, 1) / 0.05);
            best = std::max(best, -x * x - y * y);
            if (x < -6.0) return std::nullopt;  // fails in a corner
            return -x * x - y * y;
        };
        optimiseSettings(keys, algorithm, 80, hill);
        EXPECT_LE(asked, 80U);
        EXPECT_GT(best, -0.02) << static_cast<int>(algorithm);
    }
}

TEST(OptimiseSettings, StepsAreAskedForOnce)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "0 : 1 : 20")};
    std::set<std::string> asked;
    optimiseSettings(keys, SweepOptimiser::NelderMead, 15,
                     [&](const SweepSetting& setting)
                     {
                         EXPECT_TRUE(asked.insert(setting.values[0]).second);
                         return std::optional<double>(-std::abs(valueOf(setting, 0) - 16.0));
                     });
    EXPECT_EQ(asked.count("16"), 1U);
    EXPECT_LE(asked.size(), 15U);
}

TEST(OptimiseSettings, ErrorsOfARunComeThrough)
{
    const std::vector<SweptKey> keys = {keyOf("a.x", "0 : 1")};
    const auto broken = [](const SweepSetting&) -> std::optional<double>
    { throw std::runtime_error("the disk is full"); };
    EXPECT_EQ(errorOf([&] { optimiseSettings(keys, SweepOptimiser::NelderMead, 5, broken); }),
              "the disk is full");
}

TEST(OptimiseSettings, WordsCannotBeSearched)
{
    const auto check = [](const std::string& values, SweepOptimiser algorithm)
    { return errorOf([&] { checkSearchable({keyOf("a.x", values)}, algorithm); }); };
    EXPECT_THAT(check("paper, face_lines", SweepOptimiser::NelderMead), HasSubstr("a.x"));
    EXPECT_THAT(check("3, 1, 2", SweepOptimiser::NelderMead), HasSubstr("rising numbers"));
    EXPECT_THAT(check("0 : 1", SweepOptimiser::Bobyqa), HasSubstr("two keys"));
    EXPECT_EQ(check("1 : 1 : 5", SweepOptimiser::NelderMead), "(nothing thrown)");
}

}  // namespace
}  // namespace vdamf
