// SPDX-License-Identifier: BSD-3-Clause
// A sequence by identity: for metrics that look at whole trajectories.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "vdamf/evaluation/matching.h"

namespace vdamf
{
/// One frame. Objects and tracks are numbered from 0 over the whole sequence.
struct TrajectoryFrame
{
    std::vector<std::size_t> objects;   ///< for each row of the truth
    std::vector<std::size_t> tracks;    ///< for each row of the tracks
    std::vector<MatchedPair> overlaps;  ///< all pairs of rows with an overlap above 0
};

/// (object, track)
using Identities = std::pair<std::size_t, std::size_t>;

struct Trajectories
{
    std::vector<TrajectoryFrame> frames;
    std::vector<std::size_t> objectLengths;  ///< frames of each object
    std::vector<std::size_t> trackLengths;
    std::size_t objectRows = 0;
    std::size_t trackRows = 0;
};

/// Of all objects in the sequence, whether they count or not: see withoutDontCare().
Trajectories trajectoriesOf(const Sequence& sequence);

}  // namespace vdamf
