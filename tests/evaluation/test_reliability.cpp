// SPDX-License-Identifier: BSD-3-Clause
// Expected calibration error and Brier score of probabilities with known shares; bands of curves.
#include "vdamf/evaluation/reliability.h"

#include <gtest/gtest.h>

#include <random>

namespace vdamf
{
namespace
{
TEST(Reliability, OfTwoBinsByHand)
{
    // 0.2: one of four is a vehicle; 0.9: both are.
    const std::vector<ClassifierSample> samples = {{1, 0.2, true},  {2, 0.2, false},
                                                   {3, 0.2, false}, {4, 0.2, false},
                                                   {5, 0.9, true},  {6, 0.9, true}};
    const Reliability r = reliabilityOf(samples);
    ASSERT_EQ(r.bins.size(), 2U);
    EXPECT_EQ(r.bins[0].samples, 4U);
    EXPECT_NEAR(r.bins[0].probability, 0.2, 1e-12);
    EXPECT_NEAR(r.bins[0].share, 0.25, 1e-12);
    EXPECT_NEAR(r.bins[1].share, 1.0, 1e-12);
    EXPECT_NEAR(r.expectedCalibrationError, (4.0 * 0.05 + 2.0 * 0.1) / 6.0, 1e-12);
    EXPECT_NEAR(r.brierScore, (0.64 + 3.0 * 0.04 + 2.0 * 0.01) / 6.0, 1e-12);
}

TEST(Reliability, OfCertainProbabilitiesIsInTheOuterBins)
{
    const Reliability r = reliabilityOf({{1, 0.0, false}, {2, 1.0, true}});
    ASSERT_EQ(r.bins.size(), 2U);
    EXPECT_EQ(r.expectedCalibrationError, 0.0);
    EXPECT_EQ(r.brierScore, 0.0);
    EXPECT_TRUE(reliabilityOf({}).bins.empty());
}

TEST(Reliability, OfHonestProbabilitiesIsSmallAndOfOverconfidentOnesIsNot)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    std::vector<ClassifierSample> honest;
    std::vector<ClassifierSample> bold;
    for (std::uint64_t i = 0; i < 20000; ++i)
    {
        const double p = any(random);
        const bool vehicle = any(random) < p;
        honest.push_back({i, p, vehicle});
        bold.push_back({i, p < 0.5 ? 0.02 : 0.98, vehicle});
    }
    EXPECT_LT(reliabilityOf(honest).expectedCalibrationError, 0.02);
    EXPECT_GT(reliabilityOf(bold).expectedCalibrationError, 0.15);
}

TEST(RocBand, HoldsTheCurveAndIsWiderForFewerTracks)
{
    const auto samplesOf = [](std::uint64_t tracks)
    {
        std::mt19937_64 random(5);
        std::normal_distribution<double> noise(0.0, 0.15);
        std::vector<ClassifierSample> samples;
        for (std::uint64_t t = 0; t < tracks; ++t)
        {
            const double ofTrack = (t % 2 == 0 ? 0.6 : 0.4) + noise(random);
            for (int k = 0; k < 10; ++k)
                samples.push_back({t, ofTrack + 0.3 * noise(random), t % 2 == 0});
        }
        return samples;
    };
    const Roc many = *rocOf(samplesOf(400));
    const Roc few = *rocOf(samplesOf(40));
    ASSERT_EQ(many.band.size(), few.band.size());
    double widthOfMany = 0.0;
    double widthOfFew = 0.0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < many.band.size(); ++i)
    {
        const RocBandPoint& p = many.band[i];
        while (next + 1 < many.curve.size() &&
               many.curve[next + 1].falsePositiveRate <= p.falsePositiveRate)
            ++next;
        if (p.falsePositiveRate > 0.02)
        {
            EXPECT_GE(many.curve[next].truePositiveRate, p.low - 0.02);
            EXPECT_LE(many.curve[next].truePositiveRate, p.high + 0.02);
        }
        widthOfMany += p.high - p.low;
        widthOfFew += few.band[i].high - few.band[i].low;
    }
    EXPECT_LT(2.0 * widthOfMany, widthOfFew);
    EXPECT_NEAR(many.band.back().falsePositiveRate, 1.0, 1e-12);
    RocOptions without;
    without.replicates = 0;
    EXPECT_TRUE(rocOf(samplesOf(40), without)->band.empty());
}
}  // namespace
}  // namespace vdamf
