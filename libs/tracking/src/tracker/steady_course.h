// SPDX-License-Identifier: BSD-3-Clause
// Which way a track has gone of late, by its path alone.
#pragma once

#include <optional>

#include "tracker/track.h"

namespace vdamf
{
constexpr double kCourseDistance = 1.5;  ///< m: beyond what measurement noise could feign

/// Straight displacement over some of the path.
struct Course
{
    double direction = 0.0;  ///< rad
    double distance = 0.0;   ///< m
    double duration = 0.0;   ///< s

    /// Speed along a heading, m/s.
    double speedAlong(double heading) const
    {
        return duration > 0.0 ? distance / duration * directionOf(direction - heading).cos : 0.0;
    }
};

/// The course of a track that goes on steadily, over the last second, less if it is fast and more
/// if it is slow, as long as it takes to tell: both halves of the path lead the same way.
std::optional<Course> steadyCourse(const Track& track);

}  // namespace vdamf
