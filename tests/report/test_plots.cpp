// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/report/plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <pugixml.hpp>

#include "report/occurrences.h"

namespace vdamf
{
namespace
{
using testing::HasSubstr;
using testing::Not;

// The field of a chart: x from 64 to 464, y from 288 up to 34.
Chart unitChart(std::vector<Curve> curves)
{
    return {"Title",
            {"across", AxisScale::Linear, 0.0, 1.0},
            {"up", AxisScale::Linear, 0.0, 1.0},
            std::move(curves)};
}

bool isXml(const std::string& text)
{
    return static_cast<bool>(pugi::xml_document().load_string(text.c_str()));
}

TEST(Plots, PutsPointsInTheirPlace)
{
    const std::string svg =
        chartsSvg({unitChart({{"a line", CurveStyle::Line, {{0.0, 0.0}, {0.5, 1.0}, {1.0, 0.5}}},
                              {"dots", CurveStyle::Points, {{0.25, 0.5}}},
                              {"", CurveStyle::Dashed, {{0.0, 1.0}, {1.0, 1.0}}}})});
    EXPECT_TRUE(isXml(svg));
    EXPECT_THAT(svg, HasSubstr("M64.0 288.0L264.0 34.0L464.0 161.0"));
    EXPECT_THAT(svg, HasSubstr("M164.0 161.0h0"));
    EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(svg, HasSubstr(">Title<"));
    EXPECT_THAT(svg, HasSubstr(">across<"));
    EXPECT_THAT(svg, HasSubstr(">0.4<"));  // a mark
    EXPECT_THAT(svg, HasSubstr(">a line<"));
}

TEST(Plots, CurvesOfOneNumberHaveOneColour)
{
    const std::vector<Eigen::Vector2d> points = {{0.0, 0.0}, {1.0, 1.0}};
    const std::string svg = chartsSvg({unitChart({{"own", CurveStyle::Line, points},
                                                  {"first", CurveStyle::Line, points, 3},
                                                  {"again", CurveStyle::Dashed, points, 3}})});
    EXPECT_EQ(countOf(svg, "stroke=\"#0072b2\""), 2U);  // the curve and its line in the legend
    EXPECT_EQ(countOf(svg, "stroke=\"#cc79a7\""), 4U);
    EXPECT_EQ(countOf(svg, "stroke=\"#d55e00\""), 0U);
}

TEST(Plots, WhatAnAxisCannotShowInterruptsTheLine)
{
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const std::string svg = chartsSvg(
        {unitChart({{"", CurveStyle::Line, {{0.0, 0.0}, {0.5, kNan}, {0.5, 0.5}, {1.0, 1.0}}}})});
    EXPECT_THAT(svg, HasSubstr("M64.0 288.0M264.0 161.0L464.0 34.0"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    Chart logarithmic = unitChart({{"", CurveStyle::Line, {{0.0, 1.0}, {0.1, 1.0}, {10.0, 1.0}}}});
    logarithmic.x = {"log", AxisScale::Log10};
    const std::string log = chartsSvg({logarithmic});
    EXPECT_THAT(log, HasSubstr("M64.0 34.0L464.0 34.0"));
    EXPECT_THAT(log, HasSubstr(">0.1<"));
    EXPECT_THAT(log, HasSubstr(">10<"));
}

TEST(Plots, NormalDeviatesMakeGaussianErrorsAStraightLine)
{
    // Ends at -+1 standard deviation: a half falls on the middle.
    constexpr double kOne = 0.8413447460685429;
    Chart chart = unitChart({{"", CurveStyle::Points, {{0.5, 0.5}}}});
    chart.x = {"x", AxisScale::NormalDeviate, 1.0 - kOne, kOne};
    chart.y = chart.x;
    const std::string svg = chartsSvg({chart});
    EXPECT_THAT(svg, HasSubstr("M264.0 161.0h0"));
    EXPECT_THAT(svg, HasSubstr(">20<"));
    EXPECT_THAT(svg, Not(HasSubstr(">1<")));
}

TEST(Plots, OpenAxesHoldAllValues)
{
    Chart chart = unitChart({{"", CurveStyle::Line, {{3.1, -0.07}, {47.0, 0.12}}}});
    chart.x = {"x", AxisScale::Linear};
    chart.y = {"y", AxisScale::Linear};
    const std::string svg = chartsSvg({chart});
    EXPECT_THAT(svg, HasSubstr(">50<"));
    EXPECT_THAT(svg, HasSubstr(">0.15<"));
    EXPECT_THAT(svg, HasSubstr(">-0.10<"));
    // One value, and none at all.
    chart.curves = {{"", CurveStyle::Points, {{5.0, 0.0}}}};
    EXPECT_THAT(chartsSvg({chart}), Not(HasSubstr("nan")));
    chart.curves = {{"", CurveStyle::Points, {{0.2, 0.4}}}};
    EXPECT_THAT(chartsSvg({chart}), HasSubstr("M264.0 161.0")) << "in the middle";
    chart.curves = {{"nothing", CurveStyle::Line, {}}};
    EXPECT_THAT(chartsSvg({chart}), HasSubstr("nothing to show"));
    EXPECT_TRUE(isXml(chartsSvg({})));
}

TEST(Plots, LeavesOutWhatNobodySees)
{
    Curve curve;
    for (int i = 0; i <= 100000; ++i) curve.points.emplace_back(1e-5 * i, 0.5);
    const std::string svg = chartsSvg({unitChart({curve})});
    EXPECT_LT(svg.size(), 20000U);
    EXPECT_THAT(svg, HasSubstr("L464.0 161.0\""));
}

TEST(Plots, NamesAreEscaped)
{
    const std::string svg =
        chartsSvg({unitChart({{"a < b & c > d", CurveStyle::Line, {{0.0, 0.0}, {1.0, 1.0}}}})});
    EXPECT_TRUE(isXml(svg));
    EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c &gt; d"));
}

TEST(Plots, StandInRows)
{
    const std::vector<Chart> charts(3, unitChart({}));
    const std::string svg = chartsSvg(charts, 2);
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 960 680\""));
    EXPECT_THAT(svg, HasSubstr("translate(0.0 340.0)"));
}

TEST(CumulativeCurve, RisesToOne)
{
    const Curve curve = cumulativeCurve("errors", {-3.0, 1.0, 2.0, -1.0});
    ASSERT_EQ(curve.points.size(), 5U);
    EXPECT_EQ(curve.points[1], Eigen::Vector2d(1.0, 0.25));
    EXPECT_EQ(curve.points[4], Eigen::Vector2d(3.0, 1.0));
    EXPECT_TRUE(cumulativeCurve("none", {}).points.empty());
}

}  // namespace
}  // namespace vdamf
