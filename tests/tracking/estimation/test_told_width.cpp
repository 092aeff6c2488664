// SPDX-License-Identifier: BSD-3-Clause
// A width that becomes known moves the side that was not seen.
#include <gtest/gtest.h>

#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"

namespace vdamf
{
namespace
{
constexpr double kYaw = 0.4;
const Eigen::Vector2d kRightSide(0.0, -1.0);

VehicleState narrow()
{
    VehicleState state;
    state.mean << 10.0, 5.0, kYaw, 3.0, 0.0, 1.2, 4.5;
    state.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.1, 1e-4, 0.01, 0.01;
    state.width = 1.6;
    state.widthVariance = 0.09;
    return state;
}

Eigen::Vector2d rightSideOf(const OrientedBox& box)
{
    return box.centre() + 0.5 * box.width * (rotation(box.heading) * kRightSide);
}

TEST(ToldWidth, KeepsTheSideThatWasSeenInPlace)
{
    const VehicleState before = narrow();
    const Eigen::Vector2d side = rightSideOf(before.box());
    BoxMeasurement m;  // of the same side, 0.4 m wider
    m.fixedPoint = kRightSide;
    m.box << side - (rotation(kYaw) * kRightSide), kYaw, before.mean(kLength), 2.0;
    m.covariance.diagonal() << 1e-3, 1e-3, 1e-4, 0.01, 1e-3;
    const Eigen::Vector2d left = rotation(kYaw).col(1);
    // As what is observed is that side, the error of the width moves the centre along with it.
    m.covariance.topRightCorner<2, 1>() = 0.5 * m.covariance(4, 4) * left;
    m.covariance.bottomLeftCorner<1, 2>() = m.covariance.topRightCorner<2, 1>().transpose();
    m.covariance.topLeftCorner<2, 2>() += 0.25 * m.covariance(4, 4) * left * left.transpose();
    const VehicleState after = VehicleKalmanFilter(MotionOptions()).update(before, m);
    EXPECT_GT(after.width, 1.95);
    EXPECT_LT((rightSideOf(after.box()) - side).norm(), 1e-3);
}

}  // namespace
}  // namespace vdamf
