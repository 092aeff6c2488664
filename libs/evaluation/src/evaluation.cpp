// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/evaluation.h"

#include <algorithm>
#include <utility>

namespace vdamf
{
namespace
{
EvaluatedCounts countsOf(const Sequence& sequence, const ClearMot& clearMot,
                         const std::vector<TrackRow>& tracks)
{
    EvaluatedCounts counts;
    counts.frames = sequence.frames.size();
    counts.objects = clearMot.objects;
    for (const ScoredFrame& frame : sequence.frames)
    {
        for (const bool doesCount : frame.counts)
            ++(doesCount ? counts.objectRows : counts.dontCareRows);
        counts.trackRows += frame.tracks.size();
    }
    counts.hasProbability =
        std::any_of(tracks.begin(), tracks.end(),
                    [](const TrackRow& row) { return row.report.vehicleProbability.has_value(); });
    if (sequence.frames.empty()) return counts;
    counts.seconds = sequence.frames.back().time - sequence.frames.front().time;
    counts.falseAlarmsPerFrame =
        static_cast<double>(clearMot.falsePositives) / static_cast<double>(counts.frames);
    return counts;
}

Coverage coverageOf(const std::vector<ObjectScore>& objects)
{
    std::vector<double> times;
    std::vector<double> gaps;
    for (const ObjectScore& object : objects)
    {
        if (!object.timeToFirst) continue;
        times.push_back(*object.timeToFirst);
        gaps.push_back(object.longestGap);
    }
    Coverage coverage;
    if (objects.empty()) return coverage;
    coverage.everTracked = static_cast<double>(times.size()) / static_cast<double>(objects.size());
    coverage.timeToFirst = statisticsOf(times);
    coverage.longestGap = statisticsOf(gaps);
    return coverage;
}

std::vector<double> neesOfConfirmed(const std::vector<PoseError>& errors, double PoseError::*nees)
{
    std::vector<double> values;
    for (const PoseError& error : errors)
    {
        if (error.status == TrackStatus::Confirmed) values.push_back(error.*nees);
    }
    return values;
}

ConsistencyReport consistencyReport(const Sequence& sequence, const std::vector<PoseError>& errors)
{
    std::vector<double> all;
    for (const ScoredFrame& frame : sequence.frames)
    {
        for (const TrackRow& row : frame.tracks)
        {
            if (row.report.nis) all.push_back(*row.report.nis);
        }
    }
    std::vector<double> matched;
    for (const PoseError& error : errors)
    {
        if (error.nis) matched.push_back(*error.nis);
    }
    return {consistencyOf(neesOfConfirmed(errors, &PoseError::neesPose), 3),
            consistencyOf(neesOfConfirmed(errors, &PoseError::neesSpeed), 1),
            consistencyOf(neesOfConfirmed(errors, &PoseError::neesSize), 2),
            consistencyOf(matched, 3), consistencyOf(all, 3)};
}

Evaluation withErrors(Evaluation evaluation, const Sequence& sequence)
{
    evaluation.pairs = poseErrors(sequence, matchFrames(sequence, evaluation.options.pairOverlap));
    evaluation.errors = summaryOf(evaluation.pairs);
    evaluation.errorsByRange = byRange(evaluation.pairs);
    evaluation.errorsByPoints = byPoints(evaluation.pairs);
    evaluation.errorsByFaces = byFaces(evaluation.pairs);
    evaluation.errorsByLengthSigma = byLengthSigma(evaluation.pairs);
    evaluation.flipsOfMoving = flipsOfMoving(evaluation.pairs, evaluation.options.stillSpeed);
    evaluation.phantomSpeed = phantomSpeed(evaluation.pairs, evaluation.options.stillSpeed);
    evaluation.standingScatter = standingScatter(evaluation.pairs, evaluation.options.stillSpeed);
    evaluation.consistency = consistencyReport(sequence, evaluation.pairs);
    return evaluation;
}

/// Of all tracks, also of those that the discriminator rejects.
std::optional<Roc> rocOfAll(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                            const EvaluationOptions& options)
{
    ScoringOptions scoring = options.scoring;
    scoring.onlyVehicles = false;
    const Sequence sequence = makeSequence(truth, tracks, scoring);
    return rocOf(classifierSamples(sequence, options.pairOverlap), options.roc);
}
}  // namespace

Evaluation evaluate(const std::vector<TruthRow>& truth, const std::vector<TrackRow>& tracks,
                    const EvaluationOptions& options)
{
    const double overlap = options.scoring.overlap;
    const Sequence sequence = makeSequence(truth, tracks, options.scoring);
    const std::vector<FrameMatches> matches = matchFrames(sequence, overlap);
    Evaluation evaluation;
    evaluation.options = options;
    evaluation.clearMot = clearMot(sequence, matches);
    evaluation.hota = hotaOf(sequence);
    evaluation.identity = identityScore(sequence, overlap);
    evaluation.counts = countsOf(sequence, evaluation.clearMot, tracks);
    evaluation.objects = objectScores(sequence, matches);
    evaluation.coverage = coverageOf(evaluation.objects);
    evaluation = withErrors(std::move(evaluation), sequence);
    if (evaluation.counts.hasProbability) evaluation.roc = rocOfAll(truth, tracks, options);
    return evaluation;
}

}  // namespace vdamf
