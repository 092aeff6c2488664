// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/track.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracker/existence.h"
#include "vdamf/tracking/estimation/unseen.h"

namespace vdamf
{
namespace
{
constexpr double kViewMemory = 1.5;  // s, of views, as that of the jitter that they show
}  // namespace

OrientedBox Track::boxOfHits() const
{
    const OrientedBox pose = box();
    const Eigen::Vector2d centre = pose.centre() + rotation(pose.heading) * around.centre();
    return {centre.x(), centre.y(), wrapAngle(pose.heading + around.heading), around.length,
            around.width};
}

OrientedBox inFrameOf(const OrientedBox& frame, const OrientedBox& box)
{
    const Eigen::Vector2d centre = toBoxFrame(frame, box.centre());
    return {centre.x(), centre.y(), wrapAngle(box.heading - frame.heading), box.length, box.width};
}

Track movedBy(Track track, const Eigen::Vector3d& by)
{
    const auto move = [&](VehicleState& state) { state.mean.head<2>() += by.head<2>(); };
    track.hypotheses->forEach(move);
    move(track.state);
    for (PathPoint& point : track.path)
    {
        point.box.x += by.x();
        point.box.y += by.y();
        point.hits += by.head<2>();
    }
    track.seenFrom += by.head<2>();
    track.groundZ += by.z();
    return track;
}

Track movedBy(Track track, const PlaneMotion& by)
{
    const auto move = [&](VehicleState& state)
    {
        state.mean.head<2>() = by.of(Eigen::Vector2d(state.mean.head<2>()));
        state.mean(kHeading) = wrapAngle(state.mean(kHeading) + by.turn);
        if (state.steering == Steering::Independent)
            state.mean.segment<2>(kVelocityX) =
                rotation(by.turn) * state.mean.segment<2>(kVelocityX);
    };
    track.hypotheses->forEach(move);
    move(track.state);
    if (track.shownHeading)
        track.shownHeading->heading = wrapAngle(track.shownHeading->heading + by.turn);
    for (PathPoint& point : track.path)
    {
        point.box = by.of(point.box);
        point.hits = by.of(point.hits);
    }
    return track;
}

Track withoutSighting(Track track)
{
    track.hits = 0;
    track.measurement.reset();
    track.nis.reset();
    track.judgement.features.clear();
    return track;
}

Track predictedTrack(Track track, double dt, const Eigen::Vector2d& sensor,
                     VehicleKalmanFilter& filter, const MotionOptions& options)
{
    track.wasPublished = track.wasPublished || track.status != TrackStatus::Tentative;
    track.stoodProbability = track.hypotheses->standingProbability;
    const View before = viewOf(track.hypotheses->driving.front().box(), track.seenFrom);
    const MotionHypotheses later = predicted(*track.hypotheses, dt, filter, options);
    const View now = viewOf(later.driving.front().box(), sensor);
    const double viewChange = changeOfView(before, now);
    track.interval = dt;
    *track.hypotheses = drifted(later, track.lastingError, viewChange);
    track.viewChanged = track.viewChanged * std::exp(-dt / kViewMemory) + viewChange;
    track.seenFrom = sensor;
    if (track.misses > 0) *track.hypotheses = unseen(*track.hypotheses, dt);
    track.state = track.hypotheses->combined(options);
    if (track.hits > 0) track.lastHits = track.hits;
    return withoutSighting(std::move(track));
}

TrackReport reportOf(const Track& track, const OrientedBox& extent,
                     const VisibilityOptions& options, const Eigen::Vector3d& origin)
{
    const auto inWorld = [&origin](OrientedBox box)
    {
        box.x += origin.x();
        box.y += origin.y();
        return box;
    };
    TrackReport report;
    report.id = track.id;
    report.status = track.status;
    report.box = inWorld(extent);
    report.z = track.groundZ + origin.z();
    report.height = track.height;
    report.speed = track.state.mean(kSpeed);
    report.yawRate = track.state.yawRate();
    report.forwardProbability = track.front.forwardProbability();
    report.axesProbability = track.front.axesProbability();
    report.type = track.type;
    report.isOfHits = extent != track.box();
    if (!report.isOfHits) report.heldPoint = track.errors.fixedPoint;
    report.covariance = toldCovariance(track.state, track.errors, options);
    report.lengthVariance = toldLengthVariance(track.state, track.errors, options);
    report.widthVariance = track.state.widthVariance + std::pow(options.lastingSize, 2);
    report.points = track.hits;
    if (track.measurement)
    {
        report.match = track.measurement->match;
        report.facesSeen = track.measurement->facesSeen;
        report.measuredBox = inWorld(track.measurement->box);
        report.nis = track.nis;
        report.features = track.judgement.features;
    }
    return report;
}

}  // namespace vdamf
