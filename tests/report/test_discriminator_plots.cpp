// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the discriminator: well-formed, one cell a weight, the right colour.
#include "vdamf/report/discriminator_plots.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <string>

#include "report/occurrences.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
TEST(WeightsPicture, HasACellForEachWeightBlueForAndRedAgainst)
{
    DiscriminatorModel model = untrainedModel();
    model.weights[model.grid.index(2, 3, 4)] = 0.5;
    model.weights[model.grid.index(5, 1, 7)] = -0.5;
    const std::string svg = weightsSvg(model);
    EXPECT_TRUE(pugi::xml_document().load_string(svg.c_str()));
    EXPECT_EQ(countOf(svg, "fill=\"rgb("), model.grid.cells());
    EXPECT_EQ(countOf(svg, "fill=\"rgb(33,102,171)"), 1U);
    EXPECT_EQ(countOf(svg, "fill=\"rgb(179,23,43)"), 1U);
    EXPECT_EQ(countOf(svg, "fill=\"rgb(255,255,255)"), model.grid.cells() - 2);
    EXPECT_EQ(countOf(svg, "above ground"), static_cast<std::size_t>(model.grid.z.cells));
}

TEST(CellsPicture, OfNothingIsWhite)
{
    const DiscriminationGrid grid;
    const std::string svg = cellsSvg(grid, std::vector<double>(grid.cells(), 0.0), "none");
    EXPECT_EQ(countOf(svg, "fill=\"rgb(255,255,255)"), grid.cells());
}

TEST(DiscriminatorCharts, AreWellFormedWithAndWithoutBands)
{
    std::vector<ClassifierSample> samples;
    for (std::uint64_t i = 0; i < 200; ++i)
        samples.push_back({i, static_cast<double>(i % 17) / 17.0, i % 3 == 0});
    RocOptions without;
    without.replicates = 0;
    const std::vector<NamedRoc> curves = {{"a", *rocOf(samples)}, {"b", *rocOf(samples, without)}};
    const std::string svg = chartsSvg(
        {rocChart(curves), detChart(curves), reliabilityChart({{"a", reliabilityOf(samples)}})});
    EXPECT_TRUE(pugi::xml_document().load_string(svg.c_str()));
    EXPECT_EQ(countOf(svg, "a, 95 %"), 2U);
    EXPECT_EQ(countOf(svg, "b, 95 %"), 0U);
}

TEST(DiscriminatorCharts, DrawABandInTheColourOfItsCurve)
{
    std::vector<ClassifierSample> samples;
    for (std::uint64_t i = 0; i < 200; ++i)
        samples.push_back({i, static_cast<double>(i % 17) / 17.0, i % 3 == 0});
    const std::vector<NamedRoc> curves = {{"a", *rocOf(samples)}, {"b", *rocOf(samples)}};
    for (const Chart& chart : {rocChart(curves), detChart(curves)})
    {
        ASSERT_GE(chart.curves.size(), 4U);
        EXPECT_EQ(chart.curves[0].colour, chart.curves[1].colour);
        EXPECT_EQ(chart.curves[2].colour, chart.curves[3].colour);
        EXPECT_NE(chart.curves[0].colour, chart.curves[2].colour);
    }
}
}  // namespace
}  // namespace vdamf
