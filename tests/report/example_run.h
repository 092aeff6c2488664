// SPDX-License-Identifier: BSD-3-Clause
// A small run: a level ground with a box-shaped car and a wall on it.
#pragma once

#include <random>

#include "vdamf/report/run_report.h"

namespace vdamf::test
{
/// Hits on a car of 4 x 2 x 1.5 m whose rear faces the sensor, 20 m ahead of it.
inline LadarFrame exampleFrame(double time, int carHits = 400)
{
    LadarFrame frame;
    frame.time = time;
    frame.origin = {5000.0, 200.0, 10.0};
    frame.sensor = {5000.0, 200.0, 11.8};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    const auto add = [&](float x, float y, float z)
    {
        frame.points.x.push_back(x);
        frame.points.y.push_back(y);
        frame.points.z.push_back(z);
    };
    for (int ring = 0; ring < 40; ++ring)
        for (int k = 0; k < 360; ++k)
        {
            const float range = 4.0F + static_cast<float>(ring);
            const float angle = static_cast<float>(k) * 0.01745329F;
            add(range * std::cos(angle), range * std::sin(angle), 0.0F);
        }
    for (int i = 0; i < carHits; ++i)
        add(20.0F + 0.05F * unit(random), -1.0F + 2.0F * unit(random), 0.3F + 1.2F * unit(random));
    return frame;
}

inline TrackReport exampleTrack(std::uint64_t id = 7)
{
    TrackReport track;
    track.id = id;
    track.status = TrackStatus::Confirmed;
    track.box = {5022.0, 200.0, 0.0, 4.0, 2.0};
    track.z = 10.0;
    track.height = 1.5;
    track.speed = 8.0;
    track.points = 400;
    track.match = 0.5;
    track.nis = 2.5;
    track.facesSeen.add(Face::Back);
    track.covariance.diagonal() << 0.04, 0.01, 0.0004, 0.25;
    track.measuredBox = OrientedBox{5022.1, 200.1, 0.01, 4.2, 2.1};
    return track;
}

inline FrameResult exampleResult(double time, std::vector<TrackReport> tracks = {exampleTrack()})
{
    FrameResult result;
    result.time = time;
    result.tracks = std::move(tracks);
    return result;
}

}  // namespace vdamf::test
