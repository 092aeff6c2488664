// SPDX-License-Identifier: BSD-3-Clause
// From the scores of held-out tracks to probabilities.
#pragma once

#include <vector>

#include "vdamf/learning/train.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
using Scores = std::vector<std::vector<double>>;  ///< [track][frame]

struct Calibrations
{
    FrameCalibration frame;
    TrackCalibration track;
};

/// Of the tracks outside of a fold; -1: of all.
Calibrations calibrate(const std::vector<TrackSamples>& tracks, const Scores& scores,
                       const std::vector<int>& foldOf, int without);

/// The same evidence, where another share of all frames, between 0 and 1, is vehicles'.
Calibrations withVehicleShare(const Calibrations& calibrations, double share);

/// Mean logarithmic loss of the labelled frames, calibrated on themselves.
double frameLoss(const std::vector<TrackSamples>& tracks, const Scores& scores);

/// Each track judged by calibrations of the other folds.
std::vector<HeldOutFrame> crossCalibrated(const std::vector<TrackSamples>& tracks,
                                          const Scores& scores, const std::vector<int>& foldOf,
                                          int folds);

/// Labelled frames of a track behind those of others.
void appendJudged(std::vector<HeldOutFrame>& frames, const TrackSamples& track,
                  const std::vector<double>& scores, const Calibrations& calibrations);

}  // namespace vdamf
