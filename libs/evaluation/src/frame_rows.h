// SPDX-License-Identifier: BSD-3-Clause
// The rows of both tables, brought together by time.
#pragma once

#include <optional>
#include <vector>

#include "vdamf/evaluation/tables.h"

namespace vdamf
{
struct FrameRows
{
    double time = 0.0;             ///< of its first row, s
    std::vector<TruthRow> truth;   ///< by objectId
    std::vector<TrackRow> tracks;  ///< by id
    std::optional<PlanePose> sensor;
};

/// By time; rows within `tolerance` (s) of the first one of a frame belong to it. Frames before the
/// first and after the last one with truth are left out. The sensor's pose is that of the truth, or
/// lies between those of the nearest frames with one; before the first and after the last of them
/// there is none. Throws as makeSequence() does.
std::vector<FrameRows> framesOf(const std::vector<TruthRow>& truth,
                                const std::vector<TrackRow>& tracks, double tolerance);

}  // namespace vdamf
