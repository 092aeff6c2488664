// SPDX-License-Identifier: BSD-3-Clause
// When a target is seen from elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/tracking/estimation/view.h"

namespace
{
using vdamf::changeOfView;
using vdamf::kPi;
using vdamf::OrientedBox;
using vdamf::View;
using vdamf::viewOf;

TEST(View, IsTheSensorsPlaceInTheTargetsFrame)
{
    const View view = viewOf({10.0, 5.0, 0.5 * kPi, 4.5, 1.8}, {10.0, -5.0});
    EXPECT_NEAR(std::abs(view.bearing), kPi, 1e-12);
    EXPECT_NEAR(view.range, 10.0, 1e-12);
}

TEST(View, StaysWhileACarIsFollowed)
{
    const View before = viewOf({20.0, 0.0, 0.0, 4.5, 1.8}, {0.0, 0.0});
    const View after = viewOf({35.0, 0.0, 0.0, 4.5, 1.8}, {15.0, 0.0});
    EXPECT_NEAR(changeOfView(before, after), 0.0, 1e-12);
}

TEST(View, IsAnotherOneAfterTheCarIsPassed)
{
    const OrientedBox parked{10.0, 3.0, 0.0, 4.5, 1.8};
    EXPECT_DOUBLE_EQ(changeOfView(viewOf(parked, {0.0, 0.0}), viewOf(parked, {15.0, 0.0})), 1.0);
    const double little = changeOfView(viewOf(parked, {0.0, 0.0}), viewOf(parked, {1.0, 0.0}));
    EXPECT_GT(little, 0.1);
    EXPECT_LT(little, 0.5);
}

TEST(View, ChangesAcrossTheSeamOfAnglesByLittle)
{
    EXPECT_LT(changeOfView({kPi - 0.01, 10.0}, {-kPi + 0.01, 10.0}), 0.05);
}

TEST(View, ChangesWithTheRangeEitherWay)
{
    EXPECT_NEAR(changeOfView({0.0, 10.0}, {0.0, 12.0}), changeOfView({0.0, 12.0}, {0.0, 10.0}),
                1e-12);
    EXPECT_GT(changeOfView({0.0, 10.0}, {0.0, 12.0}), 0.2);
}

TEST(View, OfASensorInTheCentreIsFinite)
{
    EXPECT_TRUE(std::isfinite(viewOf({1.0, 1.0, 0.0, 4.5, 1.8}, {1.0, 1.0}).range));
    EXPECT_GT(viewOf({1.0, 1.0, 0.0, 4.5, 1.8}, {1.0, 1.0}).range, 0.0);
}
}  // namespace
