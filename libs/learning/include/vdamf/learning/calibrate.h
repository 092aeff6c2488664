// SPDX-License-Identifier: BSD-3-Clause
// Scores to probabilities, of single frames and of tracks.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/tracking/discrimination/classify.h"

namespace vdamf
{
/// A score of the classifier for a sample that it was not trained on.
struct ScoredSample
{
    double score = 0.0;
    std::size_t hits = 0;
    bool vehicle = false;
};

FrameCalibration calibrateFrames(const std::vector<ScoredSample>& samples);

/// One frame of a track: what the frame says, and what it is, where that is known and asked for.
struct JudgedFrame
{
    double logOdds = 0.0;
    bool counts = false;
    bool vehicle = false;
};

/// Memory and correlation of the least logarithmic loss on the frames that count, with slope and
/// offset. `tracks`: all frames of each, by time. `prior`: of the frames' calibration.
TrackCalibration calibrateTracks(const std::vector<std::vector<JudgedFrame>>& tracks, double prior);

/// Log-odds of a track at each of its frames.
std::vector<double> courseOf(const std::vector<JudgedFrame>& track,
                             const TrackCalibration& calibration, double prior);

}  // namespace vdamf
