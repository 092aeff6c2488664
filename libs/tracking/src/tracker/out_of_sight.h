// SPDX-License-Identifier: BSD-3-Clause
// Vehicles that drive out of sight, turn there, and come back elsewhere than was foretold.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tracker/track.h"

namespace vdamf
{
/// What drove out of sight of late. All positions are relative to the origin of the last frame.
class OutOfSight
{
public:
    /// `longest`: time for which a vehicle is remembered, s.
    explicit OutOfSight(double longest) : longest_(longest) {}

    /// To a frame whose origin lies so much farther back (m), as movedBy() of tracks.
    void moveBy(const Eigen::Vector3d& by);
    void moveBy(const PlaneMotion& by);

    /// The tracks of a frame at a time (s), by rising id: a new one that may have come from where
    /// a vehicle drove out of sight, along one bend at the speed of both, and is as large, goes on
    /// as that vehicle. Its own identity ends, and so does the box that was foretold, where it is
    /// still waited for. Nothing where more than one may be the other.
    std::vector<Track> withReturns(std::vector<Track> tracks, double time);

private:
    // A published vehicle, when it was first missed.
    struct Departure
    {
        std::uint64_t id = 0;
        double time = 0.0;  // s
        OrientedBox box;
        double speed = 0.0;   // m/s
        double height = 0.0;  // m
    };

    static bool mayBe(const Departure& gone, const Track& found, double time);
    void remember(const std::vector<Track>& tracks, double time);

    double longest_;
    std::vector<Departure> gone_;
};

}  // namespace vdamf
