// SPDX-License-Identifier: BSD-3-Clause
#include "hindsight/smoothed.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "vdamf/tracking/estimation/variable_axis_model.h"

namespace vdamf
{
namespace
{
// Pose and speed: x, y, heading, speed.
struct Motion
{
    Eigen::Vector4d mean;
    Eigen::Matrix4d covariance;
};

Motion motionOf(const TrackReport& report)
{
    return {{report.box.x, report.box.y, report.box.heading, report.speed}, report.covariance};
}

// Of a vehicle that goes on as it does: the motion dt seconds later, and how it depends on now.
struct Prediction
{
    Motion then;
    Eigen::Matrix4d jacobian;
};

// `wander`: of the place, m/s, standard deviation: how far it may be elsewhere than it drove to.
Prediction predicted(const TrackReport& report, double dt, double wander)
{
    // How far behind the centre the rear axle is, of the length.
    static const double kAxis = MotionOptions().axisFraction;
    const Motion now = motionOf(report);
    const double turn = dt * report.yawRate;
    const double way = dt * now.mean(3);
    const Eigen::Matrix2d axes = rotation(now.mean(2) + 0.5 * turn);
    Prediction p;
    p.then.mean = now.mean;
    p.then.mean.head<2>() += axes * Eigen::Vector2d(way, kAxis * report.box.length * turn);
    p.then.mean(2) = wrapAngle(now.mean(2) + turn);
    p.jacobian.setIdentity();
    p.jacobian.block<2, 1>(0, 2) = way * axes.col(1);
    p.jacobian.block<2, 1>(0, 3) = dt * axes.col(0);
    Eigen::Vector4d faster;
    faster << 0.5 * dt * axes.col(0), 0.0, 1.0;
    faster *= SmoothingNoise::kAcceleration * dt;
    const double elsewhere = std::pow(wander * dt, 2);
    const Eigen::Vector4d apart(elsewhere, elsewhere, std::pow(SmoothingNoise::kTurning * dt, 2),
                                0.0);
    p.then.covariance = p.jacobian * now.covariance * p.jacobian.transpose() +
                        faster * faster.transpose() + Eigen::Matrix4d(apart.asDiagonal());
    return p;
}

// What lies so far from what was foretold is no motion that follows: chi-square, 4 degrees of
// freedom.
constexpr double kJump = 25.0;

struct Unforetold
{
    Eigen::Vector4d difference;
    Eigen::Matrix4d inverse;  // of the prediction's covariance
    double nis = 0.0;
};

Unforetold unforetold(const Motion& next, const Motion& foretold)
{
    Unforetold s;
    s.difference = next.mean - foretold.mean;
    s.difference(2) = wrapAngle(s.difference(2));
    s.inverse = foretold.covariance.inverse();
    s.nis = s.difference.dot(s.inverse * s.difference);
    return s;
}

// By what is known of the motion later on; nothing where it jumped in between.
std::optional<Motion> smoothedBy(const Motion& next, const TrackReport& report, double dt,
                                 double wander)
{
    const Prediction p = predicted(report, dt, wander);
    const Unforetold s = unforetold(next, p.then);
    if (!(s.nis < kJump)) return std::nullopt;
    const Motion now = motionOf(report);
    const Eigen::Matrix4d gain = now.covariance * p.jacobian.transpose() * s.inverse;
    const Eigen::Matrix4d covariance =
        now.covariance + gain * (next.covariance - p.then.covariance) * gain.transpose();
    return Motion{now.mean + gain * s.difference, 0.5 * (covariance + covariance.transpose())};
}

// A new track was not as sure as it said where it turned out to be elsewhere, nor of how it turned.
TrackReport asOfNewTrack(TrackReport report, const TrackReport& later, double dt)
{
    constexpr double kDegrees = 4.0;  // of freedom
    const double nis =
        unforetold(motionOf(later), predicted(report, dt, SmoothingNoise::kWander).then).nis;
    if (nis > kJump) report.covariance *= nis / kDegrees;
    report.yawRate = later.yawRate;
    return report;
}

TrackReport smoothedBy(const TrackMoment& later, TrackReport report, double dt)
{
    if (report.status == TrackStatus::Tentative)
        report = asOfNewTrack(std::move(report), later.report, dt);
    constexpr double kUnknown = 1000.0;  // m/s: it says nothing of the place
    const Motion next = motionOf(later.report);
    auto motion = smoothedBy(next, report, dt, SmoothingNoise::kWander);
    // Boxes jump as more of a vehicle is seen, and it drives on all the same.
    if (!motion) motion = smoothedBy(next, report, dt, kUnknown);
    if (!motion) return report;
    report.box.x = motion->mean(0);
    report.box.y = motion->mean(1);
    report.box.heading = wrapAngle(motion->mean(2));
    report.speed = motion->mean(3);
    report.covariance = motion->covariance;
    return report;
}

// The covariance of a pose as it is, with another variance of the speed.
Eigen::Matrix4d withSpeedVariance(const Eigen::Matrix4d& covariance, double variance)
{
    if (!(covariance(3, 3) > 0.0)) return covariance;
    const Eigen::Vector4d scale(1.0, 1.0, 1.0, std::sqrt(variance / covariance(3, 3)));
    return scale.asDiagonal() * covariance * scale.asDiagonal();
}

// What lasts of the errors of poses no frames average out: they stay as unsure as they were, those
// of a new track as they were when it was confirmed.
TrackHistory withErrorsThatLast(TrackHistory told, const std::vector<Eigen::Matrix4d>& before)
{
    for (std::size_t k = told.size(); k-- > 0;)
    {
        TrackReport& report = told[k].report;
        const bool isNew = report.status == TrackStatus::Tentative && k + 1 < told.size();
        report.covariance = withSpeedVariance(isNew ? told[k + 1].report.covariance : before[k],
                                              std::max(0.0, report.covariance(3, 3)));
    }
    return told;
}
}  // namespace

TrackHistory smoothed(TrackHistory history)
{
    std::vector<Eigen::Matrix4d> before;
    before.reserve(history.size());
    for (const TrackMoment& moment : history) before.push_back(moment.report.covariance);
    for (std::size_t k = history.size(); k-- > 1;)
    {
        // Nobody saw it end, and where, nor how late.
        if (history[k].report.status == TrackStatus::Ended) continue;
        TrackMoment& moment = history[k - 1];
        const double dt = history[k].time - moment.time;
        moment.report = smoothedBy(history[k], std::move(moment.report), dt);
    }
    return withErrorsThatLast(std::move(history), before);
}

}  // namespace vdamf
