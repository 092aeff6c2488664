// SPDX-License-Identifier: BSD-3-Clause
// Scenarios with other vehicles.
#include "regression/variation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using ::testing::Each;
using ::testing::Not;
using ::testing::StartsWith;

IniDocument scenario()
{
    return IniDocument::parse(
        "[platform]\nx_m = 5\ny_m = -1.75\n"
        "[object ahead]\nclass = hatchback\n"
        "[object bus]\nclass = bus\nlength_m = 18\n"
        "[object oak]\nclass = tree\n",
        "scene.ini");
}

double valueOf(const std::vector<std::string>& assignments, const std::string& key)
{
    for (const std::string& each : assignments)
        if (each.rfind(key + "=", 0) == 0) return parseNumber(each.substr(key.size() + 1)).value();
    return std::nan("");
}

TEST(RegressionVariation, VehiclesAreOfSizesOfTheirClass)
{
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        const auto varied = variationOf(scenario(), seed);
        const double length = valueOf(varied, "object ahead.length_m");
        EXPECT_NEAR(length, 4.1, 0.12 * 4.1 + 1e-3);
        EXPECT_NEAR(valueOf(varied, "object ahead.width_m"), 1.78, 0.08 * 1.78 + 1e-3);
        EXPECT_NEAR(valueOf(varied, "object bus.length_m"), 18.0, 0.12 * 18.0 + 1e-3);
        EXPECT_NEAR(valueOf(varied, "platform.x_m"), 5.0, 1.0);
        EXPECT_NEAR(valueOf(varied, "platform.y_m"), -1.75, 0.3);
        EXPECT_THAT(varied, Each(Not(StartsWith("object oak"))));
        sum += length;
        squares += length * length;
    }
    const double mean = sum / 200.0;
    EXPECT_NEAR(mean, 4.1, 0.06);
    EXPECT_NEAR(std::sqrt(squares / 200.0 - mean * mean), 0.06 * 4.1, 0.05);
}

TEST(RegressionVariation, SeedsRepeat)
{
    EXPECT_EQ(variationOf(scenario(), 3), variationOf(scenario(), 3));
    EXPECT_NE(variationOf(scenario(), 3), variationOf(scenario(), 4));
}

}  // namespace
}  // namespace vdamf
