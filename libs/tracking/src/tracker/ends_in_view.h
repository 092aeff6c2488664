// SPDX-License-Identifier: BSD-3-Clause
// Which ends of a target are hidden: what is tall is seen over what is lower.
#pragma once

#include "tracker/sighting.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// The measurement with the ends whose place the frame does not show (estimation/occlusion.h), and
/// with those of a car's windows where they are all that shows of its side.
///
/// Trucks and buses (from 2.2 m) are seen over what is lower than they are. Where nothing is in the
/// way of the rays past an end from the highest row of hits there down to the height of cabs, and
/// the face does not go on, that end is told. Where the rays are free higher up alone, it may be
/// the end of what a truck carries: it is told to a metre, as one of the upper ends. So are those
/// of vans (from 1.85 m), whose windscreens lie behind their bumpers. Upper ends tell no size.
Measurement withEndsOutOfView(const Sighting& sighting, const SegmentedFrame& frame);

/// With those of the edges of shadows hidden that lie inside of the box foretold, by more than its
/// faces may err: they are no faces of it, and a line along them is turned. Where what may be a
/// shadow's edge may as well be the side, it tells less of the heading. `hits`: their middle, m.
Measurement withoutShadowEdges(const Measurement& measurement, const VehicleState& foretold,
                               const Eigen::Vector2d& hits);

/// With the upper end of a van hidden where its other end is told, or is one of those `known` to be
/// where they are foretold, unless it surely is the rear: a windscreen lies up to 2 m behind the
/// bumper. `height`: of the target, m; `forwardProbability`: that its front is where the
/// measurement's heading points.
Measurement withoutUpperFront(const Measurement& measurement, double height,
                              double forwardProbability, FaceSet known = {});

/// With those of the upper ends hidden that lie well inside of the box foretold: there a cab or a
/// bonnet goes on.
Measurement withoutShortUpperEnds(const Measurement& measurement, const OrientedBox& foretold);

}  // namespace vdamf
