// SPDX-License-Identifier: BSD-3-Clause
// The time that the tracker takes for the frames of a sequence, stage by stage.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "vdamf/tracking/tracker/tracker.h"

namespace vdamf
{
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::Discrimination) + 1;

/// Time on the clock, and processor time of all threads together: on a machine that does other
/// work as well, only the latter can be compared. Seconds.
struct Duration
{
    double wall = 0.0;
    double processor = 0.0;
};

/// Medians over the frames of a sequence.
struct SequenceTimes
{
    std::size_t frames = 0;
    double points = 0.0;
    double clusters = 0.0;
    double tracks = 0.0;
    std::array<Duration, kStages> stages;
    Duration all;  ///< Tracker::process
};

/// The frame with a number; called with rising numbers from 0.
using FrameSource = std::function<LadarFrame(int)>;

/// Tracks `frames` frames; the first `warmUp` of them, in which the tracks start, do not count.
SequenceTimes timedSequence(const FrameSource& source, int frames, int warmUp,
                            const TrackerOptions& options);

}  // namespace vdamf
