// SPDX-License-Identifier: BSD-3-Clause
// What is expected of a vehicle that was not seen where it should be.
#pragma once

#include "vdamf/tracking/estimation/motion_hypotheses.h"

namespace vdamf
{
/// The hypotheses after `dt` seconds without a sighting. Turns come to their end, sharp ones later:
/// it is likelier to go straight on than to keep turning in a circle. And what stood sets off from
/// where it stood and from rest: a speed that the last hits feigned does not carry it away.
MotionHypotheses unseen(const MotionHypotheses& hypotheses, double dt);

}  // namespace vdamf
