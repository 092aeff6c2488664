// SPDX-License-Identifier: BSD-3-Clause
// What is usual of vehicles' faces, by the heights that hits were seen at.
#pragma once

#include <cstdint>

#include "vdamf/tracking/matched_filter/filter_parameters.h"
#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/hits.h"

namespace vdamf
{
/// Lengths in units of the depth of a car's sill or nose behind its bumper (body_depth_m).
struct BodyProfile
{
    double toHull = 1.0;          ///< from a line to the hull, over the hits' departure outside
    double hullError = 0.4;       ///< and the error of that
    double usualDeparture = 0.0;  ///< of hits outside of the line
    double beyond = 0.0;          ///< how far the face lies beyond what is seen of it ...
    double beyondError = 0.0;     ///< ... and the standard deviation of that
};

constexpr double kCarRoof = 1.38;  ///< of cars: roofs begin, m above the ground

/// Whether hits at such heights (as in Hits) are of a car, which nothing taller is; not where they
/// are unknown.
bool areOfCar(std::uint64_t heights);

/// The same of `hits`, and each of them has its height: those above kCarRoof can be told apart.
bool isCarWithHeights(const Hits& hits);

/// `heights` as in Hits. By Monte Carlo on the simulated cars, vans and trucks: cars' ends reach
/// their full length at bumper height alone, bonnets and boot lids lie up to a metre behind it;
/// what is taller than a car is flatter. Unknown heights: as if all of them were seen.
BodyProfile bodyProfile(Face face, std::uint64_t heights, const HullParameters& hull = {});

}  // namespace vdamf
