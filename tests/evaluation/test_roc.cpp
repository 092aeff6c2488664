// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/roc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "example_pairs.h"

namespace vdamf
{
namespace
{
using Samples = std::vector<ClassifierSample>;

/// Scores of two normal distributions whose means are `separation` standard deviations apart,
/// `rows` samples a track, alike but for a little noise.
Samples normalSamples(int tracks, int rows, double separation, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Samples samples;
    for (int track = 0; track < tracks; ++track)
    {
        const bool vehicle = track % 2 == 0;
        const double mean = normal(random) + (vehicle ? separation : 0.0);
        for (int row = 0; row < rows; ++row)
        {
            const double score = 1.0 / (1.0 + std::exp(-mean - 0.01 * normal(random)));
            samples.push_back({static_cast<std::uint64_t>(track), score, vehicle});
        }
    }
    return samples;
}

TEST(Roc, OfFourSamplesByHand)
{
    // By falling score: vehicle, clutter, vehicle, clutter. Three of four pairs stand right.
    const auto roc = rocOf({{1, 0.9, true}, {2, 0.7, false}, {3, 0.6, true}, {4, 0.1, false}});
    ASSERT_TRUE(roc.has_value());
    EXPECT_DOUBLE_EQ(roc->scores.areaUnderCurve, 0.75);
    EXPECT_DOUBLE_EQ(roc->scores.equalErrorRate, 0.5);
    EXPECT_EQ(roc->vehicleSamples, 2U);
    EXPECT_EQ(roc->clutterSamples, 2U);
    EXPECT_EQ(roc->tracks, 4U);
    ASSERT_EQ(roc->curve.size(), 5U);
    EXPECT_EQ(roc->curve.front().truePositiveRate, 0.0);
    EXPECT_DOUBLE_EQ(roc->curve[1].truePositiveRate, 0.5);
    EXPECT_DOUBLE_EQ(roc->curve[1].threshold, 0.9);
    EXPECT_DOUBLE_EQ(roc->curve.back().falsePositiveRate, 1.0);
    // Two samples of clutter cannot show a rate of 1 %.
    EXPECT_FALSE(roc->scores.missRateAtOnePercent.has_value());
}

TEST(Roc, PerfectWorstAndBlind)
{
    const auto perfect = rocOf({{1, 0.9, true}, {2, 0.1, false}});
    EXPECT_DOUBLE_EQ(perfect->scores.areaUnderCurve, 1.0);
    EXPECT_DOUBLE_EQ(perfect->scores.equalErrorRate, 0.0);
    const auto worst = rocOf({{1, 0.1, true}, {2, 0.9, false}});
    EXPECT_DOUBLE_EQ(worst->scores.areaUnderCurve, 0.0);
    EXPECT_DOUBLE_EQ(worst->scores.equalErrorRate, 1.0);
    // One score for all: ties are half right, whatever their order.
    const auto blind = rocOf({{1, 0.5, true}, {2, 0.5, false}, {3, 0.5, true}});
    EXPECT_DOUBLE_EQ(blind->scores.areaUnderCurve, 0.5);
    EXPECT_DOUBLE_EQ(blind->scores.equalErrorRate, 0.5);
}

TEST(Roc, NeedsBothKinds)
{
    EXPECT_FALSE(rocOf({}).has_value());
    EXPECT_FALSE(rocOf({{1, 0.5, true}}).has_value());
    EXPECT_FALSE(rocOf({{1, 0.5, false}}).has_value());
}

TEST(Roc, OfNormalScoresIsAsTheTheorySays)
{
    const auto roc = rocOf(normalSamples(20000, 1, 2.0, 5), {20, 1});
    // AUC = Phi(d / sqrt 2), EER = Phi(-d / 2); the miss rate at 1 % is Phi(2.326 - d).
    EXPECT_NEAR(roc->scores.areaUnderCurve, 0.9214, 0.006);
    EXPECT_NEAR(roc->scores.equalErrorRate, 0.1587, 0.01);
    EXPECT_NEAR(roc->scores.missRateAtOnePercent.value(), 0.628, 0.04);
    EXPECT_NEAR(roc->scores.missRateAtOnePerMille.value(), 0.862, 0.05);
}

TEST(Roc, TheIntervalIsThatOfTracksNotOfRows)
{
    // 100 rows a track say no more than one: the interval must not shrink tenfold.
    const auto one = rocOf(normalSamples(200, 1, 1.0, 6));
    const auto many = rocOf(normalSamples(200, 100, 1.0, 6));
    const double width = one->high.areaUnderCurve - one->low.areaUnderCurve;
    const double widthOfMany = many->high.areaUnderCurve - many->low.areaUnderCurve;
    // Hanley and McNeil's standard error of an area of 0.76 from 100 + 100: 0.034.
    EXPECT_NEAR(width, 2 * 1.96 * 0.034, 0.03);
    EXPECT_NEAR(widthOfMany / width, 1.0, 0.35);
    EXPECT_LT(one->low.areaUnderCurve, one->scores.areaUnderCurve);
    EXPECT_GT(one->high.areaUnderCurve, one->scores.areaUnderCurve);
    EXPECT_LT(one->low.equalErrorRate, one->high.equalErrorRate);
}

TEST(Roc, IsTheSameEveryTimeAndInEveryOrder)
{
    Samples samples = normalSamples(100, 3, 1.0, 7);
    const auto first = rocOf(samples);
    const auto again = rocOf(samples);
    EXPECT_EQ(first->low.areaUnderCurve, again->low.areaUnderCurve);
    std::reverse(samples.begin(), samples.end());
    EXPECT_NEAR(rocOf(samples)->scores.areaUnderCurve, first->scores.areaUnderCurve, 1e-12);
}

TEST(ClassifierSamples, WhatATrackLiesOnIsWhatItIs)
{
    const TruthRow car = exampleCar();
    TruthRow walker = exampleCar(100.0, "walker");
    walker.objectClass = "Pedestrian";
    walker.box.x += 50.0;
    TruthRow unseen = exampleCar(100.0, "unseen");
    unseen.box.x += 100.0;
    std::vector<TrackRow> tracks = {trackOn(car, 1),
                                    moved(trackOn(car, 2), 0.5, 0.0),  // a second one on the car
                                    trackOn(walker, 3),
                                    trackOn(unseen, 4),
                                    moved(trackOn(car, 5), 30.0, 0.0),
                                    moved(trackOn(car, 6), 0.2, 0.0)};
    for (TrackRow& row : tracks)
    {
        if (row.report.id != 6)
            row.report.vehicleProbability = 0.1 * static_cast<double>(row.report.id);
    }
    const Sequence sequence = {{{100.0, {}, {car, walker, unseen}, {true, false, false}, tracks}}};
    const Samples samples = classifierSamples(sequence, 0.1);
    ASSERT_EQ(samples.size(), 4U);  // not the one on the car that does not count, nor track 6
    EXPECT_TRUE(samples[0].vehicle);
    EXPECT_TRUE(samples[1].vehicle);
    EXPECT_EQ(samples[2].trackId, 3U);
    EXPECT_FALSE(samples[2].vehicle);
    EXPECT_EQ(samples[3].trackId, 5U);
    EXPECT_FALSE(samples[3].vehicle);
    EXPECT_DOUBLE_EQ(samples[3].score, 0.5);
}

}  // namespace
}  // namespace vdamf
