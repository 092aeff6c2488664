// SPDX-License-Identifier: BSD-3-Clause
// What the measurement benchmark tells the fits beside the hits.
#include "vdamf/learning/clusters/simulated_clusters.h"

#include <gtest/gtest.h>

#include "measurement/methods.h"

namespace vdamf
{
namespace
{
LabelledClusters conditionOf(const std::string& name)
{
    for (const SimulatedKind& kind : simulatedKinds())
        if (kind.name == name) return simulatedCondition(kind, 5, 3);
    return {};
}

TEST(SimulatedConditions, TellTheSensorsNoiseAndWhatStandsThere)
{
    const LabelledClusters walls = conditionOf("noise");
    ASSERT_EQ(walls.samples.size(), 5U);
    const LabelledClusters cars = conditionOf("car");
    ASSERT_EQ(cars.samples.size(), 5U);
    for (const LabelledCluster& sample : walls.samples)
    {
        EXPECT_EQ(sample.rangeNoise, 0.1);
        EXPECT_FALSE(sample.isBody);
    }
    for (const LabelledCluster& sample : cars.samples)
    {
        EXPECT_EQ(sample.rangeNoise, 0.02);
        EXPECT_TRUE(sample.isBody);
    }
}

TEST(Methods, HandTheSensorsNoiseToTheFit)
{
    LabelledCluster sample = conditionOf("noise").samples.front();
    const std::vector<Method> methods = allMethods(MeasureOptions());
    for (const Method& method : methods)
    {
        if (method.name != "face_lines+start") continue;
        const Estimate told = method.estimate(sample);
        sample.rangeNoise = 0.01;
        const Estimate untold = method.estimate(sample);
        // Scatter that is not the sensor's is taken for the vehicle's shape.
        ASSERT_TRUE(told.measurement && untold.measurement);
        EXPECT_NE(told.box.x, untold.box.x);
        EXPECT_NE(told.measurement->covariance(0, 0), untold.measurement->covariance(0, 0));
        return;
    }
    FAIL() << "no method face_lines+start";
}

}  // namespace
}  // namespace vdamf
