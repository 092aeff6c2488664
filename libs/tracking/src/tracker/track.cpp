// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/track.h"

#include <algorithm>
#include <cmath>

#include "tracker/existence.h"
#include "vdamf/tracking/estimation/unseen.h"

namespace vdamf
{
namespace
{
// Of (x, y, heading, speed): the filter's, and what lasts of the errors.
Eigen::Matrix4d toldCovariance(const Track& track, const VisibilityOptions& options)
{
    Eigen::Matrix4d covariance = track.state.covariance.topLeftCorner<4, 4>();
    // The centre errs by half of what the length and the width do.
    const Eigen::Matrix2d axes = rotation(track.state.mean(kHeading));
    const Eigen::Vector2d bySize(0.25 * std::pow(options.lastingSize, 2),
                                 0.25 * track.state.widthVariance);
    covariance.topLeftCorner<2, 2>() += axes * bySize.asDiagonal() * axes.transpose();
    covariance.topLeftCorner<3, 3>() += track.lastingError;
    // What lasts of the measurements' errors is at least what the options say.
    const auto lacking = [](double least, double known)
    { return std::max(0.0, least * least - known); };
    const double position =
        lacking(options.lastingPosition, 0.5 * track.lastingError.topLeftCorner<2, 2>().trace());
    const double heading = lacking(options.lastingHeading, track.lastingError(2, 2));
    covariance.diagonal() += Eigen::Vector4d(position, position, heading, 0.0);
    return covariance;
}
}  // namespace

OrientedBox Track::boxOfHits() const
{
    const OrientedBox pose = box();
    const Eigen::Vector2d centre = pose.centre() + rotation(pose.heading) * around.centre();
    return {centre.x(), centre.y(), wrapAngle(pose.heading + around.heading), around.length,
            around.width};
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
    }
    track.seenFrom += by.head<2>();
    track.groundZ += by.z();
    return track;
}

Track predictedTrack(Track track, double dt, const Eigen::Vector2d& sensor,
                     VehicleKalmanFilter& filter, const MotionOptions& options)
{
    track.stoodProbability = track.hypotheses->standingProbability;
    const View before = viewOf(track.hypotheses->driving.front().box(), track.seenFrom);
    const MotionHypotheses later = predicted(*track.hypotheses, dt, filter, options);
    const View now = viewOf(later.driving.front().box(), sensor);
    *track.hypotheses = drifted(later, track.lastingError, changeOfView(before, now));
    track.seenFrom = sensor;
    if (track.misses > 0) *track.hypotheses = unseen(*track.hypotheses, dt);
    track.state = track.hypotheses->combined(options);
    track.hits = 0;
    track.measurement.reset();
    track.nis.reset();
    track.judgement.features.clear();
    return track;
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
    report.type = track.type;
    report.covariance = toldCovariance(track, options);
    const double size = std::pow(options.lastingSize, 2);
    report.lengthVariance = track.state.covariance(kLength, kLength) + size;
    report.widthVariance = track.state.widthVariance + size;
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
