// SPDX-License-Identifier: BSD-3-Clause
// Steadier than traffic or not, by how well a vehicle is foretold.
#include "vdamf/tracking/estimation/unrest.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
Unrest measured(Unrest unrest, double surprise, double dt, int count)
{
    for (int k = 0; k < count; ++k) unrest = unrest.later(dt).after(surprise);
    return unrest;
}

TEST(Unrest, FollowsTheMeanSurprise)
{
    EXPECT_DOUBLE_EQ(Unrest().value(), 1.0);
    EXPECT_NEAR(measured({}, 0.2, 0.1, 200).value(), 0.2, 1e-3);
    EXPECT_NEAR(measured({}, 2.0, 0.1, 200).value(), 2.0, 1e-3);
}

TEST(Unrest, IsTheSameForSensorsOfAnyRate)
{
    EXPECT_NEAR(measured({}, 0.2, 0.1, 20).value(), measured({}, 0.2, 0.04, 50).value(), 1e-9);
}

TEST(Unrest, CalmsWhatIsForetoldBetterThanTrafficIs)
{
    EXPECT_DOUBLE_EQ(Unrest().calm(), 1.0);
    EXPECT_DOUBLE_EQ(measured({}, 0.5, 0.1, 200).calm(), 1.0);
    EXPECT_LT(measured({}, 0.2, 0.1, 200).calm(), 0.3);
    EXPECT_GT(measured({}, 0.0, 0.1, 500).calm(), 0.01) << "anyone may brake";
}

TEST(Unrest, SurprisesWakeAtOnce)
{
    const Unrest steady = measured({}, 0.1, 0.1, 200);
    ASSERT_LT(steady.calm(), 0.1);
    EXPECT_DOUBLE_EQ(measured(steady, 100.0, 0.1, 2).calm(), 1.0);
    EXPECT_LT(measured(steady, 100.0, 0.1, 2).value(), 1.0) << "no more than they tell";
}

TEST(Unrest, IsNotKnownOfWhatIsHidden)
{
    const Unrest steady = measured({}, 0.1, 0.1, 200);
    Unrest hidden = steady;
    for (int k = 0; k < 20; ++k) hidden = hidden.later(0.1);
    EXPECT_GT(hidden.value(), 0.6);
    EXPECT_GT(hidden.later(20.0).value(), 0.99);
    // What passed unseen counts as the measurement that ends it says.
    EXPECT_NEAR(hidden.after(0.1).value(), 0.1, 0.01);
}

}  // namespace
}  // namespace vdamf
