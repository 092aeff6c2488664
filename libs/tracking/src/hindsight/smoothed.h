// SPDX-License-Identifier: BSD-3-Clause
// The motion of a track as later frames tell it.
#pragma once

#include "hindsight/track_history.h"

namespace vdamf
{
/// What a vehicle does that its motion so far does not tell: standard deviations, over each step.
struct SmoothingNoise
{
    static constexpr double kAcceleration = 3.0;  ///< m/s^2
    static constexpr double kTurning = 0.2;       ///< rad/s
    static constexpr double kWander = 1.0;        ///< m/s: how far it is elsewhere than it drove to
};

/// The history with its poses and speeds smoothed backwards (Rauch, Tung and Striebel 1965), as of
/// a vehicle that drives on as it does and whose rear axle goes where it points. Where boxes jump,
/// what follows tells nothing of the place before; but where a track was still tentative, the place
/// that it had was wrong. Poses stay as unsure as they were. New ones turned as they did when they
/// were confirmed.
TrackHistory smoothed(TrackHistory history);

}  // namespace vdamf
