// SPDX-License-Identifier: BSD-3-Clause
// Riders and people: what moves and has no faces. Where its hits are tells its place, and the way
// that it goes its heading.
//
// The side of a bicycle is as wide as a car's end, and lines through the hits on a rider lie ever
// otherwise: taken for faces, they turn the box across its way.
#pragma once

#include "tracker/track.h"

namespace vdamf
{
/// The track, started anew as one without faces where it is hardly a vehicle, no larger than a
/// rider, and goes straight on for 0.6 m, other than it was held to; as one with faces where it
/// turns out to be a vehicle, or larger.
Track withFacesChecked(Track track, const Sighting& sighting, const MotionOptions& motion);

/// A rectangle of hits as large as a body is at the least: what is missing is out of view, away
/// from the sensor.
OrientedBox bodyAround(const OrientedBox& hits, const Eigen::Vector2d& sensor);

/// Of such a track: the rectangle around it, which tells no heading but has the one foretold.
BoxMeasurement boxOfHits(const Sighting& sighting, const VehicleState& foretold);

/// Its front as the way tells it that its path ends with.
HeadingBelief frontByWay(const Track& track);

}  // namespace vdamf
