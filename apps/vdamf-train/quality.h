// SPDX-License-Identifier: BSD-3-Clause
// How good a discriminator is on held-out tracks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/reliability.h"
#include "vdamf/evaluation/roc.h"
#include "vdamf/learning/train.h"

namespace vdamf
{
/// Curves of one way to decide.
struct Quality
{
    std::optional<Roc> roc;  ///< nothing without both vehicles and clutter
    Reliability reliability;
};

struct QualityReport
{
    Quality frames;       ///< by single frames
    Quality clearFrames;  ///< with 50 hits or more
    Quality tracks;       ///< by a track's frames so far, at each of them
    Quality clearTracks;  ///< the same, at frames with 50 hits or more
    Quality tracksAtEnd;  ///< by all frames of a track, once a track
    struct Group
    {
        std::string name;
        std::size_t vehicles = 0;
        std::size_t clutter = 0;
        std::optional<Roc> roc;
    };
    std::vector<Group> byRange;  ///< single frames
    std::vector<Group> byHits;
};

/// `replicates`: of the bootstrap of confidence intervals.
QualityReport qualityOf(const std::vector<HeldOutFrame>& frames, const RocOptions& options);

/// As a text of a few lines.
std::string qualityText(const QualityReport& report);

}  // namespace vdamf
