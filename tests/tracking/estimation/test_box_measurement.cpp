// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/box_measurement.h"

#include <gtest/gtest.h>

#include "estimation/fixed_point.h"
#include "vdamf/tracking/estimation/vehicle_kalman_filter.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
// The front and the right side of a car whose rear is hidden, with an error by which it seems the
// wider the more it is turned to the right.
BoxMeasurement withoutRear()
{
    Measurement m;
    m.box = {10.0, 5.0, 0.3, 3.0, 1.9};
    for (const Face face : {Face::Front, Face::Right}) m.facesSeen.add(face);
    m.hiddenEnds.add(Face::Back);
    m.covariance.diagonal() << 0.01, 0.01, 0.02, 0.04, 0.04;
    m.covariance(2, 4) = m.covariance(4, 2) = -0.02;
    const VisibilityOptions options;
    const Eigen::Vector2d sensor(30.0, 0.0);
    return boxThrough(m, faceErrors(m, options), {4.5, 1.8}, sensor, options);
}

TEST(WithKnown, TurnsABoxAboutItsFixedPoint)
{
    const BoxMeasurement before = withoutRear();
    const BoxMeasurement after = withKnown(before, 4, 1.7, 0.01);
    ASSERT_GT(after.box(2), before.box(2) + 0.02);
    // A rear that nothing tells leaves the front as certain as it was.
    const Matrix5d at = covarianceAtFixedPoint(after);
    EXPECT_LT(at(0, 0), covarianceAtFixedPoint(before)(0, 0) + 1e-6);
    EXPECT_NEAR(at(0, 3), 0.0, 0.01);
    EXPECT_GT(at(3, 3), 5000.0);
}

TEST(WithKnown, TellsNothingOfALengthThatIsNotSeen)
{
    VehicleState standing;
    standing.mean << 10.0, 5.5, 0.2, 0.0, 0.0, 1.26, 4.5;
    standing.covariance.diagonal() << 0.01, 0.01, 0.001, 0.0, 0.0, 0.16, 1.0;
    standing.width = 1.7;
    standing.widthVariance = 0.01;
    VehicleKalmanFilter filter{MotionOptions()};
    EXPECT_NEAR(filter.update(standing, withoutRear()).mean(kLength), 4.5, 0.01);
}
}  // namespace
}  // namespace vdamf
