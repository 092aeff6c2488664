// SPDX-License-Identifier: BSD-3-Clause
// Section 4.4 takes the faces of a body for planes that are seen whole. Of a face seen in part, or
// only above the bumper, that leaves out most of the error.
#pragma once

#include "tracker/sighting.h"

namespace vdamf
{
inline constexpr double kLowVehicle = 1.75;  ///< m: of cars, whose ends are bowed and low
inline constexpr double kTruckHeight = 2.2;  ///< m: ends of what is higher are upright

/// The measurement of a sighting with a box that is as long, and as wide, as the row of hits along
/// it where both ends are hidden: all that is known of them is that the row is between them.
Measurement withRowsBetweenHiddenEnds(const Sighting& sighting);

/// The measurement of a sighting without the far end of a side that is too short for the car whose
/// end is beside it: hits that are missing cut the row off, on a dark body or behind a wheel house.
/// Rows of 200 hits and more end where the vehicle does; few cars are as short, but those are.
Measurement withoutEndOfShortSide(const Sighting& sighting);

/// The measurement of a sighting, no longer than the row of hits on its side that has no wide gap,
/// where a car would be too long or the row is a truck's: at a grazing angle what stands behind the
/// gap lies in line with it. Where the line of sight past the row is free it ends there; else how
/// much farther it goes on is not told.
Measurement withinRowOfSide(const Sighting& sighting, const SegmentedFrame& frame);

/// The measurement of the end and the side of a truck or bus, whose far end is not told where the
/// row of hits on its side does not reach it: rays meet the side too far apart at a grazing angle,
/// and the filter alone then leaves the thin end out.
Measurement withoutEndPastRowOfTruck(const Sighting& sighting);

/// The measurement of a sighting with the heading as uncertain as pieces of faces leave it: bodies
/// are round, so that the shorter the row of hits, the more the line through it may be turned.
/// Where a face shows from end to end, both halves of it turn the line alike; a row of an end that
/// is shorter than cars are wide (1.4 m) is a piece of it, whatever the view past it shows.
Measurement withTurnOfPieces(const Sighting& sighting);

/// The same with the heading as uncertain as parts hit a revolution apart leave it.
Measurement withTurnOfParts(const Sighting& sighting, const HitsAtOneTime& seen);

/// Of the hits on the faces seen, all but the two highest, above the ground, m; 0 where heights are
/// not known.
double heightOfFaces(const Measurement& measurement, const Eigen::Vector2d& sensor,
                     const HitsAtOneTime& seen);

}  // namespace vdamf
