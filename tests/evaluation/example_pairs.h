// SPDX-License-Identifier: BSD-3-Clause
// Cars and tracks on them, made by hand.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "vdamf/evaluation/matching.h"
#include "vdamf/evaluation/tables.h"

namespace vdamf
{
/// A car of 4 m x 2 m that heads 30 degrees off the x axis.
inline TruthRow exampleCar(double time = 100.0, const std::string& id = "car")
{
    TruthRow row;
    row.time = time;
    row.objectId = id;
    row.objectClass = "Car";
    row.box = {500.0, -200.0, kPi / 6.0, 4.0, 2.0};
    row.height = 1.5;
    row.speed = 5.0;
    row.points = 80;
    row.sensor = PlanePose{490.0, -200.0, 0.0};
    return row;
}

/// A track that says exactly what the row says, with standard deviations of 0.1 m, 0.05 rad,
/// 0.5 m/s and 0.2 m.
inline TrackRow trackOn(const TruthRow& truth, std::uint64_t id = 1)
{
    TrackRow row;
    row.time = truth.time;
    row.report.id = id;
    row.report.status = TrackStatus::Confirmed;
    row.report.box = truth.box;
    row.report.height = truth.height;
    row.report.speed = truth.speed;
    row.report.points = truth.points;
    row.report.covariance.diagonal() << 0.01, 0.01, 0.0025, 0.25;
    row.report.lengthVariance = 0.04;
    row.report.widthVariance = 0.04;
    return row;
}

/// Moved in the track's own frame: forwards and to the left, m.
inline TrackRow moved(TrackRow row, double forwards, double left)
{
    OrientedBox& box = row.report.box;
    const Eigen::Vector2d centre =
        box.centre() + rotation(box.heading) * Eigen::Vector2d(forwards, left);
    box.x = centre.x();
    box.y = centre.y();
    return row;
}

/// Frames of one car and one track each, paired.
inline Sequence sequenceOf(const std::vector<std::pair<TruthRow, TrackRow>>& rows)
{
    Sequence sequence;
    for (const auto& [truth, track] : rows)
    {
        sequence.frames.push_back({truth.time, truth.sensor, {truth}, {true}, {track}});
    }
    return sequence;
}

inline std::vector<FrameMatches> allPaired(const Sequence& sequence)
{
    FrameMatches matches;
    matches.pairs.push_back({0, 0, 0.8});
    return std::vector<FrameMatches>(sequence.frames.size(), matches);
}

}  // namespace vdamf
