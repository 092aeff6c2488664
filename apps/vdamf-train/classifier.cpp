// SPDX-License-Identifier: BSD-3-Clause
#include "classifier.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "collect.h"
#include "outputs.h"
#include "pictures.h"
#include "quality.h"
#include "vdamf/files/folder.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
using Tracks = std::vector<TrackSamples>;

struct SampleCollection
{
    Tracks train;
    Tracks test;
};

void append(Tracks& all, Tracks more)
{
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

std::string countsText(const TrainingCounts& c)
{
    return std::to_string(c.vehicleTracks) + " vehicle tracks (" + std::to_string(c.vehicleFrames) +
           " frames), " + std::to_string(c.clutterTracks) + " clutter tracks (" +
           std::to_string(c.clutterFrames) + " frames)";
}

SampleCollection collectAll(const ClassifierJob& job, const std::atomic<bool>& stop)
{
    SampleCollection collection;
    for (std::size_t i = 0; i < job.recordings.size(); ++i)
    {
        const Recording& recording = job.recordings[i];
        Tracks tracks = namingRecording(
            recording.name,
            [&] { return collectSamples(recording, i, job.configuration, job.grid, stop); });
        const bool isTest = recording.options.use == RecordingUse::Test;
        if (!job.quiet)
            std::fprintf(stderr, "%s%s: %s\n", recording.name.c_str(), isTest ? " (test)" : "",
                         countsText(countsOf(tracks)).c_str());
        append(isTest ? collection.test : collection.train, std::move(tracks));
    }
    return collection;
}

std::vector<std::string> recordOf(const ClassifierJob& job, const Training& training,
                                  const QualityReport& quality)
{
    std::vector<std::string> record = {"vdamf-train " + job.version,
                                       "trained on " + countsText(training.counts)};
    std::string names;
    for (const Recording& recording : job.recordings)
        if (recording.options.use == RecordingUse::Train)
            names += (names.empty() ? "" : " ") + recording.name;
    record.push_back("recordings " + names);
    std::ostringstream options;
    options << "cost " << training.cost << ", folds " << job.training.folds << ", seed "
            << job.training.seed << ", frames per track " << job.training.framesPerTrack;
    if (job.training.vehicleShare) options << ", vehicle share " << *job.training.vehicleShare;
    record.push_back(options.str());
    const auto tell = [&](const char* name, const Quality& q)
    {
        if (!q.roc) return;
        std::string line = std::string(name) + ", held out: equal error rate " +
                           toFixedText(q.roc->scores.equalErrorRate, 4);
        if (q.roc->scores.missRateAtOnePercent)
            line +=
                ", found at 1 % false " + toFixedText(1.0 - *q.roc->scores.missRateAtOnePercent, 4);
        record.push_back(line + ", calibration error " +
                         toFixedText(q.reliability.expectedCalibrationError, 4));
    };
    tell("single frames", quality.frames);
    tell("single frames with 50 hits or more", quality.clearFrames);
    tell("tracks at each frame", quality.tracks);
    tell("tracks at each frame with 50 hits or more", quality.clearTracks);
    tell("tracks at their end", quality.tracksAtEnd);
    return record;
}

void tellTests(const ClassifierJob& job, const std::vector<HeldOutFrame>& frames)
{
    for (std::size_t i = 0; i < job.recordings.size(); ++i)
    {
        if (job.recordings[i].options.use != RecordingUse::Test) continue;
        std::vector<HeldOutFrame> ofThis;
        std::copy_if(frames.begin(), frames.end(), std::back_inserter(ofThis),
                     [&](const HeldOutFrame& f) { return f.recording == i; });
        std::printf("\nTest on %s, which was not trained on\n%s", job.recordings[i].name.c_str(),
                    qualityText(qualityOf(ofThis, {})).c_str());
    }
}

bool isCalled(const Recording& recording, const std::string& name)
{
    return recording.name == name || recording.options.scene == name;
}

/// How well a model does on a recording, or on all of a scene, that it knows nothing of.
void tellLeftOut(const ClassifierJob& job, Tracks& all, const std::string& name, double cost)
{
    Tracks without;
    Tracks leftOut;
    for (TrackSamples& track : all)
    {
        const bool isIt = isCalled(job.recordings[track.recording], name);
        (isIt ? leftOut : without).push_back(std::move(track));
    }
    TrainingOptions options = job.training;
    options.costs = {cost};
    Training training;
    try
    {
        training = trainClassifier(without, job.grid, options, [](const std::string&) {});
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error("--leave-out " + name + ": without it, " + error.what() +
                                 "; the model of all is in " + job.model.string());
    }
    std::printf("\nTrained without %s, tested on it\n%s", name.c_str(),
                qualityText(qualityOf(judge(training.model, leftOut), {})).c_str());
    std::fflush(stdout);
    all = std::move(without);
    append(all, std::move(leftOut));
}

/// Of held-out frames: which objects fool the discriminator.
std::string heldOutTable(const ClassifierJob& job, const std::vector<HeldOutFrame>& frames)
{
    std::string text =
        "recording,track_id,time_s,range_m,points,object_id,vehicle,frame_probability,"
        "track_probability\n";
    for (const HeldOutFrame& f : frames)
    {
        const ObjectSample& s = *f.sample;
        text +=
            job.recordings[f.recording].name + ',' + std::to_string(s.track & 0xFFFFFFFFU) + ',' +
            toFixedText(s.time, 6) + ',' + toFixedText(s.range, 2) + ',' + std::to_string(s.hits) +
            ',' + s.object + ',' + (s.label == ObjectLabel::Vehicle ? "1," : "0,") +
            toFixedText(f.frameProbability, 6) + ',' + toFixedText(f.trackProbability, 6) + '\n';
    }
    return text;
}

std::filesystem::path pictureFile(const ClassifierJob& job, const std::string& name)
{
    return job.plots / (name + ".svg");
}
}  // namespace

