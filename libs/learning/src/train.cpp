// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/train.h"

#include <algorithm>
#include <charconv>
#include <future>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "judged_tracks.h"
#include "vdamf/learning/calibrate.h"
#include "vdamf/learning/folds.h"
#include "vdamf/learning/linear_classifier.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
using Tracks = std::vector<TrackSamples>;

/// Evenly chosen labelled frames of the tracks outside of a fold.
std::vector<const ObjectSample*> trainingSet(const Tracks& tracks, const std::vector<int>& foldOf,
                                             int without, int framesPerTrack)
{
    std::vector<const ObjectSample*> set;
    for (std::size_t i = 0; i < tracks.size(); ++i)
    {
        if (foldOf[i] == without) continue;
        std::vector<const ObjectSample*> labelled;
        for (const ObjectSample& sample : tracks[i].frames)
            if (sample.label != ObjectLabel::Unknown) labelled.push_back(&sample);
        const std::size_t n = labelled.size();
        const std::size_t taken = std::min(n, static_cast<std::size_t>(framesPerTrack));
        for (std::size_t k = 0; k < taken; ++k)
            set.insert(set.end(), static_cast<std::size_t>(tracks[i].weight),
                       labelled[k * n / taken]);
    }
    return set;
}

/// Scores of all frames by classifiers that were not trained on their fold.
Scores heldOutScores(const Tracks& tracks, const std::vector<int>& foldOf, double cost,
                     std::size_t features, const TrainingOptions& options)
{
    const auto scoresOf = [&](int fold)
    {
        const LinearClassifier classifier =
            trainLinear(trainingSet(tracks, foldOf, fold, options.framesPerTrack), features, cost);
        Scores scores(tracks.size());
        for (std::size_t i = 0; i < tracks.size(); ++i)
        {
            if (foldOf[i] != fold) continue;
            for (const ObjectSample& sample : tracks[i].frames)
                scores[i].push_back(classifier.score(sample.features));
        }
        return scores;
    };
    Scores all(tracks.size());
    for (int first = 0; first < options.folds; first += options.threads)
    {
        std::vector<std::future<Scores>> running;
        for (int fold = first; fold < std::min(first + options.threads, options.folds); ++fold)
            running.push_back(std::async(std::launch::async, scoresOf, fold));
        for (std::future<Scores>& part : running)
        {
            Scores scores = part.get();
            for (std::size_t i = 0; i < scores.size(); ++i)
                if (!scores[i].empty()) all[i] = std::move(scores[i]);
        }
    }
    return all;
}

/// Enough digits for any use, and a short model file.
double rounded(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::general, 4);
    double result = 0.0;
    std::from_chars(text, end.ptr, result);
    return result;
}

void checkTracks(const Tracks& tracks, const TrainingCounts& counts, const TrainingOptions& options)
{
    if (counts.vehicleTracks == 0 || counts.clutterTracks == 0)
        throw std::runtime_error(
            "training needs tracks of both vehicles and clutter, but there are " +
            std::to_string(counts.vehicleTracks) + " and " + std::to_string(counts.clutterTracks));
    std::set<std::string> vehicles;
    std::set<std::string> clutter;
    for (const TrackSamples& track : tracks)
        for (const ObjectSample& sample : track.frames)
        {
            if (sample.label == ObjectLabel::Vehicle) vehicles.insert(track.group);
            if (sample.label == ObjectLabel::Clutter) clutter.insert(track.group);
        }
    const auto folds = static_cast<std::size_t>(options.folds);
    if (vehicles.size() < folds || clutter.size() < folds)
        throw std::runtime_error(
            "cross-validation in " + std::to_string(options.folds) +
            " folds needs as many groups with vehicles and with clutter, but there are " +
            std::to_string(vehicles.size()) + " and " + std::to_string(clutter.size()) +
            ": give more recordings, or take fewer folds");
}

DiscriminatorModel modelOf(const LinearClassifier& classifier, const DiscriminationGrid& grid,
                           const Calibrations& calibrations)
{
    DiscriminatorModel model;
    model.grid = grid;
    model.bias = rounded(classifier.bias);
    for (const double w : classifier.weights) model.weights.push_back(rounded(w));
    const FrameCalibration& f = calibrations.frame;
    model.frame = {rounded(f.slope), rounded(f.offset), rounded(f.slopePerDecade),
                   rounded(f.offsetPerDecade), rounded(f.prior)};
    const TrackCalibration& t = calibrations.track;
    model.track = {t.memory, t.correlation, rounded(t.slope), rounded(t.offset), t.cap};
    return model;
}
}  // namespace

TrainingCounts countsOf(const Tracks& tracks)
{
    TrainingCounts counts;
    for (const TrackSamples& track : tracks)
    {
        const auto count = [&](ObjectLabel label)
        {
            return static_cast<std::size_t>(std::count_if(track.frames.begin(), track.frames.end(),
                                                          [&](const ObjectSample& s)
                                                          { return s.label == label; }));
        };
        const std::size_t vehicles = count(ObjectLabel::Vehicle);
        const std::size_t clutter = count(ObjectLabel::Clutter);
        counts.vehicleFrames += vehicles;
        counts.clutterFrames += clutter;
        if (vehicles + clutter == 0) continue;
        ++(vehicles >= clutter ? counts.vehicleTracks : counts.clutterTracks);
    }
    return counts;
}

Training trainClassifier(const Tracks& tracks, const DiscriminationGrid& grid,
                         const TrainingOptions& options,
                         const std::function<void(const std::string&)>& progress)
{
    Training training;
    training.counts = countsOf(tracks);
    checkTracks(tracks, training.counts, options);
    const std::vector<int> foldOf = foldsOf(tracks, options.folds, options.seed);
    const std::size_t features = featureCount(grid);
    Scores best;
    for (const double cost : options.costs)
    {
        Scores scores = heldOutScores(tracks, foldOf, cost, features, options);
        const double loss = frameLoss(tracks, scores);
        std::ostringstream text;
        text << "cost " << cost << ": loss of held-out frames " << loss;
        progress(text.str());
        const auto less = [](const CostTrial& a, const CostTrial& b) { return a.loss < b.loss; };
        training.trials.push_back({cost, loss});
        if (std::min_element(training.trials.begin(), training.trials.end(), less)->cost != cost)
            continue;
        best = std::move(scores);
        training.cost = cost;
    }
    progress("calibration");
    training.heldOut = crossCalibrated(tracks, best, foldOf, options.folds);
    const int none = -1;
    const LinearClassifier classifier = trainLinear(
        trainingSet(tracks, foldOf, none, options.framesPerTrack), features, training.cost);
    Calibrations calibrations = calibrate(tracks, best, foldOf, none);
    if (options.vehicleShare) calibrations = withVehicleShare(calibrations, *options.vehicleShare);
    training.model = modelOf(classifier, grid, calibrations);
    return training;
}

std::vector<HeldOutFrame> judge(const DiscriminatorModel& model, const Tracks& tracks)
{
    const LinearClassifier classifier = {model.bias, model.weights};
    Scores scores(tracks.size());
    for (std::size_t i = 0; i < tracks.size(); ++i)
        for (const ObjectSample& sample : tracks[i].frames)
            scores[i].push_back(classifier.score(sample.features));
    std::vector<HeldOutFrame> frames;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        appendJudged(frames, tracks[i], scores[i], {model.frame, model.track});
    return frames;
}

}  // namespace vdamf
