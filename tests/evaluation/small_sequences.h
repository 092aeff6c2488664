// SPDX-License-Identifier: BSD-3-Clause
// Scenes of a few boxes, small enough to score by hand.
#pragma once

#include <string>
#include <vector>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
constexpr double kStart = 1.7e9;  ///< s
constexpr double kPeriod = 0.1;   ///< s

inline double timeOf(int frame)
{
    return kStart + kPeriod * frame;
}

/// A car of 4 m by 2 m, looking along x.
inline OrientedBox carAt(double x, double y = 0.0)
{
    return {x, y, 0.0, 4.0, 2.0};
}

/// A share of 2/3: (4 - 0.8) / (4 + 0.8).
constexpr double kShiftForTwoThirds = 0.8;

/// Rows of both tables, frame by frame.
struct Scene
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;

    TruthRow& object(int frame, const std::string& id, const OrientedBox& box)
    {
        TruthRow& row = truth.emplace_back();
        row.time = timeOf(frame);
        row.objectId = id;
        row.objectClass = "Car";
        row.box = box;
        row.height = 1.5;
        return row;
    }
    TrackReport& track(int frame, std::uint64_t id, const OrientedBox& box)
    {
        TrackRow& row = tracks.emplace_back();
        row.time = timeOf(frame);
        row.report.id = id;
        row.report.status = TrackStatus::Confirmed;
        row.report.box = box;
        return row.report;
    }
    Sequence sequence(const ScoringOptions& options = {}) const
    {
        return makeSequence(truth, tracks, options);
    }
};

/// The object alone, `frames` times, driving 1 m a frame.
inline Scene lonelyObject(int frames)
{
    Scene scene;
    for (int f = 0; f < frames; ++f) scene.object(f, "a", carAt(f));
    return scene;
}

/// Tracks on the lonely object: track 1 for `frames` frames, then track 2, ... up to `tracks`.
inline Scene inPieces(int objectFrames, int frames, int tracks)
{
    Scene scene = lonelyObject(objectFrames);
    for (int f = 0; f < frames * tracks; ++f)
    {
        scene.track(f, static_cast<std::uint64_t>(f / frames + 1), carAt(f));
    }
    return scene;
}

/// Two objects side by side, 10 m apart; every track is right in place and shifted by `shift`.
/// From frame `swap` on the two tracks have changed their objects.
inline Scene twoObjects(int frames, double shift, int swap)
{
    Scene scene;
    for (int f = 0; f < frames; ++f)
    {
        scene.object(f, "a", carAt(f));
        scene.object(f, "b", carAt(f, 10.0));
        scene.track(f, f < swap ? 1 : 2, carAt(f + shift));
        scene.track(f, f < swap ? 2 : 1, carAt(f + shift, 10.0));
    }
    return scene;
}

/// One object of 25 frames; its track lacks every fifth of them, the last one too.
inline Scene everyFifthLost()
{
    Scene scene = lonelyObject(25);
    for (int f = 0; f < 25; ++f)
    {
        if (f % 5 != 4) scene.track(f, 1, carAt(f));
    }
    return scene;
}

/// One object of 10 frames, found in all, and a ghost in frame 3.
inline Scene withGhost()
{
    Scene scene = inPieces(10, 10, 1);
    scene.track(3, 9, carAt(50.0, 50.0));
    return scene;
}

/// A car and a pedestrian 20 m from it, each with a perfect track of its own.
inline Scene withPedestrian()
{
    Scene scene = inPieces(10, 10, 1);
    for (int f = 0; f < 10; ++f)
    {
        scene.object(f, "p", {0.0, 20.0, 0.0, 0.6, 0.6}).objectClass = "Pedestrian";
        scene.track(f, 2, carAt(0.2, 20.1));
    }
    return scene;
}

}  // namespace vdamf
