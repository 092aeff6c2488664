// SPDX-License-Identifier: BSD-3-Clause
// Scores, probabilities, and evidence over the frames of a track.
#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/tracking/discrimination/classify.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
double after(int frames, double logOdds, const TrackCalibration& calibration, double prior = 0.0)
{
    VehicleEvidence evidence;
    for (int i = 0; i < frames; ++i) evidence = withFrame(evidence, logOdds, calibration, prior);
    return trackLogOdds(evidence, calibration);
}

TEST(Score, IsLinearInTheFeatures)
{
    DiscriminatorModel model = untrainedModel();
    model.bias = -0.5;
    model.weights[3] = 2.0;
    model.weights.back() = -1.0;
    std::vector<float> features(model.weights.size(), 0.0F);
    EXPECT_DOUBLE_EQ(vehicleScore(model, features), -0.5);
    features[3] = 0.5F;
    features.back() = 0.25F;
    EXPECT_DOUBLE_EQ(vehicleScore(model, features), 0.25);
}

TEST(FrameLogOdds, FollowThePlattScalingAtTheHits)
{
    const FrameCalibration c = {2.0, 0.5, 1.0, -0.25, 0.0};
    EXPECT_NEAR(frameLogOdds(c, 1.5, 50), 3.5, 1e-12);
    EXPECT_NEAR(frameLogOdds(c, 1.5, 500), 3.0 * 1.5 + 0.25, 1e-12);
    EXPECT_EQ(frameLogOdds(c, 1.5, 2000), frameLogOdds(c, 1.5, 100000));
    EXPECT_EQ(frameLogOdds(c, 1.5, 0), frameLogOdds(c, 1.5, 5));
}

TEST(Evidence, GrowsWithFramesThatAgreeButNotWithoutEnd)
{
    TrackCalibration c;
    c.correlation = 0.25;
    c.cap = 20.0;
    EXPECT_NEAR(after(1, 1.0, c), 1.0, 1e-12);
    EXPECT_NEAR(after(5, 1.0, c), 2.5, 1e-12);
    EXPECT_GT(after(10, 1.0, c), after(5, 1.0, c));
    EXPECT_LT(after(10000, 1.0, c), 4.0);
    EXPECT_NEAR(after(5, -1.0, c), -2.5, 1e-12);
}

TEST(Evidence, OfIndependentFramesAddsUpToTheCap)
{
    TrackCalibration c;
    c.correlation = 0.0;
    EXPECT_NEAR(after(4, 1.0, c), 4.0, 1e-12);
    EXPECT_NEAR(after(100, 1.0, c), c.cap, 1e-12);
    EXPECT_NEAR(after(100, -1.0, c), -c.cap, 1e-12);
}

TEST(Evidence, CountsThePriorOnce)
{
    TrackCalibration c;
    c.offset = -1.0;
    // Frames that say no more than the prior leave the offset.
    EXPECT_NEAR(after(10, -1.0, c, -1.0), -1.0, 1e-12);
    EXPECT_NEAR(after(0, 0.0, c, -1.0), -1.0, 1e-12);
}

TEST(Evidence, OfOneWildFrameDoesNotDecide)
{
    TrackCalibration c;
    VehicleEvidence evidence;
    for (int i = 0; i < 10; ++i) evidence = withFrame(evidence, 2.0, c, 0.0);
    evidence = withFrame(evidence, -1e6, c, 0.0);
    EXPECT_GT(trackLogOdds(evidence, c), 0.0);
}

TEST(Evidence, FadesWithMemory)
{
    TrackCalibration c;
    c.memory = 0.9;
    VehicleEvidence evidence;
    for (int i = 0; i < 50; ++i) evidence = withFrame(evidence, 2.0, c, 0.0);
    for (int i = 0; i < 20; ++i) evidence = withFrame(evidence, -2.0, c, 0.0);
    EXPECT_LT(trackLogOdds(evidence, c), 0.0);
}

TEST(Probability, IsTheLogisticOfTheLogOdds)
{
    EXPECT_DOUBLE_EQ(toProbability(0.0), 0.5);
    EXPECT_NEAR(toProbability(std::log(9.0)), 0.9, 1e-12);
    EXPECT_GE(toProbability(-1e4), 0.0);
    EXPECT_LE(toProbability(1e4), 1.0);
}
}  // namespace
}  // namespace vdamf
