// SPDX-License-Identifier: BSD-3-Clause
// What is known of a vehicle that was seen once.
#pragma once

#include "vdamf/tracking/estimation/assumed_size.h"

namespace vdamf
{
/// What is known of a new vehicle's speed along its heading, m/s.
struct StartSpeed
{
    double mean = 0.0;
    double sigma = 16.0;
};

/// State from a first measurement, with the axle at its prior.
/// Sizes are those measured, after a car's where that fits (assumeVehicleSize). World frame, also
/// for the sensor. `height`: of what is seen, m.
VehicleState startState(const Measurement& measurement, double height,
                        const Eigen::Vector2d& sensor, const StartSpeed& speed,
                        const VisibilityOptions& visibility, const MotionOptions& motion);

/// The state of a vehicle whose speed has just become known, with what that says of its path: fast
/// ones hardly turn (2 m/s^2 across, one sigma).
VehicleState withUsualCurvature(const VehicleState& state);

/// How far a vehicle turned between two sightings, counter-clockwise.
struct TurnShown
{
    double angle = 0.0;     ///< rad
    double variance = 0.0;  ///< rad^2
    double duration = 0.0;  ///< s
};

/// The state of a vehicle whose speed has just become known, with the curvature of its path that
/// its turn until then tells: while the speed was not known, the update could not. Turns that are
/// too sharp to be true change nothing.
VehicleState withTurnShown(const VehicleState& state, const TurnShown& turn);

/// Which sizes of a vehicle have been seen from end to end.
struct SizesTold
{
    bool length = false;
    bool width = false;

    SizesTold with(const Measurement& measurement) const;
};

/// The predicted state, with a length that was never told taken from a car or a truck once its end
/// is as wide as theirs, and a width once its side is as long: what was first seen in part, as
/// behind a pole, shows only later that it is a vehicle. The face that is seen stays; centre and
/// axle move with the other one. `height`: of what is seen, m.
VehicleState grownToAVehicle(const VehicleState& predicted, const Measurement& measurement,
                             double height, const SizesTold& told,
                             const VisibilityOptions& options);

/// The predicted state of what is known by other means to be a car or larger: sizes that were never
/// told and are smaller than any car's become a car's, or a truck's. What is seen of it stays.
VehicleState grownAsJudged(const VehicleState& predicted, const Measurement& measurement,
                           double height, const SizesTold& told, const VisibilityOptions& options);

/// The state of a vehicle that turned out longer than was known, where one end of its side is
/// hidden: as long as the `whole` is that goes on there. The other end stays.
VehicleState goingOnOutOfSight(const VehicleState& state, const Measurement& measurement,
                               const AssumedSize& whole);

/// The state with another length assumed than before, as more became known of the end seen (1 the
/// front, -1 the rear), which stays: as far as the length is not yet known better than that.
VehicleState withLengthAssumed(const VehicleState& state, const AssumedSize& before,
                               const AssumedSize& now, double seen);

}  // namespace vdamf
