// SPDX-License-Identifier: BSD-3-Clause
// The classifier and the calibrations on samples whose answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "vdamf/learning/calibrate.h"
#include "vdamf/learning/linear_classifier.h"
#include "vdamf/learning/logistic.h"

namespace vdamf
{
namespace
{
std::vector<const ObjectSample*> pointersTo(const std::vector<ObjectSample>& samples)
{
    std::vector<const ObjectSample*> pointers;
    for (const ObjectSample& s : samples) pointers.push_back(&s);
    return pointers;
}

// Vehicles have more of feature 0, clutter of feature 2; feature 1 says nothing.
std::vector<ObjectSample> exampleSamples(int count, double vehicleShare)
{
    std::mt19937 random(5);
    std::normal_distribution<float> noise(0.0F, 0.2F);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    std::vector<ObjectSample> samples;
    for (int i = 0; i < count; ++i)
    {
        ObjectSample s;
        s.label = any(random) < vehicleShare ? ObjectLabel::Vehicle : ObjectLabel::Clutter;
        const float side = s.label == ObjectLabel::Vehicle ? 0.7F : 0.1F;
        s.features = {{0, side + noise(random)}, {1, noise(random)}, {2, 0.8F - side}};
        samples.push_back(s);
    }
    return samples;
}

TEST(LinearClassifier, SeparatesWhatCanBeSeparated)
{
    for (const double share : {0.05, 0.5, 0.9})
    {
        const std::vector<ObjectSample> samples = exampleSamples(500, share);
        const LinearClassifier c = trainLinear(pointersTo(samples), 3, 1.0);
        ASSERT_EQ(c.weights.size(), 3U);
        EXPECT_GT(c.weights[0], 0.2);
        EXPECT_LT(c.weights[2], -0.2);
        EXPECT_LT(std::abs(c.weights[1]), 0.1);
        int right = 0;
        for (const ObjectSample& s : samples)
            right += (c.score(s.features) > 0.0) == (s.label == ObjectLabel::Vehicle) ? 1 : 0;
        EXPECT_GT(right, 485) << share;
    }
}

TEST(LinearClassifier, IsTheSameWhateverLabelComesFirst)
{
    std::vector<ObjectSample> samples = exampleSamples(200, 0.5);
    const LinearClassifier forwards = trainLinear(pointersTo(samples), 3, 1.0);
    std::stable_sort(samples.begin(), samples.end(),
                     [](const ObjectSample& a, const ObjectSample& b)
                     { return a.label < b.label; });
    const LinearClassifier clutterFirst = trainLinear(pointersTo(samples), 3, 1.0);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(forwards.weights[i], clutterFirst.weights[i], 1e-2);
    EXPECT_NEAR(forwards.bias, clutterFirst.bias, 1e-2);
}

TEST(LinearClassifier, NeedsBothKinds)
{
    const std::vector<ObjectSample> samples = exampleSamples(20, 1.1);
    EXPECT_THROW(trainLinear(pointersTo(samples), 3, 1.0), std::runtime_error);
    EXPECT_THROW(trainLinear({}, 3, 1.0), std::runtime_error);
}

TEST(Logistic, FindsTheCoefficientsThatMadeTheData)
{
    std::mt19937 random(9);
    std::normal_distribution<double> any(0.0, 1.0);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    constexpr Eigen::Index kCount = 20000;
    LogisticData data{Eigen::MatrixXd::Ones(kCount, 3), Eigen::VectorXd(kCount)};
    const Eigen::Vector3d truth(1.5, -0.7, 0.4);
    for (Eigen::Index i = 0; i < kCount; ++i)
    {
        data.predictors(i, 0) = any(random);
        data.predictors(i, 1) = any(random);
        const double logOdds = data.predictors.row(i).dot(truth);
        data.outcomes(i) = chance(random) < toProbability(logOdds) ? 1.0 : 0.0;
    }
    const Eigen::VectorXd found = fitLogistic(data);
    for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(found(i), truth(i), 0.08);
}

TEST(Logistic, StaysFiniteWhereOutcomesCanBeSeparated)
{
    LogisticData data{Eigen::MatrixXd::Ones(4, 2), Eigen::VectorXd(4)};
    data.predictors.col(0) << -2.0, -1.0, 1.0, 2.0;
    data.outcomes << 0.0, 0.0, 1.0, 1.0;
    const Eigen::VectorXd c = fitLogistic(data);
    EXPECT_TRUE(c.allFinite());
    EXPECT_LT(logLoss(data.predictors * c, data.outcomes), 0.1);
}

TEST(Logistic, LossOfWildLogOddsIsFinite)
{
    const Eigen::Vector2d logOdds(1e4, -1e4);
    EXPECT_NEAR(logLoss(logOdds, Eigen::Vector2d(1.0, 0.0)), 0.0, 1e-12);
    EXPECT_NEAR(logLoss(logOdds, Eigen::Vector2d(0.0, 1.0)), 1e4, 1e-6);
}

TEST(Calibration, OfFramesTellsTheShareOfVehicles)
{
    std::mt19937 random(11);
    std::normal_distribution<double> any(0.0, 1.5);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    std::vector<ScoredSample> samples;
    for (int i = 0; i < 20000; ++i)
    {
        const std::size_t hits = i % 2 == 0 ? 15 : 500;
        const double score = any(random);
        const double slope = hits == 15 ? 0.5 : 2.0;
        samples.push_back({score, hits, chance(random) < toProbability(slope * score - 0.3)});
    }
    const FrameCalibration c = calibrateFrames(samples);
    EXPECT_NEAR(frameLogOdds(c, 1.0, 15), 0.2, 0.15);
    EXPECT_NEAR(frameLogOdds(c, 1.0, 500), 1.7, 0.15);
}

TEST(Calibration, OfFramesNeverTurnsTheScoreRound)
{
    std::vector<ScoredSample> samples;
    for (int i = 0; i < 100; ++i) samples.push_back({i % 2 == 0 ? 1.0 : -1.0, 50, i % 2 != 0});
    const FrameCalibration c = calibrateFrames(samples);
    for (const std::size_t hits : {5, 50, 2000})
        EXPECT_GT(frameLogOdds(c, 1.0, hits), frameLogOdds(c, -1.0, hits));
}

// Tracks whose frames all say the same carry no more than one frame does.
TEST(Calibration, OfTracksFindsHowAlikeFramesAre)
{
    std::mt19937 random(13);
    std::normal_distribution<double> noise(0.0, 1.0);
    const auto tracks = [&](double ofTrack, double ofFrame)
    {
        std::vector<std::vector<JudgedFrame>> all;
        for (int i = 0; i < 400; ++i)
        {
            const bool vehicle = i % 2 == 0;
            const double shared = ofTrack * noise(random);
            std::vector<JudgedFrame> track;
            for (int k = 0; k < 20; ++k)
                track.push_back(
                    {(vehicle ? 1.0 : -1.0) + shared + ofFrame * noise(random), true, vehicle});
            all.push_back(track);
        }
        return all;
    };
    EXPECT_GT(calibrateTracks(tracks(1.4, 0.0), 0.0).correlation, 0.4);
    EXPECT_LT(calibrateTracks(tracks(0.0, 1.4), 0.0).correlation, 0.1);
}
}  // namespace
}  // namespace vdamf
