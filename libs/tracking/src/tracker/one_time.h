// SPDX-License-Identifier: BSD-3-Clause
// Hits of a target that moves during a revolution, brought to one time.
#pragma once

#include <cstddef>
#include <vector>

#include "tracker/sighting.h"
#include "vdamf/tracking/types/vehicle_state.h"

namespace vdamf
{
/// What a target's hits are taken to move with: the motion of the predicted state.
struct TargetMotion
{
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< in the frame of the hits, m
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of the centre, m/s
    double yawRate = 0.0;                                ///< rad/s
    double speedSigma = 0.0;                             ///< m/s
    double changes = 0.0;                                ///< probability that the speed does
};

TargetMotion motionOf(const VehicleState& state);

/// The hits of some clusters at their mean time, moved there by the target's motion; as they are
/// where hits have no times. Their mean stays where it is, so that a wrong motion distorts the
/// shape, but feeds back on no position. What a turning scanner has seen twice, at both ends of its
/// revolution, is put together where the motion is known to 0.3 m over that time; else the part
/// with more hits stands alone.
HitsAtOneTime hitsAtOneTime(const SegmentedFrame& frame, const std::vector<std::size_t>& clusters,
                            const TargetMotion& motion, double mergeCell);

}  // namespace vdamf
