// SPDX-License-Identifier: BSD-3-Clause
#include "estimation/rest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
VehicleState parked(double heading)
{
    VehicleState state;
    state.mean << 10.0, 5.0, heading, 0.0, 0.0, 1.2, 4.5;
    state.covariance.diagonal() << 1e-3, 1e-3, 1e-4, 0.0, 0.0, 0.01, 0.02;
    return state;
}

VehicleState after(double seconds, double step, double heading)
{
    VehicleState state = parked(heading);
    for (int k = 0; k < std::lround(seconds / step); ++k)
        state = standingLater(state, step, MotionOptions());
    return state;
}

TEST(Rest, WhatStandsIsAsSureAtAnyRateOfFrames)
{
    const StateMatrix often = after(2.0, 0.05, 0.3).covariance;
    for (const double step : {0.1, 0.2, 0.5, 2.0})
        EXPECT_LT((after(2.0, step, 0.3).covariance - often).norm(), 1e-12) << step;
    EXPECT_GT(often(kX, kX), parked(0.0).covariance(kX, kX));
    EXPECT_LT(std::sqrt(often(kX, kX)), 0.07) << "m: it does not speed up";
}

TEST(Rest, WhatStandsIsAsSureWhereverItPoints)
{
    const StateMatrix east = after(2.0, 0.1, 0.0).covariance;
    for (const double heading : {0.8, 1.6, -2.4})
        EXPECT_EQ(after(2.0, 0.1, heading).covariance, east) << heading;
    EXPECT_EQ(east(kX, kX), east(kY, kY));
}

}  // namespace
}  // namespace vdamf
