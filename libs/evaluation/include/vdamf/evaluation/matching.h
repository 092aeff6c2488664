// SPDX-License-Identifier: BSD-3-Clause
// Which track is which object, frame by frame, as CLEAR MOT pairs them.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// A track on an object: indices into ScoredFrame::truth and ::tracks.
struct MatchedPair
{
    std::size_t truth = 0;
    std::size_t track = 0;
    double overlap = 0.0;  ///< bird's-eye IoU
};

struct FrameMatches
{
    std::vector<MatchedPair> pairs;        ///< by truth; objects that count
    std::vector<std::size_t> missed;       ///< objects that count without a track
    std::vector<std::size_t> falseAlarms;  ///< tracks on nothing
    std::vector<std::size_t> onDontCare;   ///< tracks on objects that do not count: not scored
};

/// Per frame the assignment that keeps most pairs of the frame before and then has the highest
/// overlap, among pairs of at least `minOverlap` (Bernardin and Stiefelhagen 2008, as in
/// TrackEval). Tracks left over whose centre lies in a don't-care object, or that overlap one by
/// at least `minOverlap`, are onDontCare. One entry a frame.
std::vector<FrameMatches> matchFrames(const Sequence& sequence, double minOverlap);

/// Assignment of rows to columns with the highest sum of scores; each row and column at most once;
/// pairs with a score <= 0 are not made. `scores[row][column]`. Returns the column of each row, or
/// -1. Deterministic; O(n^3).
std::vector<int> bestAssignment(const std::vector<std::vector<double>>& scores);

}  // namespace vdamf
