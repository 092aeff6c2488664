// SPDX-License-Identifier: BSD-3-Clause
// How well positions can be known at all: what hits show of where a vehicle begins and ends.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
/// The least square of the distance from a box's centre to where it is held to be, m^2, for an
/// observer who lacks one thing: how much longer and wider than usual the vehicle is. `hits` (own
/// frame of the box, m) bound what has hit it so far. A face that they come near to (0.3 m) is
/// known exactly; opposite to it the vehicle ends where one of the usual size does, or where the
/// hits do if those reach farther. Where neither of two opposite faces is known nothing is counted.
double leastSquaredOffset(const Eigen::AlignedBox2d& hits, const BodySize& size,
                          const BodySize& usual);

/// What has hit a vehicle so far when its box counts: with 20 hits and more, up to 60 m from the
/// sensor.
struct SeenBox
{
    std::size_t object = 0;    ///< of the scene
    Eigen::AlignedBox2d hits;  ///< in its own frame, m
};

/// What a scenario's first sensor shows.
struct SeenBoxes
{
    std::vector<SeenBox> boxes;              ///< frame by frame
    std::vector<Eigen::AlignedBox2d> inAll;  ///< by object, what hit it in the whole run
};

SeenBoxes seenBoxes(const Scenario& scenario);

/// RMS over those boxes, m; without any 0.
struct PositionFloor
{
    std::size_t boxes = 0;
    double online = 0.0;     ///< by the hits up to each frame
    double hindsight = 0.0;  ///< by those of the whole run
};

/// `usual` is the same scenario with vehicles of usual sizes.
PositionFloor positionFloor(const SeenBoxes& seen, const Scenario& scenario, const Scenario& usual);

/// The scenario as it is usual to one who takes trucks and buses for the same: all of them are as
/// long as the mean of a usual truck and a usual bus.
Scenario withHeaviesAlike(Scenario usual);

}  // namespace vdamf
