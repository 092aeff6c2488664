// SPDX-License-Identifier: BSD-3-Clause
// Beam tables against the figures of the data sheets.
#include "vdamf/simulation/spinning_ladar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
double degrees(double angle)
{
    return angle * 180.0 / kPi;
}

struct Sheet
{
    LadarModel model;
    std::size_t lasers;
    double lowest;       ///< deg
    double highest;      ///< deg
    int firings;         ///< a revolution at 10 Hz
    double smallestGap;  ///< between neighbouring beams, deg
    double largestGap;
};

class Sheets : public testing::TestWithParam<Sheet>
{
};

TEST_P(Sheets, BeamsAreThoseOfTheDataSheet)
{
    const Sheet sheet = GetParam();
    SpinningLadar ladar = ladarOf(sheet.model);
    ASSERT_EQ(ladar.elevations.size(), sheet.lasers);
    ASSERT_EQ(ladar.laserDelays.size(), sheet.lasers);
    EXPECT_LT(*std::max_element(ladar.laserDelays.begin(), ladar.laserDelays.end()),
              ladar.firingPeriod);
    std::sort(ladar.elevations.begin(), ladar.elevations.end());
    EXPECT_NEAR(degrees(ladar.elevations.front()), sheet.lowest, 0.005);
    EXPECT_NEAR(degrees(ladar.elevations.back()), sheet.highest, 0.005);
    for (std::size_t i = 1; i < sheet.lasers; ++i)
    {
        const double gap = degrees(ladar.elevations[i] - ladar.elevations[i - 1]);
        EXPECT_GE(gap, sheet.smallestGap - 0.011);
        EXPECT_LE(gap, sheet.largestGap + 0.011);
    }
}

TEST_P(Sheets, RevolutionsAreWholePacketsAndFitTheirTime)
{
    const Sheet sheet = GetParam();
    const SpinningLadar ladar = ladarOf(sheet.model);
    EXPECT_EQ(ladar.firingsPerRevolution(10.0), sheet.firings);
    for (const double rate : {5.0, 7.3, 20.0})
    {
        const int firings = ladar.firingsPerRevolution(rate);
        EXPECT_EQ(firings % ladar.firingsPerPacket, 0);
        EXPECT_LE(firings * ladar.firingPeriod, 1.0 / rate);
        EXPECT_GT(firings * ladar.firingPeriod, 0.95 / rate);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Sheets,
    testing::Values(Sheet{LadarModel::VLP16, 16, -15, 15, 1800, 2, 2},
                    Sheet{LadarModel::HDL32E, 32, -30.67, 10.67, 2160, 1.33, 1.34},
                    Sheet{LadarModel::HDL64E, 64, -24.33, 2, 2082, 0.33, 0.5}));

TEST(SpinningLadar, OrderIsThatOfThePackets)
{
    const SpinningLadar vlp16 = ladarOf(LadarModel::VLP16);
    EXPECT_NEAR(degrees(vlp16.elevations[0]), -15.0, 1e-9);
    EXPECT_NEAR(degrees(vlp16.elevations[1]), 1.0, 1e-9);
    EXPECT_NEAR(degrees(vlp16.elevations[14]), -1.0, 1e-9);
    const SpinningLadar hdl32 = ladarOf(LadarModel::HDL32E);
    EXPECT_NEAR(degrees(hdl32.elevations[1]), -9.33, 1e-9);
    EXPECT_NEAR(degrees(hdl32.elevations[15]), 0.0, 1e-9);
    EXPECT_NEAR(degrees(hdl32.elevations[30]), -10.67, 1e-9);
}
}  // namespace
}  // namespace vdamf
