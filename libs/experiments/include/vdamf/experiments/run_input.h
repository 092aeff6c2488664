// SPDX-License-Identifier: BSD-3-Clause
// What a run reads beside its configuration, and how it is scored.
#pragma once

#include <string>

#include "vdamf/evaluation/evaluation.h"

namespace vdamf
{
/// How tracks are held against the truth: the options of vdamf-evaluate.
struct RunScoring
{
    ScoringOptions scoring;
    double pairOverlap = kPairOverlap;
    double stillSpeed = 0.3;  ///< m/s

    EvaluationOptions options() const
    {
        EvaluationOptions all;
        all.scoring = scoring;
        all.pairOverlap = pairOverlap;
        all.stillSpeed = stillSpeed;
        return all;
    }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.scoring.minPoints, "min_points", 0, 1000000,
              "objects with fewer hits do not count");
        field(self.scoring.maxRange, "max_range_m", 0.0, 1e4, "score up to this range; 0: all");
        field(self.scoring.regionFov, "region_fov_deg", 0.0, 360.0,
              "labelled sector ahead of the sensor; 0: all around (KITTI: 80)");
        field(self.scoring.overlap, "overlap", 0.01, 1.0,
              "bird's-eye IoU from which a track has found an object");
        field(self.pairOverlap, "pair_overlap", 0.01, 1.0,
              "bird's-eye IoU of the pairs whose errors are told");
        field(self.stillSpeed, "still_speed_mps", 0.0, 100.0,
              "objects slower than this stand still");
        field(self.scoring.onlyVehicles, "vehicles_only",
              "drop tracks that the discriminator takes for clutter");
        field(self.scoring.withTentative, "with_tentative", "score tentative tracks too");
    }
};

/// Frames to track and to score, [first, last), counted from 0.
struct FrameRange
{
    int first = 0;
    int last = 0;  ///< 0: to the end

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.first, "first_frame", 0, 100000000, "first frame to track");
        field(self.last, "last_frame", 0, 100000000, "frame to stop before; 0: to the end");
    }
};

}  // namespace vdamf
