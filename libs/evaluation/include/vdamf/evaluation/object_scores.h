// SPDX-License-Identifier: BSD-3-Clause
// What became of each object: when it was found, for how long, under how many identities.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/matching.h"
#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
/// One object over the frames in which it counts.
struct ObjectScore
{
    std::string id;
    std::string objectClass;
    std::size_t frames = 0;  ///< in which it counts
    std::size_t found = 0;   ///< of them, with a track on it
    std::size_t tracks = 0;  ///< different ones
    double meanOverlap = 0.0;
    /// From the first frame in which it counts to the first one with a track, s; nothing: never.
    std::optional<double> timeToFirst;
    double longestGap = 0.0;  ///< between two frames with a track, others between them, s
};

/// Objects that count in at least one frame, by id.
std::vector<ObjectScore> objectScores(const Sequence& sequence,
                                      const std::vector<FrameMatches>& matches);

}  // namespace vdamf
