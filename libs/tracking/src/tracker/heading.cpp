// SPDX-License-Identifier: BSD-3-Clause
// Which end is the front: from the way a track moves and from its shape.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/rest.h"
#include "tracker/front_by_axle.h"
#include "tracker/neighbourhood.h"
#include "tracker/steady_course.h"
#include "tracker/track.h"

namespace vdamf
{
namespace
{
// Log odds from which on length and width are exchanged, of young tracks (and for what lasts) and
// of others, and front and rear, but where the shape of young ones tells them.
constexpr double kLikely = 0.5;
constexpr double kDecisive = 3.0;
constexpr double kLikelyFront = 2.5;
constexpr int kYoung = 10;    // sightings
constexpr int kLasting = 10;  // of them

// Log odds, by the shape, for a front held so far clockwise from where the measured heading points.
double shapeCue(const Sighting& sighting, double turned)
{
    constexpr double kAlong = 0.7;  // cosine
    const double cosine = std::cos(turned);
    return std::abs(cosine) < kAlong ? 0.0 : std::copysign(1.0, cosine) * sighting.front;
}

// What the sighting just taken in and the path that it ends tell of the front.
HeadingCues cuesOf(const Track& track, const Sighting& sighting, const MotionOptions& motion)
{
    HeadingCues cues = sizeCues(sighting, *track.measurement, track.height);
    const double turned = sighting.measurement.box.heading - track.state.mean(kHeading);
    cues.shape = track.judgement.probability * shapeCue(sighting, turned);
    const double speed = track.state.mean(kSpeed);
    const double spread = std::sqrt(2.0 * track.state.covariance(kSpeed, kSpeed));
    if (spread > 0.0)
    {
        cues.forth = 0.5 * std::erfc(-speed / spread);
        cues.fast = 0.5 * std::erfc((kReverseSpeed - std::abs(speed)) / spread);
    }
    if (!track.stands()) cues.axle = track.judgement.probability * frontByAxle(track.path, motion);
    if (track.path.size() < 2) return cues;
    cues.dt = track.path.back().time - track.path[track.path.size() - 2].time;
    if (const auto course = steadyCourse(track))
        cues.course = {wrapAngle(course->direction - track.state.mean(kHeading)),
                       course->distance / course->duration};
    return cues;
}

// Whether the vehicles around may change what is held of the front: not where it is sure whatever
// they tell.
bool mayLearnFromOthers(const HeadingBelief& front, HeadingCues cues)
{
    constexpr double kSurely = 0.99;  // probability
    cues.neighbours = -Neighbourhood::kMostEvidence;
    cues.inLine = -Neighbourhood::kMostOfFront;
    const HeadingBelief after = front.after(cues);
    return after.axesProbability() < kSurely || after.forwardProbability() < kSurely;
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

Measurement quarterTurned(const Track& track, int quarters, const Eigen::Vector2d& sensor,
                          const VisibilityOptions& options)
{
    return narrowed(turnedBy(*track.measurement, quarters), sensor, widestEnd(track.height),
                    options);
}

// The same path of a box turned by quarters.
std::vector<PathPoint> turned(std::vector<PathPoint> path, int quarters)
{
    for (PathPoint& point : path)
    {
        Measurement m;
        m.box = point.box;
        m.facesSeen = point.located;
        m = turnedBy(m, quarters);
        point.box = m.box;
        point.located = m.facesSeen;
    }
    return path;
}

// The track started anew with its measurement turned; it keeps its identity and history. Where its
// path does not tell its speed, it is confirmed anew as well.
Track quarterTurned(const Track& track, const Sighting& sighting, int quarters,
                    const TrackerOptions& options)
{
    Sighting turned = sighting;
    turned.measurement = quarterTurned(track, quarters, sighting.sensor, options.visibility);
    constexpr double kPathSigma = 0.4;  // m, of the ends of a path
    StartSpeed speed{0.0, options.lifecycle.startSpeedSigma};
    const auto course = steadyCourse(track);
    if (course)
        speed = {course->speedAlong(turned.measurement.box.heading),
                 std::max(1.0, kPathSigma / course->duration)};
    const Track fresh = startedTrack(track.id, turned, speed, options);
    Track next = track;
    next.state = fresh.state;
    next.measurement = fresh.measurement;
    next.told = fresh.told;
    next.errors = fresh.errors;
    next.jitter = fresh.jitter;
    next.lastingError = fresh.lastingError;
    next.busRears = fresh.busRears;
    next.around = fresh.around;
    next.assumedLength = fresh.assumedLength;
    *next.hypotheses = hypothesesFrom(next.state, options.motion);
    next.startedAt = track.sightings;
    if (course)
        next.hypotheses->standingProbability = restProbability(next.state);
    else
        next.status = TrackStatus::Tentative;
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
    for (VehicleState& state : next.hypotheses->driving) state = reversed(state, motion);
    next.hypotheses->standing = reversed(track.hypotheses->standing, motion);
    next.hypotheses->free.mean(kHeading) = wrapAngle(track.hypotheses->free.mean(kHeading) + kPi);
    next.state = next.hypotheses->combined(motion);
    next.measurement = alignedWith(*track.measurement, next.state.mean(kHeading));
    next.errors.fixedPoint = -track.errors.fixedPoint;
    next.busRears = 0;
    next.around.x = -track.around.x;
    next.around.y = -track.around.y;
    return next;
}

int dueTurn(const Track& track)
{
    const bool isNew = track.sightings < kYoung;
    const bool isLikelyEnough = isNew || track.front.acrossFor() >= kLasting;
    const int quarters = track.front.turnDue(isLikelyEnough ? kLikely : kDecisive);
    if (quarters % 2 == 1) return quarters;
    const bool isShown = isNew && track.front.forwardProbabilityByShape() < 0.5;
    return track.front.turnDue(isShown ? kLikely : kLikelyFront) == 2 ? 2 : 0;
}

// Of two ways to turn by a quarter, which sizes cannot tell apart, the one that the path leads to.
int towardsPath(const Track& track, int quarters)
{
    const Eigen::Vector2d moved = track.path.back().box.centre() - track.path.front().box.centre();
    const double heading = track.state.mean(kHeading) + 0.5 * kPi * quarters;
    const double forth = rotation(heading).col(0).dot(moved);
    return forth < -kCourseDistance ? (quarters + 2) % 4 : quarters;
}
}  // namespace

HeadingCues sizeCues(const Sighting& sighting, const Measurement& m, double height)
{
    // Rows of few hits break off before the face ends.
    constexpr double kFewHits = 30.0;
    // What lies beside or close behind an end seems to hide more of it.
    constexpr double kStillWhole = 0.25;
    // What is longer is no end, even where the fit sees none there.
    constexpr double kNoEnd = 3.0;  // m
    constexpr double kSomeHits = 10.0;
    constexpr double kRoof = 0.2;  // m: roofs are bent
    // Rows along faces that may as well lie otherwise tell nothing.
    constexpr double kVague = 0.2;  // rad
    const auto extentOf = [&](const FaceRow& row, bool isWhole)
    {
        return FaceExtent{row.metres,
                          (isWhole ? 1.0 : kStillWhole) * row.hits / (row.hits + kFewHits),
                          sighting.isCut};
    };
    HeadingCues cues;
    cues.height = height;
    cues.isHeightSeen = sighting.isRoofSeen && sighting.height > height - kRoof;
    if (m.covariance(2, 2) > kVague * kVague) return cues;
    if (m.facesSeen.seesSide()) cues.side = extentOf(sighting.side, locatesLength(m));
    const bool isNoEnd = sighting.end.metres > kNoEnd && sighting.end.hits > kSomeHits;
    if (m.facesSeen.seesEnd() || isNoEnd)
        cues.end = extentOf(sighting.end, m.facesSeen.seesEnd() && locatesWidth(m));
    return cues;
}

Track withCheckedHeading(Track track, const Sighting& sighting, const Neighbourhood& around,
                         const TrackerOptions& options)
{
    HeadingCues cues = cuesOf(track, sighting, options.motion);
    if (mayLearnFromOthers(track.front, cues))
    {
        const OrientedBox& box = track.measurement->box;
        cues.neighbours = around.axesEvidence(box, track.id) +
                          placeTaken(quarterTurned(track, 1, sighting.sensor, options.visibility),
                                     track.height, sighting.sensor, around, track.id, options);
        cues.inLine = around.frontEvidence(box, track.id);
    }
    track.front = track.front.after(cues);
    int quarters = dueTurn(track);
    if (quarters == 0) return track;
    if (quarters % 2 == 1) quarters = towardsPath(track, quarters);
    track.front = track.front.turned(quarters);
    track.path = turned(std::move(track.path), quarters);
    if (track.shownHeading) track.shownHeading = turned(*track.shownHeading, quarters);
    if (quarters == 2) return reversed(track, options.motion);
    return quarterTurned(track, sighting, quarters, options);
}

}  // namespace vdamf
