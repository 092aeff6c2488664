// SPDX-License-Identifier: BSD-3-Clause
#include "judged_tracks.h"

#include <cmath>

#include "vdamf/learning/calibrate.h"
#include "vdamf/learning/logistic.h"

namespace vdamf
{
namespace
{
std::vector<JudgedFrame> judgedFrames(const TrackSamples& track, const std::vector<double>& scores,
                                      const FrameCalibration& calibration)
{
    std::vector<JudgedFrame> frames;
    for (std::size_t k = 0; k < track.frames.size(); ++k)
    {
        const ObjectSample& sample = track.frames[k];
        frames.push_back({frameLogOdds(calibration, scores[k], sample.hits),
                          sample.label != ObjectLabel::Unknown,
                          sample.label == ObjectLabel::Vehicle});
    }
    return frames;
}
}  // namespace

Calibrations calibrate(const std::vector<TrackSamples>& tracks, const Scores& scores,
                       const std::vector<int>& foldOf, int without)
{
    std::vector<ScoredSample> samples;
    for (std::size_t i = 0; i < tracks.size(); ++i)
    {
        if (foldOf[i] == without) continue;
        for (std::size_t k = 0; k < tracks[i].frames.size(); ++k)
        {
            const ObjectSample& s = tracks[i].frames[k];
            if (s.label == ObjectLabel::Unknown) continue;
            samples.insert(samples.end(), static_cast<std::size_t>(tracks[i].weight),
                           {scores[i][k], s.hits, s.label == ObjectLabel::Vehicle});
        }
    }
    Calibrations result;
    result.frame = calibrateFrames(samples);
    std::vector<std::vector<JudgedFrame>> judged;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        if (foldOf[i] != without)
            judged.insert(judged.end(), static_cast<std::size_t>(tracks[i].weight),
                          judgedFrames(tracks[i], scores[i], result.frame));
    result.track = calibrateTracks(judged, result.frame.prior);
    return result;
}

Calibrations withVehicleShare(const Calibrations& calibrations, double share)
{
    Calibrations result = calibrations;
    result.frame.prior = std::log(share / (1.0 - share));
    const double change = result.frame.prior - calibrations.frame.prior;
    result.frame.offset += change;
    result.track.offset += change;
    return result;
}

double frameLoss(const std::vector<TrackSamples>& tracks, const Scores& scores)
{
    std::vector<ScoredSample> samples;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        for (std::size_t k = 0; k < tracks[i].frames.size(); ++k)
        {
            const ObjectSample& s = tracks[i].frames[k];
            if (s.label != ObjectLabel::Unknown)
                samples.push_back({scores[i][k], s.hits, s.label == ObjectLabel::Vehicle});
        }
    const FrameCalibration calibration = calibrateFrames(samples);
    Eigen::VectorXd logOdds(static_cast<Eigen::Index>(samples.size()));
    Eigen::VectorXd outcomes(logOdds.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        const auto row = static_cast<Eigen::Index>(i);
        logOdds(row) = frameLogOdds(calibration, samples[i].score, samples[i].hits);
        outcomes(row) = samples[i].vehicle ? 1.0 : 0.0;
    }
    return logLoss(logOdds, outcomes);
}

void appendJudged(std::vector<HeldOutFrame>& frames, const TrackSamples& track,
                  const std::vector<double>& scores, const Calibrations& calibrations)
{
    const std::vector<JudgedFrame> judged = judgedFrames(track, scores, calibrations.frame);
    const std::vector<double> course =
        courseOf(judged, calibrations.track, calibrations.frame.prior);
    bool hasAny = false;
    for (std::size_t k = 0; k < judged.size(); ++k)
    {
        if (!judged[k].counts) continue;
        frames.push_back({&track.frames[k], track.recording, toProbability(judged[k].logOdds),
                          toProbability(course[k]), false});
        hasAny = true;
    }
    if (hasAny) frames.back().isLastOfTrack = true;
}

std::vector<HeldOutFrame> crossCalibrated(const std::vector<TrackSamples>& tracks,
                                          const Scores& scores, const std::vector<int>& foldOf,
                                          int folds)
{
    std::vector<HeldOutFrame> frames;
    for (int fold = 0; fold < folds; ++fold)
    {
        const Calibrations calibrations = calibrate(tracks, scores, foldOf, fold);
        for (std::size_t i = 0; i < tracks.size(); ++i)
            if (foldOf[i] == fold) appendJudged(frames, tracks[i], scores[i], calibrations);
    }
    return frames;
}

}  // namespace vdamf
