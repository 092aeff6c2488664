// SPDX-License-Identifier: BSD-3-Clause
// Which end is the front: from the way a track moves and from its shape.
#include <algorithm>
#include <cmath>

#include "tracker/track.h"

namespace vdamf
{
namespace
{
constexpr double kCourseDistance = 1.5;  // m: beyond what measurement noise could feign
constexpr double kForwardSpeed = 1.5;    // m/s
constexpr double kReverseSpeed = 4.0;    // m/s: nobody reverses faster on a road

// Straight displacement over the path kept.
struct Course
{
    double direction = 0.0;  // rad
    double distance = 0.0;   // m
    double duration = 0.0;   // s

    // Speed along a heading, m/s.
    double speedAlong(double heading) const
    {
        return duration > 0.0 ? distance / duration * std::cos(direction - heading) : 0.0;
    }
};

Course courseOf(const Track& track)
{
    const Eigen::Vector2d move = track.path.back().position - track.path.front().position;
    return {std::atan2(move.y(), move.x()), move.norm(),
            track.path.back().time - track.path.front().time};
}

// The path runs across the heading.
bool drivesAcross(const Track& track, const Course& course)
{
    if (track.path.size() < 5 || course.distance < kCourseDistance) return false;
    const double off = course.direction - track.state.mean(kHeading);
    return std::abs(std::sin(off)) > std::sin(kPi / 3.0) &&
           course.distance > kForwardSpeed * course.duration;
}

// What is held for an end is too wide for one.
bool endIsASide(const Track& track)
{
    const Measurement& m = *track.measurement;
    if (!locatesWidth(m)) return false;
    const double width = track.state.width;
    const bool tooWide = width > widestEnd(track.height);
    if (!locatesLength(m)) return tooWide;
    return width > 1.15 * track.state.mean(kLength) || (tooWide && m.box.width > m.box.length);
}

// The track started anew with its measurement turned; it keeps its identity and history.
Track quarterTurned(const Track& track, const Sighting& sighting, int quarters,
                    const Course& course, const TrackerOptions& options)
{
    Sighting turned = sighting;
    turned.measurement = turnedBy(*track.measurement, quarters);
    const Track fresh = startedTrack(track.id, turned, options);
    Track next = track;
    next.state = fresh.state;
    next.measurement = fresh.measurement;
    next.forwardSeen = false;
    constexpr double kCourseTime = 0.3;  // s, from which on a path tells a speed
    if (course.duration > kCourseTime)
    {
        next.state.mean(kSpeed) = course.speedAlong(next.state.mean(kHeading));
        next.state.covariance(kSpeed, kSpeed) = 1.0;
    }
    next.hypotheses = hypothesesFrom(next.state);
    return next;
}

// Front and rear exchanged. The path of the axis point stays what it is: speed and curvature
// change sign. Its offset would as well, but nobody's axle lies that far in front: what is known
// of it gives way to the prior.
VehicleState reversed(const VehicleState& state, const MotionOptions& motion)
{
    StateVector sign = StateVector::Ones();
    sign(kSpeed) = sign(kCurvature) = -1.0;
    VehicleState next = state;
    next.mean = sign.cwiseProduct(state.mean);
    next.mean(kHeading) = wrapAngle(state.mean(kHeading) + kPi);
    next.mean(kAxis) = motion.axisFraction * state.mean(kLength);
    next.covariance = sign.asDiagonal() * state.covariance * sign.asDiagonal();
    next.covariance.row(kAxis).setZero();
    next.covariance.col(kAxis).setZero();
    next.covariance(kAxis, kAxis) = std::pow(motion.axisFractionSigma * state.mean(kLength), 2);
    return next;
}

Track reversed(const Track& track, const MotionOptions& motion)
{
    Track next = track;
    next.hypotheses.moving = reversed(track.hypotheses.moving, motion);
    next.hypotheses.standing = reversed(track.hypotheses.standing, motion);
    next.state = next.hypotheses.combined();
    next.measurement = alignedWith(*track.measurement, next.state.mean(kHeading));
    return next;
}
}  // namespace

Track withCheckedHeading(const Track& track, const Sighting& sighting,
                         const TrackerOptions& options)
{
    const Course course = courseOf(track);
    if (drivesAcross(track, course))
    {
        const double off = wrapAngle(course.direction - track.state.mean(kHeading));
        return quarterTurned(track, sighting, off > 0.0 ? 1 : -1, course, options);
    }
    if (endIsASide(track)) return quarterTurned(track, sighting, 1, course, options);

    Track next = track;
    const double speed = track.state.mean(kSpeed);
    const bool moves = std::abs(speed) > 3.0 * std::sqrt(track.state.covariance(kSpeed, kSpeed)) &&
                       course.distance > kCourseDistance;
    if (moves && speed > kForwardSpeed) next.forwardSeen = true;
    const double limit = track.forwardSeen ? kReverseSpeed : 0.5 * kForwardSpeed;
    if (moves && speed < -limit) return reversed(next, options.motion);
    return next;
}

}  // namespace vdamf
