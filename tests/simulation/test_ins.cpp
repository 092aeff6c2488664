// SPDX-License-Identifier: BSD-3-Clause
// The simulated INS: exact where nothing is asked for, else with the errors that were.
#include "vdamf/simulation/ins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace vdamf
{
namespace
{
Scenario scenarioWithIns(const std::string& ins)
{
    return readScenario(IniDocument::parse(
        "[scenario]\nins_rate_hz = 100\n[platform]\nspeed_mps = 5\nheading_deg = 30\n[ins]\n" + ins,
        "ins.ini"));
}

std::vector<InsSample> samplesOf(const Scenario& scenario, int count)
{
    InsSimulator ins(scenario);
    std::vector<InsSample> samples;
    for (int i = 0; i < count; ++i) samples.push_back(ins.next());
    return samples;
}

/// Errors along x.
std::vector<double> errorsOf(const Scenario& scenario, int count)
{
    std::vector<double> errors;
    for (const InsSample& sample : samplesOf(scenario, count))
    {
        errors.push_back(sample.pose.position.x() -
                         platformPoseAt(scenario.scene, sample.sceneTime).position.x());
    }
    return errors;
}

double meanOfProducts(const std::vector<double>& values, std::size_t lag)
{
    double sum = 0.0;
    for (std::size_t i = lag; i < values.size(); ++i) sum += values[i] * values[i - lag];
    return sum / static_cast<double>(values.size() - lag);
}

TEST(Ins, WithoutErrorsIsThePlatform)
{
    const Scenario scenario = scenarioWithIns("");
    for (const InsSample& sample : samplesOf(scenario, 50))
    {
        const GroundPose exact = platformPoseAt(scenario.scene, sample.sceneTime);
        EXPECT_EQ(sample.pose.position, exact.position);
        EXPECT_EQ(sample.pose.heading, exact.heading);
        EXPECT_FALSE(sample.isLost);
    }
}

TEST(Ins, TheFirstSampleIsExactWhateverTheErrors)
{
    const Scenario scenario = scenarioWithIns(
        "position_noise_m = 1\nposition_bias_m = 5\nheading_noise_deg = 3\nloss_share = 0.9\n"
        "tilt_noise_deg = 2\n");
    const InsSample first = samplesOf(scenario, 1).front();
    const GroundPose exact = platformPoseAt(scenario.scene, 0.0);
    EXPECT_EQ(first.pose.position, exact.position);
    EXPECT_EQ(first.pose.heading, exact.heading);
    EXPECT_EQ(first.pose.roll, exact.roll);
    EXPECT_FALSE(first.isLost);
}

TEST(Ins, WhiteNoiseHasItsDeviationAndNoMemory)
{
    const std::vector<double> errors = errorsOf(scenarioWithIns("position_noise_m = 0.2\n"), 20000);
    EXPECT_NEAR(std::sqrt(meanOfProducts(errors, 0)), 0.2, 0.005);
    EXPECT_NEAR(meanOfProducts(errors, 1) / meanOfProducts(errors, 0), 0.0, 0.03);
}

TEST(Ins, BiasDriftsWithItsDeviationAndTime)
{
    const std::vector<double> errors =
        errorsOf(scenarioWithIns("position_bias_m = 0.5\nbias_time_s = 1\n"), 200000);
    const double variance = meanOfProducts(errors, 0);
    EXPECT_NEAR(std::sqrt(variance), 0.5, 0.04);
    EXPECT_NEAR(meanOfProducts(errors, 100) / variance, std::exp(-1.0), 0.08);
    EXPECT_LT(std::abs(errors[1]), 0.3);  // it starts at 0
}

TEST(Ins, SingleLossesAndGaps)
{
    int lost = 0;
    for (const InsSample& sample : samplesOf(scenarioWithIns("loss_share = 0.3\n"), 10000))
        lost += sample.isLost ? 1 : 0;
    EXPECT_NEAR(lost, 3000, 200);

    for (const InsSample& sample :
         samplesOf(scenarioWithIns("gap_every_s = 4\ngap_length_s = 0.5\n"), 1000))
    {
        const double inPeriod = std::fmod(sample.sceneTime, 4.0);
        if (std::abs(inPeriod - 3.5) < 1e-6 || inPeriod > 4.0 - 1e-6) continue;
        EXPECT_EQ(sample.isLost, inPeriod > 3.5) << sample.sceneTime;
    }
}

TEST(Ins, HeadingNoiseAndItsSigmas)
{
    const Scenario scenario = scenarioWithIns("heading_noise_deg = 1\nheading_bias_deg = 0.5\n");
    double squares = 0.0;
    const std::vector<InsSample> samples = samplesOf(scenario, 5000);
    for (const InsSample& sample : samples) squares += std::pow(sample.pose.heading - kPi / 6.0, 2);
    EXPECT_NEAR(samples.back().headingSigma, std::hypot(1.0, 0.5) * kPi / 180.0, 1e-12);
    const double deviation = std::sqrt(squares / 5000.0);
    EXPECT_GT(deviation, 0.95 * kPi / 180.0);
    EXPECT_LT(deviation, 1.5 * kPi / 180.0);
}
}  // namespace
}  // namespace vdamf
