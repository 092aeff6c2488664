// SPDX-License-Identifier: BSD-3-Clause
// From labelled tracks over folds to a model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "vdamf/learning/folds.h"
#include "vdamf/learning/linear_classifier.h"
#include "vdamf/learning/train.h"
#include "vdamf/tracking/discrimination/classify.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
const DiscriminationGrid kGrid;

// Tracks of 6 frames; vehicles have more in cell 5, clutter in cell 9, with noise.
std::vector<TrackSamples> exampleTracks(int count)
{
    std::mt19937 random(17);
    std::normal_distribution<float> noise(0.0F, 0.25F);
    std::vector<TrackSamples> tracks;
    for (int i = 0; i < count; ++i)
    {
        TrackSamples track;
        track.group = "group " + std::to_string(i / 2);
        const bool vehicle = (i / 2) % 3 == 0;
        for (int k = 0; k < 6; ++k)
        {
            ObjectSample s;
            s.track = static_cast<std::uint64_t>(i);
            s.time = k;
            s.hits = 60;
            s.label = vehicle ? ObjectLabel::Vehicle : ObjectLabel::Clutter;
            if (k == 0) s.label = ObjectLabel::Unknown;
            const float cell5 = (vehicle ? 0.6F : 0.3F) + noise(random);
            s.features = {{5, cell5}, {9, 0.9F - cell5}};
            track.frames.push_back(s);
        }
        tracks.push_back(track);
    }
    return tracks;
}

Training trained(const std::vector<TrackSamples>& tracks, std::uint64_t seed = 1)
{
    TrainingOptions options;
    options.folds = 4;
    options.costs = {0.1, 1.0};
    options.seed = seed;
    return trainClassifier(tracks, kGrid, options, [](const std::string&) {});
}

TEST(Folds, NeverSplitAGroupAndAreBalanced)
{
    const std::vector<TrackSamples> tracks = exampleTracks(120);
    const std::vector<int> foldOf = foldsOf(tracks, 4, 3);
    std::map<std::string, std::set<int>> folds;
    std::map<int, int> vehicles;
    for (std::size_t i = 0; i < tracks.size(); ++i)
    {
        folds[tracks[i].group].insert(foldOf[i]);
        vehicles[foldOf[i]] += tracks[i].frames[1].label == ObjectLabel::Vehicle ? 1 : 0;
    }
    for (const auto& [group, in] : folds) EXPECT_EQ(in.size(), 1U) << group;
    ASSERT_EQ(vehicles.size(), 4U);
    for (const auto& [fold, count] : vehicles) EXPECT_EQ(count, 10) << fold;
    EXPECT_EQ(foldsOf(tracks, 4, 3), foldOf);
    EXPECT_NE(foldsOf(tracks, 4, 4), foldOf);
}

TEST(Training, FindsWhatTellsVehiclesAndIsCalibratedOnHeldOutTracks)
{
    const std::vector<TrackSamples> tracks = exampleTracks(300);
    const Training t = trained(tracks);
    EXPECT_GT(t.model.weights[5], 0.0);
    EXPECT_LT(t.model.weights[9], 0.0);
    EXPECT_EQ(t.model.weights.size(), featureCount(kGrid));
    EXPECT_EQ(t.heldOut.size(), 300U * 5U);
    int right = 0;
    int last = 0;
    double vehicles = 0.0;
    double told = 0.0;
    for (const HeldOutFrame& f : t.heldOut)
    {
        const bool vehicle = f.sample->label == ObjectLabel::Vehicle;
        vehicles += vehicle ? 1.0 : 0.0;
        told += f.frameProbability;
        if (!f.isLastOfTrack) continue;
        ++last;
        right += (f.trackProbability > 0.5) == vehicle ? 1 : 0;
    }
    EXPECT_EQ(last, 300);
    EXPECT_GT(right, 275);
    EXPECT_NEAR(told / vehicles, 1.0, 0.05);
    EXPECT_EQ(t.counts.vehicleTracks, 100U);
    EXPECT_EQ(t.counts.clutterFrames, 1000U);
}

// Tracks of vehicles but one in five left out.
std::vector<TrackSamples> withRareVehicles(const std::vector<TrackSamples>& tracks)
{
    std::vector<TrackSamples> rare;
    int vehicles = 0;
    for (const TrackSamples& track : tracks)
    {
        const bool isVehicle = track.frames.back().label == ObjectLabel::Vehicle;
        if (!isVehicle || vehicles++ % 5 == 0) rare.push_back(track);
    }
    return rare;
}

