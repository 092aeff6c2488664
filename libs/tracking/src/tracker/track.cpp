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

// The measurement as it would have been `lag` seconds before, at the time of the state.
Measurement broughtTo(const VehicleState& state, const Measurement& measurement, double lag,
                      const MotionOptions& options)
{
    const StateVector move =
        modelOf(state.steering, options)->predicted(state.mean, lag) - state.mean;
    Measurement m = measurement;
    m.box.x -= move(kX);
    m.box.y -= move(kY);
    m.box.heading = wrapAngle(m.box.heading - move(kHeading));
    return m;
}
}  // namespace

Track startedTrack(std::uint64_t id, const Sighting& sighting, const StartSpeed& speed,
                   const TrackerOptions& options)
{
    const Measurement& m = sighting.measurement;
    Track track;
    track.id = id;
    const VehicleState seen =
        startState(m, sighting.sensor, speed, options.visibility, options.motion);
    track.state = stateAt(seen, -sighting.lag, options.motion);
    track.hypotheses = hypothesesFrom(track.state, options.motion);
    track.groundZ = sighting.groundZ;
    track.height = sighting.height;
    track.sightings = 1;
    track.lastSeen = sighting.time;
    track.told = SizesTold().with(m);
    track.measurement = m;
    track.lastMatch = m.match;
    if (options.lifecycle.confirmHits <= 1) track.status = TrackStatus::Confirmed;
    appendToPath(track, sighting.time + sighting.lag, seen.mean.head<2>());
    return track;
}

Track sightedTrack(const Track& before, const Sighting& sighting, VehicleKalmanFilter& filter,
                   const TrackerOptions& options)
{
    Track track = before;
    const VisibilityOptions& visibility = options.visibility;
    const Measurement m = alignedWith(
        sighting.measurement, stateAt(before.state, sighting.lag, options.motion).mean(kHeading));
    MotionHypotheses hypotheses = before.hypotheses;
    for (VehicleState* state : {&hypotheses.moving, &hypotheses.standing, &hypotheses.free})
        *state = grownToAVehicle(*state, m, before.told, visibility);
    const VehicleState then =
        stateAt(hypotheses.combined(options.motion), sighting.lag, options.motion);
    BoxMeasurement box =
        boxThrough(m, faceErrors(m, then, visibility), then.size(), sighting.sensor, visibility);
    box.lag = sighting.lag;
    track.nis = innovationOf(then, box).nis();
    for (VehicleState* state : {&hypotheses.moving, &hypotheses.standing, &hypotheses.free})
        *state = openToGrowth(*state, broughtTo(*state, m, box.lag, options.motion), visibility);
    track.hypotheses = updated(hypotheses, box, filter, options.lifecycle.nisGate);
    track.told = before.told.with(m);
    track.state = track.hypotheses.combined(options.motion);
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
    appendToPath(track, sighting.time + sighting.lag, box.box.head<2>());
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
    track.state = track.hypotheses.combined(options);
    track.measurement.reset();
    track.nis.reset();
    track.features.clear();
    return track;
}

TrackReport reportOf(const Track& track, const VisibilityOptions& options)
{
    TrackReport report;
    report.id = track.id;
    report.status = track.status;
    report.box = track.box();
    report.z = track.groundZ;
    report.height = track.height;
    report.speed = track.state.mean(kSpeed);
    report.yawRate = track.state.yawRate();
    report.forwardProbability = track.front.forwardProbability();
    report.type = track.type;
    report.covariance = track.state.covariance.topLeftCorner<4, 4>();
    const Eigen::Vector2d left = rotation(track.state.mean(kHeading)).col(1);
    report.covariance.topLeftCorner<2, 2>() +=
        0.25 * track.state.widthVariance * left * left.transpose();
    const double position = std::pow(options.lastingPosition, 2);
    const double size = std::pow(options.lastingSize, 2);
    report.covariance.diagonal() +=
        Eigen::Vector4d(position, position, std::pow(options.lastingHeading, 2), 0.0);
    report.lengthVariance = track.state.covariance(kLength, kLength) + size;
    report.widthVariance = track.state.widthVariance + size;
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
