// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/predicted_targets.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
PredictedTarget targetOf(double probability, double width, double height)
{
    Track track;
    track.state.mean << 10.0, 0.0, 0.0, 0.0, 0.0, 1.2, 4.5;
    track.state.width = width;
    track.height = height;
    track.judgement.probability = probability;
    return predictedTargets({track}, Discriminator(DiscriminatorOptions())).front();
}

TEST(PredictedTargets, ACarIsOneWhereThatIsSure)
{
    EXPECT_TRUE(targetOf(0.9, 1.8, 1.5).isCar);
    EXPECT_FALSE(targetOf(0.7, 1.8, 1.5).isCar);
}

TEST(PredictedTargets, WhatMayBeATruckIsNoCar)
{
    EXPECT_FALSE(targetOf(0.9, 2.5, 1.5).isCar) << "its cab may be out of view";
    EXPECT_FALSE(targetOf(0.9, 1.8, 2.8).isCar);
}

TEST(PredictedTargets, ClutterIsWhatSurelyIsNoVehicle)
{
    EXPECT_TRUE(targetOf(0.1, 1.8, 1.5).isClutter);
    EXPECT_FALSE(targetOf(0.4, 1.8, 1.5).isClutter);
}

}  // namespace
}  // namespace vdamf
