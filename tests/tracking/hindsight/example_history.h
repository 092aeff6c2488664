// SPDX-License-Identifier: BSD-3-Clause
// Tracks over time as tests want them.
#pragma once

#include <vector>

#include "hindsight/track_history.h"

namespace vdamf
{
/// A car that stands at the origin, 30 hits in each of its frames, ten of them a second.
inline TrackHistory standingCar(std::size_t frames)
{
    TrackHistory history(frames);
    for (std::size_t k = 0; k < frames; ++k)
    {
        history[k].time = 0.1 * static_cast<double>(k);
        TrackReport& report = history[k].report;
        report.id = 7;
        report.status = TrackStatus::Confirmed;
        report.box = {0.0, 0.0, 0.3, 4.4, 1.8};
        report.points = 30;
        report.facesSeen.add(Face::Back);
        report.facesSeen.add(Face::Left);
        report.heldPoint = {-1.0, 1.0};
        report.covariance.diagonal() << 0.01, 0.01, 0.0001, 0.04;
        report.lengthVariance = 0.01;
        report.widthVariance = 0.01;
        report.forwardProbability = 0.9;
        report.axesProbability = 0.99;
    }
    return history;
}

/// Where its point that was measured lies, m.
inline Eigen::Vector2d heldPlace(const TrackReport& report)
{
    const Eigen::Vector2d half(0.5 * report.box.length, 0.5 * report.box.width);
    return report.box.centre() + rotation(report.box.heading) * half.cwiseProduct(report.heldPoint);
}

}  // namespace vdamf
