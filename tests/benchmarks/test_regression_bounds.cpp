// SPDX-License-Identifier: BSD-3-Clause
// Bounds on the numbers of scenarios.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression_rows.h"
#include "files/temporary_folder.h"
#include "regression/bounds.h"
#include "regression/catalogue.h"

namespace vdamf
{
namespace
{
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RegressionBounds : public TemporaryFolder
{
protected:
    std::vector<Bound> bounds(const std::string& rows) const
    {
        return readBounds(make("bounds.csv", "scenario,metric,min,max\n" + rows));
    }
};

TEST_F(RegressionBounds, HoldOnBothSides)
{
    const std::vector<Bound> both = bounds("street,recall,0.4,0.6\n");
    EXPECT_THAT(violations(both, {regressionRow("street", 0.4)}), IsEmpty());
    EXPECT_THAT(violations(both, {regressionRow("street", 0.6)}), IsEmpty());
    EXPECT_THAT(violations(both, {regressionRow("street", 0.39)}),
                ElementsAre("street: recall 0.3900 is below 0.4"));
    EXPECT_THAT(violations(both, {regressionRow("street", 0.61)}),
                ElementsAre("street: recall 0.6100 is above 0.6"));
}

TEST_F(RegressionBounds, ConcernTheirScenarioAlone)
{
    const std::vector<Bound> one = bounds("street,flips,,3\n");
    EXPECT_THAT(violations(one, {regressionRow("dense", 9.0)}), IsEmpty());
    EXPECT_THAT(violations(one, {regressionRow("street", 2.0), regressionRow("dense", 9.0)}),
                IsEmpty());
}

TEST_F(RegressionBounds, WhatIsNotKnownIsNoSuccess)
{
    RegressionRow row = regressionRow("street", 0.0);
    row.values[metricIndex("flips").value()].reset();
    EXPECT_THAT(violations(bounds("street,flips,,3\n"), {row}),
                ElementsAre("street: flips is not known, but has a bound"));
}

TEST_F(RegressionBounds, BadTablesNameTheirLine)
{
    const auto error = [&](const std::string& rows)
    { return errorOf([&] { bounds("street,recall,0.4,\n" + rows); }); };
    EXPECT_THAT(error("street,recal,0.4,\n"), HasSubstr("bounds.csv:3"));
    EXPECT_THAT(error("street,recal,0.4,\n"), HasSubstr("'recal' is no metric"));
    EXPECT_THAT(error("street,hota,,\n"), HasSubstr("neither min nor max"));
    EXPECT_THAT(error("street,hota,0.5,0.4\n"), HasSubstr("above max"));
    EXPECT_THAT(error("street,recall,,0.9\n"), HasSubstr("in a line above"));
}

// A bound with a misspelt scenario would hold for ever.
// Recordings lie outside the project: their names are known only where the data is.
bool isRecording(const std::string& scenario)
{
    return scenario.rfind("kitti_", 0) == 0 || scenario.rfind("argoverse_", 0) == 0;
}

TEST_F(RegressionBounds, ThoseOfTheProjectAreOfItsScenarios)
{
    const std::string source = VDAMF_SOURCE_DIR;
    const Catalogue catalogue = catalogueOf(source + "/datasets", "");
    std::vector<std::string> names;
    std::size_t fast = 0;
    for (const RegressionScenario& scenario : catalogue.scenarios)
    {
        names.push_back(scenario.name);
        if (scenario.fast) ++fast;
    }
    EXPECT_EQ(fast, 7U);
    const auto all = readBounds(source + "/benchmarks/regression/bounds.csv");
    EXPECT_FALSE(all.empty());
    for (const Bound& bound : all)
    {
        if (isRecording(bound.scenario)) continue;
        EXPECT_THAT(names, ::testing::Contains(bound.scenario));
    }
}

}  // namespace
}  // namespace vdamf
