// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/track.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
void appendToPath(Track& track, double time, const Eigen::Vector2d& position)
{
    constexpr double kPathTime = 1.0;  // s
    track.path.push_back({time, position});
    while (track.path.front().time < time - kPathTime) track.path.pop_front();
}

// Evidence that a measurement lies outside the gate lowers its weight instead of losing the track.
PoseMeasurement tempered(PoseMeasurement pose, const VehicleState& predicted, double gate)
{
    const double nis = nisOf(predicted, pose);
    if (nis > gate) pose.covariance *= nis / gate;
    return pose;
}
}  // namespace

Track startedTrack(std::uint64_t id, const Sighting& sighting, const TrackerOptions& options)
{
    const Measurement& m = sighting.measurement;
    Track track;
    track.id = id;
    track.size = initialSize(m, options.visibility);
    const PoseMeasurement pose = anchoredPose(m, track.size, sighting.sensor, options.visibility);
    const double length = track.size.length.mean;
    const MotionOptions& motion = options.motion;
    track.state.mean << pose.pose, 0.0, 0.0, motion.axisFraction * length;
    track.state.covariance.topLeftCorner<3, 3>() = pose.covariance;
    const double speed = options.lifecycle.startSpeedSigma;
    const double axis = motion.axisFractionSigma * length;
    constexpr double kStartCurvatureSigma = 0.05;  // 1/m
    track.state.covariance(kSpeed, kSpeed) = speed * speed;
    track.state.covariance(kCurvature, kCurvature) = kStartCurvatureSigma * kStartCurvatureSigma;
    track.state.covariance(kAxis, kAxis) = axis * axis;
    track.groundZ = sighting.groundZ;
    track.height = sighting.height;
    track.sightings = 1;
    track.lastSeen = sighting.time;
    track.measurement = m;
    track.lastMatch = m.match;
    if (options.lifecycle.confirmHits <= 1) track.status = TrackStatus::Confirmed;
    appendToPath(track, sighting.time, track.state.mean.head<2>());
    return track;
}

Track sightedTrack(const Track& before, const Sighting& sighting, VehicleKalmanFilter& filter,
                   const TrackerOptions& options)
{
    Track track = before;
    const Measurement m = alignedWith(sighting.measurement, track.state.mean(kHeading));
    track.size = updatedSize(before.size, m, options.visibility);
    track.state = resized(track.state, before.size, track.size, fixedPoint(m, sighting.sensor));
    const PoseMeasurement pose = anchoredPose(m, track.size, sighting.sensor, options.visibility);
    track.nis = nisOf(track.state, pose);
    const UpdatedState updated =
        filter.update(track.state, tempered(pose, track.state, options.lifecycle.nisGate),
                      track.size.length.mean);
    track.state = updated.state;
    track.measurement = m;
    track.lastMatch = m.match;
    track.groundZ = sighting.groundZ;
    track.height = std::max(sighting.height, 0.95 * track.height + 0.05 * sighting.height);
    ++track.sightings;
    track.misses = 0;
    track.lastSeen = sighting.time;
    if (track.status == TrackStatus::Coasting || (track.status == TrackStatus::Tentative &&
                                                  track.sightings >= options.lifecycle.confirmHits))
        track.status = TrackStatus::Confirmed;
    appendToPath(track, sighting.time, pose.pose.head<2>());
    return withCheckedHeading(track, sighting, options);
}

TrackReport reportOf(const Track& track)
{
    TrackReport report;
    report.id = track.id;
    report.status = track.status;
    report.box = track.box();
    report.z = track.groundZ;
    report.height = track.height;
    report.speed = track.state.mean(kSpeed);
    report.yawRate = track.state.yawRate();
    report.covariance = track.state.covariance.topLeftCorner<4, 4>();
    report.lengthVariance = track.size.length.variance;
    report.widthVariance = track.size.width.variance;
    if (track.measurement)
    {
        report.points = track.measurement->hits;
        report.match = track.measurement->match;
        report.facesSeen = track.measurement->facesSeen;
        report.measuredBox = track.measurement->box;
        report.nis = track.nis;
    }
    return report;
}

}  // namespace vdamf
