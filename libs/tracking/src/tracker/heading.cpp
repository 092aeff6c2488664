// SPDX-License-Identifier: BSD-3-Clause
// Which end is the front: from the way a track moves.
#include <algorithm>
#include <cmath>

#include "tracker/track.h"

namespace vdamf
{
namespace
{
// Straight displacement over the path kept; nothing while it is too short to tell a course.
struct Course
{
    double direction = 0.0;  // rad
    double distance = 0.0;   // m
    double duration = 0.0;   // s
};

Course courseOf(const Track& track)
{
    if (track.path.size() < 2) return {};
    const Eigen::Vector2d move = track.path.back().position - track.path.front().position;
    return {std::atan2(move.y(), move.x()), move.norm(),
            track.path.back().time - track.path.front().time};
}

// The track turned by a quarter, its length and width exchanged.
Track quarterTurned(const Track& track, double heading, const TrackerOptions& options)
{
    Track turned = track;
    std::swap(turned.size.length, turned.size.width);
    const Course course = courseOf(track);
    turned.state.mean(kHeading) = wrapAngle(heading);
    turned.state.mean(kSpeed) = course.distance / std::max(course.duration, 1e-3);
    turned.state.mean(kCurvature) = 0.0;
    turned.state.mean(kAxis) = options.motion.axisFraction * turned.size.length.mean;
    // What was learned of speed and steering belonged to the wrong axis.
    const double heading2 = track.state.covariance(kHeading, kHeading);
    const Eigen::Matrix2d position = track.state.covariance.topLeftCorner<2, 2>();
    turned.state.covariance.setZero();
    turned.state.covariance.topLeftCorner<2, 2>() = position;
    turned.state.covariance(kHeading, kHeading) = heading2;
    turned.state.covariance(kSpeed, kSpeed) = 1.0;
    turned.state.covariance(kCurvature, kCurvature) = 0.05 * 0.05;
    turned.state.covariance(kAxis, kAxis) =
        std::pow(options.motion.axisFractionSigma * turned.size.length.mean, 2);
    turned.measurement.reset();
    return turned;
}
}  // namespace

Track reversedTrack(const Track& track)
{
    Track reversed = track;
    Vector6d& x = reversed.state.mean;
    x(kHeading) = wrapAngle(x(kHeading) + kPi);
    // The axis point's path stays what it is: speed, curvature and offset change sign.
    Vector6d sign;
    sign << 1.0, 1.0, 1.0, -1.0, -1.0, -1.0;
    x(kSpeed) = -x(kSpeed);
    x(kCurvature) = -x(kCurvature);
    x(kAxis) = -x(kAxis);
    reversed.state.covariance = sign.asDiagonal() * track.state.covariance * sign.asDiagonal();
    if (track.measurement)
        reversed.measurement = alignedWith(*track.measurement, x(kHeading));
    return reversed;
}

Track headedAlongPath(const Track& track, const TrackerOptions& options)
{
    constexpr double kCourseDistance = 1.5;  // m: beyond what measurement noise could feign
    constexpr double kForwardSpeed = 1.5;    // m/s
    constexpr double kReverseSpeed = 4.0;    // m/s: nobody reverses faster on a road
    Track next = track;
    const Course course = courseOf(track);
    const double speed = track.state.mean(kSpeed);
    const double sigma = std::sqrt(track.state.covariance(kSpeed, kSpeed));
    if (course.distance > kCourseDistance && track.path.size() >= 5 && course.duration > 0.0)
    {
        const double off = wrapAngle(course.direction - track.state.mean(kHeading));
        const bool across = std::abs(std::sin(off)) > std::sin(kPi / 3.0);
        if (across && course.distance / course.duration > kForwardSpeed)
            return quarterTurned(track, track.state.mean(kHeading) + (off > 0.0 ? 0.5 : -0.5) * kPi,
                                 options);
    }
    if (speed > kForwardSpeed && speed > 3.0 * sigma && course.distance > kCourseDistance)
        next.forwardSeen = true;
    const double limit = next.forwardSeen ? kReverseSpeed : 0.5 * kForwardSpeed;
    if (speed < -limit && speed < -3.0 * sigma &&
        (course.distance > kCourseDistance || next.forwardSeen))
    {
        next = reversedTrack(next);
        const double length = next.size.length.mean;
        next.state.mean(kAxis) = options.motion.axisFraction * length;
        next.state.covariance.row(kAxis).setZero();
        next.state.covariance.col(kAxis).setZero();
        next.state.covariance(kAxis, kAxis) = std::pow(options.motion.axisFractionSigma * length, 2);
    }
    return next;
}

}  // namespace vdamf
