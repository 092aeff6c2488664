// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/track.h"

#include <algorithm>
#include <cmath>

#include "vdamf/tracking/estimation/start_state.h"

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
}  // namespace

Track startedTrack(std::uint64_t id, const Sighting& sighting, const TrackerOptions& options)
{
    const Measurement& m = sighting.measurement;
    Track track;
    track.id = id;
    track.state = startState(m, sighting.sensor, options.lifecycle.startSpeedSigma,
                             options.visibility, options.motion);
    track.hypotheses = hypothesesFrom(track.state);
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
    const VisibilityOptions& visibility = options.visibility;
    const BoxMeasurement box = boxThrough(m, faceErrors(m, before.state, visibility),
                                          before.state.size(), sighting.sensor, visibility);
    track.nis = innovationOf(before.state, box).nis();
    MotionHypotheses open = before.hypotheses;
    open.moving = openToGrowth(open.moving, m, visibility);
    open.standing = openToGrowth(open.standing, m, visibility);
    track.hypotheses = updated(open, box, filter, options.lifecycle.nisGate);
    track.state = track.hypotheses.combined();
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
    appendToPath(track, sighting.time, box.box.head<2>());
    return withCheckedHeading(track, sighting, options);
}

Track predictedTrack(const Track& before, double dt, VehicleKalmanFilter& filter,
                     const MotionOptions& options)
{
    Track track = before;
    track.hypotheses = predicted(before.hypotheses, dt, filter, options);
    // Unseen, a vehicle is likelier to go straight on than to keep turning in a circle.
    constexpr double kTurnTime = 0.7;  // s
    if (before.misses > 0) track.hypotheses.moving.mean(kCurvature) *= std::exp(-dt / kTurnTime);
    track.state = track.hypotheses.combined();
    track.measurement.reset();
    track.nis.reset();
    track.features.clear();
    return track;
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
    const Eigen::Vector2d left = rotation(track.state.mean(kHeading)).col(1);
    report.covariance.topLeftCorner<2, 2>() +=
        0.25 * track.state.widthVariance * left * left.transpose();
    report.lengthVariance = track.state.covariance(kLength, kLength);
    report.widthVariance = track.state.widthVariance;
    if (track.measurement)
    {
        report.points = track.measurement->hits;
        report.match = track.measurement->match;
        report.facesSeen = track.measurement->facesSeen;
        report.measuredBox = track.measurement->box;
        report.nis = track.nis;
        report.features = track.features;
    }
    return report;
}

}  // namespace vdamf
