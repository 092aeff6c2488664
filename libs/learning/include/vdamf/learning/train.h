// SPDX-License-Identifier: BSD-3-Clause
// Trains the vehicle discriminator and says how good it is on tracks that it did not see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/learning/sample.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
struct TrainingOptions
{
    int folds = 5;
    std::uint64_t seed = 1;
    /// Evenly chosen, so that objects that are seen for long do not outweigh the others.
    int framesPerTrack = 40;
    int threads = 2;  ///< folds that are trained at a time; each takes memory of its own
    std::vector<double> costs = {0.01, 0.03, 0.1, 0.3, 1.0};  ///< C of the classifier, to try
    /// Of the frames of all objects where the model will be used, between 0 and 1; none: as in the
    /// tracks given.
    std::optional<double> vehicleShare;
};

/// A labelled frame of a track, judged by a model that knew neither the track nor any of its group.
struct HeldOutFrame
{
    const ObjectSample* sample = nullptr;  ///< of the tracks given
    std::size_t recording = 0;
    double frameProbability = 0.0;  ///< by this frame alone
    double trackProbability = 0.0;  ///< by all frames of the track so far
    bool isLastOfTrack = false;     ///< the last labelled one
};

struct CostTrial
{
    double cost = 0.0;
    double loss = 0.0;  ///< mean logarithmic loss of held-out frames
};

struct TrainingCounts
{
    std::size_t vehicleTracks = 0;
    std::size_t clutterTracks = 0;
    std::size_t vehicleFrames = 0;
    std::size_t clutterFrames = 0;
};

struct Training
{
    DiscriminatorModel model;  ///< trained on all tracks; the record is the caller's to fill
    TrainingCounts counts;
    std::vector<CostTrial> trials;
    double cost = 0.0;  ///< chosen
    std::vector<HeldOutFrame> heldOut;
};

/// Labelled tracks and frames.
TrainingCounts countsOf(const std::vector<TrackSamples>& tracks);

/// Cross-validation by groups of tracks chooses the cost; scores of held-out tracks calibrate the
/// probabilities. Those of `heldOut` come from calibrations that did not see their tracks either,
/// for the share of vehicles that there is in these.
/// Deterministic. `progress` gets a line for each step. Throws std::runtime_error where there are
/// too few groups, or only one kind of object.
Training trainClassifier(const std::vector<TrackSamples>& tracks, const DiscriminationGrid& grid,
                         const TrainingOptions& options,
                         const std::function<void(const std::string&)>& progress);

/// Labelled frames of tracks that a model was not trained on, judged by it.
std::vector<HeldOutFrame> judge(const DiscriminatorModel& model,
                                const std::vector<TrackSamples>& tracks);

}  // namespace vdamf
