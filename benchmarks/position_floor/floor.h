// SPDX-License-Identifier: BSD-3-Clause
// How well positions can be known at all: what hits show of where a vehicle begins and ends.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

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

/// RMS over the vehicles' boxes with 20 hits and more up to 60 m from the sensor, m.
struct PositionFloor
{
    std::size_t boxes = 0;
    double online = 0.0;     ///< by the hits up to each frame
    double hindsight = 0.0;  ///< by those of the whole run
};

/// Of a scenario's first sensor. `usual` is the same scenario with vehicles of usual sizes. Without
/// boxes 0.
PositionFloor positionFloor(const Scenario& scenario, const Scenario& usual);

}  // namespace vdamf
