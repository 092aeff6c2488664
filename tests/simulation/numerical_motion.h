// SPDX-License-Identifier: BSD-3-Clause
// Any motion against numerical differentiation of its poses.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/simulation/trajectory.h"

namespace vdamf
{
/// Heading rate is the yaw rate; velocity is the speed along the heading. Central differences, so
/// the times must be at least `h` away from jumps of acceleration.
inline void expectDerivativesAt(const Trajectory& motion, double time, double tolerance = 1e-6)
{
    const double h = 1e-5;
    const MotionState before = motion.at(time - h);
    const MotionState after = motion.at(time + h);
    const MotionState state = motion.at(time);
    EXPECT_NEAR((after.heading - before.heading) / (2.0 * h), state.yawRate, tolerance) << time;
    EXPECT_NEAR((after.x - before.x) / (2.0 * h), state.speed * std::cos(state.heading), tolerance)
        << time;
    EXPECT_NEAR((after.y - before.y) / (2.0 * h), state.speed * std::sin(state.heading), tolerance)
        << time;
}

/// Pose, speed and (where `yawRate` says so) yaw rate do not jump.
inline void expectContinuousAt(const Trajectory& motion, double time, bool yawRate = true)
{
    const double h = 1e-9;
    const MotionState before = motion.at(time - h);
    const MotionState after = motion.at(time + h);
    EXPECT_NEAR(before.x, after.x, 1e-6) << time;
    EXPECT_NEAR(before.y, after.y, 1e-6) << time;
    EXPECT_NEAR(before.heading, after.heading, 1e-6) << time;
    EXPECT_NEAR(before.speed, after.speed, 1e-6) << time;
    if (!yawRate) return;
    EXPECT_NEAR(before.yawRate, after.yawRate, 1e-6) << time;
}
}  // namespace vdamf