// Vehicles told over those there are.
double toldShare(const DiscriminatorModel& model, const std::vector<TrackSamples>& tracks)
{
    double told = 0.0;
    double vehicles = 0.0;
    for (const HeldOutFrame& f : judge(model, tracks))
    {
        told += f.frameProbability;
        vehicles += f.sample->label == ObjectLabel::Vehicle ? 1.0 : 0.0;
    }
    return told / vehicles;
}

TEST(Training, IsCalibratedForTheShareOfVehiclesWhereTheModelIsUsed)
{
    const std::vector<TrackSamples> tracks = exampleTracks(900);
    const std::vector<TrackSamples> there = withRareVehicles(tracks);
    TrainingOptions options;
    options.folds = 4;
    options.costs = {1.0};
    const auto model = [&] { return trainClassifier(tracks, kGrid, options, [](auto&) {}).model; };
    EXPECT_GT(toldShare(model(), there), 1.5);
    options.vehicleShare = 1.0 / 11.0;
    const DiscriminatorModel rare = model();
    EXPECT_NEAR(toldShare(rare, there), 1.0, 0.1);
    EXPECT_NEAR(rare.frame.prior, std::log(0.1), 1e-3);
    double told = 0.0;
    for (const HeldOutFrame& f : judge(rare, there))
        told += f.isLastOfTrack ? f.trackProbability : 0.0;
    EXPECT_NEAR(told, 60.0, 6.0);
}

TEST(Training, IsTheSameForTheSameSeed)
{
    const std::vector<TrackSamples> tracks = exampleTracks(80);
    EXPECT_EQ(toText(trained(tracks).model), toText(trained(tracks).model));
    EXPECT_NE(toText(trained(tracks, 2).model), toText(trained(tracks).model));
}

TEST(Training, IsTheSameWithAnyNumberOfThreads)
{
    const std::vector<TrackSamples> tracks = exampleTracks(80);
    TrainingOptions options;
    options.costs = {0.1};
    const auto modelWith = [&](int threads)
    {
        options.threads = threads;
        return toText(trainClassifier(tracks, kGrid, options, [](const std::string&) {}).model);
    };
    const std::string one = modelWith(1);
    EXPECT_EQ(modelWith(2), one);
    EXPECT_EQ(modelWith(9), one);
}

TEST(Classifier, CountsASampleAsOftenAsItIsNamed)
{
    std::vector<TrackSamples> tracks = exampleTracks(30);
    std::vector<const ObjectSample*> once;
    std::vector<const ObjectSample*> thrice;
    for (const TrackSamples& track : tracks)
        for (const ObjectSample& sample : track.frames)
        {
            once.push_back(&sample);
            thrice.insert(thrice.end(), 3, &sample);
        }
    const std::size_t features = featureCount(kGrid);
    const LinearClassifier a = trainLinear(once, features, 0.3);
    const LinearClassifier b = trainLinear(thrice, features, 0.1);
    EXPECT_NEAR(a.weights[5], b.weights[5], 0.02 * std::abs(a.weights[5]));
    EXPECT_GT(std::abs(a.weights[5]), 0.01);
}

TEST(Training, JudgesOtherTracksByTheModelAlone)
{
    const std::vector<TrackSamples> tracks = exampleTracks(80);
    const Training t = trained(tracks);
    const std::vector<HeldOutFrame> judged = judge(t.model, tracks);
    ASSERT_EQ(judged.size(), t.heldOut.size());
    const DiscriminatorModel read = parseDiscriminatorModel(toText(t.model), "m.txt");
    const ObjectSample& sample = *judged[3].sample;
    std::vector<float> features(featureCount(kGrid), 0.0F);
    for (const SparseFeature& f : sample.features) features.at(f.index) = f.value;
    const double score = vehicleScore(read, features);
    EXPECT_NEAR(judged[3].frameProbability,
                toProbability(frameLogOdds(read.frame, score, sample.hits)), 1e-6);
}

TEST(Training, SaysWhatItLacks)
{
    std::vector<TrackSamples> tracks = exampleTracks(12);
    const auto errorOf = [](const std::vector<TrackSamples>& all)
    {
        try
        {
            trained(all);
        }
        catch (const std::runtime_error& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(errorOf(tracks), testing::HasSubstr("take fewer folds"));
    for (TrackSamples& track : tracks)
        for (ObjectSample& sample : track.frames) sample.label = ObjectLabel::Clutter;
    EXPECT_THAT(errorOf(tracks), testing::HasSubstr("both vehicles and clutter"));
}
}  // namespace
}  // namespace vdamf
