// SPDX-License-Identifier: BSD-3-Clause
// Measurements that are turned farther than the vehicle is likely to be.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "tracker/sighting.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// A face that seems to lie across of how the vehicle is foretold, where it is known well which way
/// it lies, is another one of its faces: the sighting with length and width exchanged, and nothing
/// where it does not. Few hits of a front were taken for a side 2.6 m long, and turned a car by a
/// quarter. `axesProbability`: that length and width of what is foretold are not exchanged.
std::optional<Sighting> turnedToKnownAxes(const Sighting& sighting, const VehicleState& foretold,
                                          double axesProbability);

/// The measurement with its heading as uncertain as that makes it: of an end alone no row of hits
/// tells the heading as well as a vehicle keeps its own, and what seems to turn more than both may
/// err is an error of the fit, about the hits. `hits`: their middle, m.
Measurement withUnlikelyTurn(const Measurement& measurement, const VehicleState& foretold,
                             const Eigen::Vector2d& hits);

/// The measurement of what stands, which does not turn. What is measured far from its heading, and
/// vaguely, tells the place of its faces along axes that are turned as well: it is turned back,
/// about the hits, as far as it is uncertain.
Measurement turnedBack(const Measurement& measurement, const VehicleState& standing,
                       const Eigen::Vector2d& hits);

}  // namespace vdamf
