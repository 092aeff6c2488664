// SPDX-License-Identifier: BSD-3-Clause
// Which motion models a calm driver makes steadier.
#include <gtest/gtest.h>

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

namespace vdamf
{
namespace
{
TEST(VehicleKalmanFilter, CalmIsNothingToWhatMovesFreely)
{
    VehicleKalmanFilter filter{MotionOptions{}};
    VehicleState state;
    state.mean << 0.0, 0.0, 0.3, 5.0, 1.0, 0.0, 4.5;
    state.covariance = StateMatrix::Identity() * 0.1;
    const VehicleState free = independentOf(state);
    const VehicleState usual = filter.predict(free, 1.0);
    const VehicleState calm = filter.predict(free, 1.0, 0.5);
    EXPECT_EQ(calm.mean, usual.mean);
    EXPECT_EQ(calm.covariance, usual.covariance);
}
}  // namespace
}  // namespace vdamf
