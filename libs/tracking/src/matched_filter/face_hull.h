// SPDX-License-Identifier: BSD-3-Clause
// From the line through the hits of a face to the hull of the body.
#pragma once

#include "matched_filter/line_sums.h"
#include "vdamf/tracking/matched_filter/filter_parameters.h"

namespace vdamf
{
/// How the hits of a face scatter about its line.
struct Departure
{
    double outside = 0.0;  ///< mean square of those outside of the line, m^2
    double inside = 0.0;   ///< and of those inside of it, m^2
    double countOutside = 0.0;
    double countInside = 0.0;
    double extent = 0.0;  ///< of the hits along the face: of an even row its whole length, m
};

Departure departureOf(const NearFace& face, const LineState& line);

/// What is known of bodies before any hit is seen.
struct BodyPrior
{
    std::uint64_t heights = 0;  ///< Hits::heights
    Face face = Face::Left;
    double depth = 0.0;  ///< of a car's sill or nose behind its bumper, m; 0: walls
    HullParameters hull = {};
    ErrorParameters errors = {};
};

/// From a line to the hull of the body.
struct Hull
{
    double outwards = 0.0;   ///< from the line to the hull, m
    double error = 0.0;      ///< of the hull's place, standard deviation, m
    double turnError = 0.0;  ///< of its direction, rad
    double shape = 0.0;      ///< departure outside of the line that was reckoned with, m
};

/// Vehicles are round and tapered: their hits lie inside of the hull that a box stands for, the
/// more, the more they scatter; few hits tell little of that, and what is usual counts as well.
/// Ends reach their full length at bumper height alone: where no hits are there, the face lies
/// beyond what is seen of it. On plane walls nothing is added.
Hull hullOf(const Departure& departure, const NearFace& face, const LineState& line,
            const BodyPrior& body);

}  // namespace vdamf
