// SPDX-License-Identifier: BSD-3-Clause
// What the measurement benchmark tells the fits beside the hits.
#include "vdamf/learning/clusters/simulated_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "measurement/methods.h"
#include "vdamf/tracking/matched_filter/hits.h"

namespace vdamf
{
namespace
{
LabelledClusters conditionOf(const std::string& name, int count = 5)
{
    for (const SimulatedKind& kind : simulatedKinds())
        if (kind.name == name) return simulatedCondition(kind, count, 3);
    return {};
}

// Of measured headings; positive ones turn the end that is nearer to the sensor towards it.
std::vector<double> headingErrors(const LabelledClusters& condition, const MeasureOptions& options)
{
    std::vector<double> errors;
    for (const LabelledCluster& sample : condition.samples)
    {
        const MeasureOptions told = toldOptions(options, sample);
        const Measurement m = measureTarget(projectHits(sample.cluster, told.mergeCell),
                                            sample.sensor, sample.start, told);
        const Eigen::Vector2d view = toBoxFrame(sample.truth, sample.sensor);
        const double error = std::remainder(m.box.heading - sample.truth.heading, 0.5 * kPi);
        errors.push_back(std::copysign(1.0, view.x() * view.y()) * error);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
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

TEST(CarsInTheNextLane, AreNotTurnedByTheirShape)
{
    const LabelledClusters cars = conditionOf("car_in_next_lane", 300);
    const auto median = [&](const MeasureOptions& options)
    {
        const std::vector<double> errors = headingErrors(cars, options);
        return errors[errors.size() / 2] / kDegree;
    };
    EXPECT_NEAR(median({}), 0.0, 0.1);
    MeasureOptions asTheyLook;
    asTheyLook.parameters.hull.sideTurn = 0.0;
    EXPECT_LT(median(asTheyLook), -0.2);
}

TEST(CarsInTheNextLane, ShowTheirSides)
{
    const LabelledClusters cars = conditionOf("car_in_next_lane", 600);
    const auto typical = [&](const MeasureOptions& options)
    {
        std::vector<double> errors = headingErrors(cars, options);
        for (double& error : errors) error = std::abs(error);
        std::sort(errors.begin(), errors.end());
        return errors[errors.size() * 4 / 5] / kDegree;
    };
    MeasureOptions endsAlone;
    endsAlone.minSideAngle = endsAlone.minEndAngle;
    EXPECT_LT(typical({}), 0.9 * typical(endsAlone));
}

TEST(CarsInTheNextLane, GoOnRoundTheirFarCorners)
{
    const LabelledClusters cars = conditionOf("car_in_next_lane", 300);
    const auto median = [&](const MeasureOptions& options)
    {
        std::vector<double> errors;
        for (const LabelledCluster& sample : cars.samples)
        {
            const MeasureOptions told = toldOptions(options, sample);
            const Measurement m = measureTarget(
                projectHits(sample.cluster, told.mergeCell), sample.sensor, sample.start, told,
                Eigen::Vector2d(sample.start.length, sample.start.width));
            if (!m.facesSeen.seesEnd() || !m.facesSeen.seesSide()) continue;
            errors.push_back(m.box.length - sample.truth.length);
        }
        std::sort(errors.begin(), errors.end());
        return errors[errors.size() / 2];
    };
    EXPECT_NEAR(median({}), 0.0, 0.06);
    MeasureOptions asFarAsHits;
    asFarAsHits.parameters.hull.farCorner = 0.0;
    EXPECT_LT(median(asFarAsHits), -0.08);
}

}  // namespace
}  // namespace vdamf