std::vector<std::filesystem::path> outputsOf(const ClassifierJob& job)
{
    std::vector<std::filesystem::path> outputs = {job.model};
    if (!job.heldOut.empty()) outputs.push_back(job.heldOut);
    if (!job.plots.empty())
        for (const std::string& name : classifierPictureNames())
            outputs.push_back(pictureFile(job, name));
    return outputs;
}

void checkLeaveOut(const ClassifierJob& job)
{
    for (const std::string& name : job.leaveOut)
    {
        const auto isIt = [&](const Recording& r)
        { return r.options.use == RecordingUse::Train && isCalled(r, name); };
        if (std::none_of(job.recordings.begin(), job.recordings.end(), isIt))
            throw std::runtime_error(
                "--leave-out " + name +
                ": no recording to train on, and no scene of one, has that name");
        const auto isTrainedOnWithout = [&](const Recording& r)
        { return r.options.use == RecordingUse::Train && !isCalled(r, name); };
        if (std::none_of(job.recordings.begin(), job.recordings.end(), isTrainedOnWithout))
            throw std::runtime_error("--leave-out " + name +
                                     ": no other recording to train on is left");
    }
}

void trainClassifier(const ClassifierJob& job, const std::atomic<bool>& stop)
{
    checkFiles(job.recordings);
    if (!job.plots.empty()) makeFolder(job.plots);
    Outputs outputs(outputsOf(job), job.overwrite);
    SampleCollection collection = collectAll(job, stop);
    const auto progress = [&](const std::string& line)
    {
        if (stop) throw std::runtime_error("interrupted");
        if (!job.quiet) std::fprintf(stderr, "%s\n", line.c_str());
    };
    Training training = trainClassifier(collection.train, job.grid, job.training, progress);
    const QualityReport quality = qualityOf(training.heldOut, {});
    training.model.record = recordOf(job, training, quality);
    std::printf("Trained on %s\nCross-validation: held-out tracks\n%s",
                countsText(training.counts).c_str(), qualityText(quality).c_str());
    const std::vector<HeldOutFrame> tested = judge(training.model, collection.test);
    if (!tested.empty()) tellTests(job, tested);
    const std::string model = toText(training.model);
    parseDiscriminatorModel(model, "the trained model");  // throws where numbers are not finite
    outputs.write(job.model, model);
    std::fflush(stdout);
    if (!job.heldOut.empty())
    {
        std::vector<HeldOutFrame> all = training.heldOut;
        all.insert(all.end(), tested.begin(), tested.end());
        outputs.write(job.heldOut, heldOutTable(job, all));
    }
    if (!job.plots.empty())
        for (const Picture& picture : classifierPictures(training.model, quality, collection.train))
            outputs.write(pictureFile(job, picture.name), picture.svg);
    // Last, as it moves the samples about.
    for (const std::string& name : job.leaveOut)
    {
        progress("training without " + name);
        tellLeftOut(job, collection.train, name, training.cost);
    }
}

}  // namespace vdamf
