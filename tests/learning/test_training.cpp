// SPDX-License-Identifier: BSD-3-Clause
// From labels over folds to a model: on made-up tracks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "vdamf/learning/folds.h"
#include "vdamf/learning/label.h"
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
    const double score = vehicleScore(read, toDense(sample.features, featureCount(kGrid)));
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

// Truth and tracks of one frame at time 5.
struct Scene
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;

    void object(const std::string& id, const std::string& objectClass, double x, int points = 100)
    {
        TruthRow row;
        row.time = 5.0;
        row.objectId = id;
        row.objectClass = objectClass;
        row.box = {x, 0.0, 0.0, 4.4, 1.8};
        row.points = points;
        truth.push_back(row);
    }
    void track(std::uint64_t id, double x, double y = 0.0, double time = 5.0)
    {
        TrackRow row;
        row.time = time;
        row.report.id = id;
        row.report.status = TrackStatus::Confirmed;
        row.report.box = {x, y, 0.0, 4.4, 1.8};
        tracks.push_back(row);
    }
    ObjectLabel labelOf(std::uint64_t id) const
    {
        ScoringOptions options;
        options.minPoints = 10;
        for (const LabelledRow& row : labelTracks(truth, tracks, options))
            if (row.track == id) return row.label;
        return ObjectLabel::Unknown;
    }
};

TEST(Labels, AreByWhatTheTrackLiesOn)
{
    Scene scene;
    scene.object("car", "Car", 0.0);
    scene.object("person", "Pedestrian", 20.0);
    scene.object("far", "Van", 40.0, 3);
    scene.track(1, 0.5);
    scene.track(2, 20.0);
    scene.track(3, 40.0);
    scene.track(4, 60.0);
    scene.track(5, 3.6);        // touches the car with its end
    scene.track(6, 0.0, 1.75);  // a hedge beside it that reaches 5 cm into it
    EXPECT_EQ(scene.labelOf(1), ObjectLabel::Vehicle);
    EXPECT_EQ(scene.labelOf(2), ObjectLabel::Clutter);
    EXPECT_EQ(scene.labelOf(3), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(4), ObjectLabel::Clutter);
    EXPECT_EQ(scene.labelOf(5), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(6), ObjectLabel::Clutter);
}

TEST(Labels, AreUnknownWhereTheTruthSaysNothingOfTheTime)
{
    Scene scene;
    scene.object("car", "Car", 0.0);
    scene.truth.push_back(scene.truth.front());
    scene.truth.back().time = 6.0;
    scene.track(1, 60.0, 0.0, 5.5);
    scene.track(2, 60.0, 0.0, 6.0);
    EXPECT_EQ(scene.labelOf(1), ObjectLabel::Unknown);
    EXPECT_EQ(scene.labelOf(2), ObjectLabel::Clutter);
}

// A drive whose sector of 90 degrees ahead is labelled: the sensor moves on along x.
struct Drive
{
    std::vector<TruthRow> truth;
    std::vector<TrackRow> tracks;

    void frame(double time, double sensorX)
    {
        TruthRow row;
        row.time = time;
        row.objectId = "car";
        row.objectClass = "Car";
        row.box = {200.0, 0.0, 0.0, 4.4, 1.8};
        row.points = 100;
        row.sensor = PlanePose{sensorX, 0.0, 0.0};
        truth.push_back(row);
    }
    void track(std::uint64_t id, double time, double x, double y)
    {
        TrackRow row;
        row.time = time;
        row.report.id = id;
        row.report.status = TrackStatus::Confirmed;
        row.report.box = {x, y, 0.0, 4.4, 1.8};
        tracks.push_back(row);
    }
    ObjectLabel labelOf(std::uint64_t id, double time) const
    {
        ScoringOptions options;
        options.minPoints = 10;
        options.regionFov = kPi / 2.0;
        for (const LabelledRow& row : labelTracks(truth, tracks, options))
            if (row.track == id && row.time == time) return row.label;
        return ObjectLabel::Unknown;
    }
};

TEST(Labels, StayWithWhatStandsBehindTheLabelledSector)
{
    Drive drive;
    drive.frame(1.0, 0.0);
    drive.frame(2.0, 30.0);
    drive.track(1, 1.0, 20.0, 5.0);  // a hedge that stays behind
    drive.track(1, 2.0, 20.2, 5.0);
    drive.track(2, 1.0, 20.0, -5.0);  // what moves may be something else by now
    drive.track(2, 2.0, 26.0, -5.0);
    drive.track(3, 2.0, 10.0, 8.0);  // never in the sector
    EXPECT_EQ(drive.labelOf(1, 1.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(1, 2.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(2, 1.0), ObjectLabel::Clutter);
    EXPECT_EQ(drive.labelOf(2, 2.0), ObjectLabel::Unknown);
    EXPECT_EQ(drive.labelOf(3, 2.0), ObjectLabel::Unknown);
}

TEST(Labels, OfVehiclesHoldOutsideOfTheSectorAndWhereTheyAreNotLabelledAnyMore)
{
    Drive drive;
    drive.frame(1.0, 0.0);
    drive.truth[0].box = {-10.0, 3.0, 0.0, 4.4, 1.8};  // labelled although it is behind
    drive.track(1, 1.0, -10.0, 3.0);
    drive.frame(2.0, 0.0);
    drive.track(1, 2.0, -10.1, 3.0);  // not labelled: still the same
    drive.track(2, 1.0, -10.0, 3.0);
    drive.track(2, 2.0, 30.0, 3.0);  // in the sector, but it was a vehicle before
    EXPECT_EQ(drive.labelOf(1, 1.0), ObjectLabel::Vehicle);
    EXPECT_EQ(drive.labelOf(1, 2.0), ObjectLabel::Vehicle);
    EXPECT_EQ(drive.labelOf(2, 2.0), ObjectLabel::Unknown);
}

TEST(Samples, OfOneObjectShareAGroup)
{
    std::vector<ObjectSample> samples;
    for (const std::uint64_t track : {7U, 4U, 9U, 4U})
    {
        ObjectSample s;
        s.track = track;
        s.time = static_cast<double>(samples.size());
        if (track != 9) s.object = "car";
        samples.push_back(s);
    }
    const std::vector<TrackSamples> tracks = groupedByTrack(samples, 2, "drive", "");
    ASSERT_EQ(tracks.size(), 3U);
    EXPECT_EQ(tracks[0].frames.size(), 2U);
    EXPECT_LT(tracks[0].frames[0].time, tracks[0].frames[1].time);
    EXPECT_EQ(tracks[0].group, tracks[1].group);
    EXPECT_NE(tracks[0].group, tracks[2].group);
    EXPECT_EQ(groupedByTrack(samples, 2, "drive", "scene")[2].group, "scene");
}
}  // namespace
}  // namespace vdamf
