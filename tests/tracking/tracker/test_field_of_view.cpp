// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/field_of_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
// Ground hits from one bearing to another (rad), every 0.2 degrees.
LadarFrame lookingFrom(double first, double last)
{
    LadarFrame frame;
    for (double bearing = first; bearing <= last; bearing += 0.0035)
    {
        frame.points.x.push_back(static_cast<float>(8.0 * std::cos(bearing)));
        frame.points.y.push_back(static_cast<float>(8.0 * std::sin(bearing)));
        frame.points.z.push_back(0.0F);
    }
    return frame;
}

TEST(FieldOfView, EndsWhereTheHitsEnd)
{
    const FieldOfView view(lookingFrom(-1.0, 0.53));
    EXPECT_TRUE(view.has(-0.99));
    EXPECT_FALSE(view.has(-1.01));
    EXPECT_TRUE(view.has(0.0));
    EXPECT_TRUE(view.has(0.52 + 2.0 * kPi));
    EXPECT_FALSE(view.has(0.54));
    EXPECT_FALSE(view.has(kPi));
}

TEST(FieldOfView, GoesRoundAllBearings)
{
    const FieldOfView view(lookingFrom(-kPi, kPi));
    for (double bearing = -kPi; bearing < kPi; bearing += 0.01) ASSERT_TRUE(view.has(bearing));
}

TEST(FieldOfView, WhatIsOutsideOfItIsHidden)
{
    RangeProfile open;
    open.nearest.assign(720, 50.0F);
    const RangeProfile profile = withinView(open, FieldOfView(lookingFrom(-1.0, 1.0)));
    EXPECT_EQ(profile.at(0.0), 50.0);
    EXPECT_EQ(profile.at(0.99), 50.0);
    EXPECT_EQ(profile.at(1.02), 0.0);
    EXPECT_EQ(profile.at(-2.0), 0.0);
}

TEST(FieldOfView, HitsBeyondAllRangesTellNothing)
{
    LadarFrame frame;
    for (const float far : {3e38F, -3e38F})
    {
        frame.points.x.push_back(far);
        frame.points.y.push_back(far);
        frame.points.z.push_back(0.0F);
    }
    const FieldOfView view(frame);
    for (double bearing = -kPi; bearing < kPi; bearing += 0.1) EXPECT_FALSE(view.has(bearing));
}
}  // namespace
}  // namespace vdamf
