// SPDX-License-Identifier: BSD-3-Clause
// Trailers: the hitch holds, the axle does not slip, and steady circles are what geometry says.
#include "vdamf/simulation/towed_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "numerical_motion.h"
#include "vdamf/simulation/segments.h"

namespace vdamf
{
namespace
{
constexpr TowBar kBar{2.5, 6.0};

Trajectory truck()
{
    return Trajectory({3.0, -2.0, 0.4, 6.0, 0.0},
                      parseSegments("keep 1, turn -90 13, keep 1, speed_to 9 1, turn 60 20", 6.0));
}

TEST(TowedMotion, DoesNotSlip)
{
    const Trajectory trailer = towed(truck(), kBar, 14.0);
    for (double time = 0.02; time < 13.9; time += 0.0537) expectDerivativesAt(trailer, time, 2e-5);
    expectContinuousAt(trailer, 0.0);
    expectContinuousAt(trailer, 5.0);
}

TEST(TowedMotion, HangsOnTheHitch)
{
    const Trajectory vehicle = truck();
    const Trajectory trailer = towed(vehicle, kBar, 14.0);
    for (const double time : {-1.0, 0.0, 2.3, 5.0, 9.1, 14.0, 20.0})
    {
        const MotionState front = vehicle.at(time);
        const MotionState axle = trailer.at(time);
        EXPECT_NEAR(axle.x + 6.0 * std::cos(axle.heading), front.x - 2.5 * std::cos(front.heading),
                    1e-9);
        EXPECT_NEAR(axle.y + 6.0 * std::sin(axle.heading), front.y - 2.5 * std::sin(front.heading),
                    1e-9);
    }
}

TEST(TowedMotion, SettlesOnTheCircleOfTheHitchesTangent)
{
    // Hitch circle of radius sqrt(R^2 + b^2); the axle's circle is sqrt(R^2 + b^2 - d^2).
    const double radius = 15.0;
    const Trajectory vehicle({0.0, 0.0, 0.0, 5.0, 0.0}, {{100.0, 0.0, 1.0 / radius}});
    const MotionState axle = towed(vehicle, kBar, 60.0).at(55.0);
    const double expected = std::sqrt(radius * radius + 2.5 * 2.5 - 6.0 * 6.0);
    EXPECT_NEAR(std::hypot(axle.x, axle.y - radius), expected, 1e-6);
    EXPECT_NEAR(axle.yawRate, 5.0 / radius, 1e-7);
}

TEST(TowedMotion, StaysInLineBehindAStraightDrive)
{
    const Trajectory vehicle({0.0, 0.0, 0.5, 10.0, 0.0}, {});
    const MotionState axle = towed(vehicle, kBar, 10.0).at(7.0);
    EXPECT_NEAR(axle.heading, 0.5, 1e-15);
    EXPECT_NEAR(axle.speed, 10.0, 1e-12);
    EXPECT_NEAR(axle.yawRate, 0.0, 1e-15);
}
}  // namespace
}  // namespace vdamf
