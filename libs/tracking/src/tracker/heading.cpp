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
constexpr double kCourseSpeed = 0.75;    // m/s
// Log odds from which on a heading is changed: of young tracks and of others.
constexpr double kLikely = 1.0;
constexpr double kDecisive = 5.0;
constexpr int kYoung = 10;  // sightings

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

// What the sighting just taken in and the path that it ends tell of the front.
HeadingCues cuesOf(const Track& track)
{
    const Measurement& m = *track.measurement;
    HeadingCues cues;
    cues.widestEnd = widestEnd(track.height);
    if (locatesLength(m)) cues.length = m.box.length;
    if (locatesWidth(m)) cues.width = m.box.width;
    if (track.path.size() < 2) return cues;
    cues.dt = track.path.back().time - track.path[track.path.size() - 2].time;
    const Course course = courseOf(track);
    const bool moves = track.path.size() >= 3 && course.distance > kCourseDistance &&
                       course.distance > kCourseSpeed * course.duration &&
                       std::abs(track.state.mean(kSpeed)) >
                           3.0 * std::sqrt(track.state.covariance(kSpeed, kSpeed));
    if (moves)
        cues.course = {wrapAngle(course.direction - track.state.mean(kHeading)),
                       course.distance / course.duration};
    return cues;
}

// What was held for the length of a box across is no width: the far side is where a car has it.
Measurement narrowed(const Measurement& measurement, const Eigen::Vector2d& sensor,
                     double widestEnd, const VisibilityOptions& options)
{
    const double excess = measurement.box.width - options.carWidth;
    if (measurement.box.width < widestEnd) return measurement;
    Measurement m = measurement;
    const double near = nearestPoint(m.box, sensor).y() > 0.0 ? 1.0 : -1.0;
    const Eigen::Vector2d left = rotation(m.box.heading).col(1);
    m.box.x += 0.5 * near * excess * left.x();
    m.box.y += 0.5 * near * excess * left.y();
    m.box.width = options.carWidth;
    m.hiddenEnds.add(near > 0.0 ? Face::Right : Face::Left);
    return m;
}

// The track started anew with its measurement turned; it keeps its identity and history.
Track quarterTurned(const Track& track, const Sighting& sighting, int quarters,
                    const Course& course, const TrackerOptions& options)
{
    Sighting turned = sighting;
    turned.measurement = narrowed(turnedBy(*track.measurement, quarters), sighting.sensor,
                                  widestEnd(track.height), options.visibility);
    constexpr double kCourseTime = 0.3;   // s, from which on a path tells a speed
    constexpr double kCourseSigma = 1.0;  // m/s
    StartSpeed speed{0.0, options.lifecycle.startSpeedSigma};
    if (course.duration > kCourseTime)
        speed = {course.speedAlong(turned.measurement.box.heading), kCourseSigma};
    const Track fresh = startedTrack(track.id, turned, speed, options);
    Track next = track;
    next.state = fresh.state;
    next.measurement = fresh.measurement;
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
    Track next = track;
    next.front = track.front.after(cuesOf(track));
    const bool isNew = track.sightings < kYoung;
    const int quarters = next.front.turnDue(isNew ? kLikely : kDecisive);
    if (quarters == 0) return next;
    next.front = next.front.turned(quarters);
    if (quarters == 2) return reversed(next, options.motion);
    return quarterTurned(next, sighting, quarters, courseOf(track), options);
}

}  // namespace vdamf
