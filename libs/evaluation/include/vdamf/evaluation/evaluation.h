// SPDX-License-Identifier: BSD-3-Clause
// All that truth says of tracks, in one value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vdamf/evaluation/clear_mot.h"
#include "vdamf/evaluation/consistency.h"
#include "vdamf/evaluation/error_summary.h"
#include "vdamf/evaluation/hota.h"
#include "vdamf/evaluation/identity_score.h"
#include "vdamf/evaluation/object_scores.h"
#include "vdamf/evaluation/pose_errors.h"
#include "vdamf/evaluation/roc.h"
#include "vdamf/evaluation/sequence.h"

namespace vdamf
{
struct EvaluationOptions
{
    ScoringOptions scoring;
    double pairOverlap = kPairOverlap;  ///< of the pairs whose errors are told
    double stillSpeed = 0.3;            ///< objects slower than this stand still, m/s
    bool trackedSpan = false;           ///< told alone: the truth is that of the tracks' times
    RocOptions roc;
};

/// What was scored.
struct EvaluatedCounts
{
    std::size_t frames = 0;
    double seconds = 0.0;
    std::size_t objects = 0;       ///< that count in a frame
    std::size_t objectRows = 0;    ///< objects that count, summed over the frames
    std::size_t dontCareRows = 0;  ///< other truth
    std::size_t trackRows = 0;     ///< scored tracks, summed over the frames
    bool hasProbability = false;   ///< any track has a vehicle_probability
    double falseAlarmsPerFrame = 0.0;
};

/// How objects came to be tracked; `found` as for detection.
struct Coverage
{
    double everTracked = 0.0;     ///< share of the objects
    ErrorStatistics timeToFirst;  ///< of those, s
    ErrorStatistics longestGap;   ///< of those, s
};

/// NEES of measured (confirmed) tracks on objects, and NIS.
struct ConsistencyReport
{
    Consistency neesPose;  ///< x, y, heading
    Consistency neesSpeed;
    Consistency neesSize;    ///< length, width
    Consistency nisMatched;  ///< of tracks on objects
    Consistency nisAll;      ///< of all tracks that are scored
};

struct Evaluation
{
    EvaluationOptions options;
    EvaluatedCounts counts;
    ClearMot clearMot;
    Hota hota;
    IdentityScore identity;
    Coverage coverage;
    std::vector<ObjectScore> objects;
    std::vector<PoseError> pairs;  ///< all of the below are statistics of these
    ErrorSummary errors;
    std::vector<ErrorGroup> errorsByRange;
    std::vector<ErrorGroup> errorsByPoints;
    std::vector<ErrorGroup> errorsByFaces;
    std::vector<ErrorGroup> errorsByLengthSigma;
    std::size_t flipsOfMoving = 0;
    ErrorStatistics phantomSpeed;
    ErrorStatistics standingScatter;
    ConsistencyReport consistency;
    std::optional<Roc> roc;  ///< nothing without probabilities of both vehicles and clutter
};

/// Throws as makeSequence().
Evaluation evaluate(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                    const EvaluationOptions& options = {});

}  // namespace vdamf
