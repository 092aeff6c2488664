// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/vehicle_cut.h"

#include <gtest/gtest.h>

#include <memory>

#include "tracking/association/predicted_car.h"
#include "types/append_hit.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
namespace
{
// Hits one above the other, along a line to the left of the sensor.
void addWall(Cluster& cluster, const Eigen::Vector2f& from, const Eigen::Vector2f& to, int columns)
{
    for (int i = 0; i < columns; ++i)
        for (const float height : {0.4F, 0.7F, 1.0F})
        {
            const Eigen::Vector2f p =
                from + (to - from) * (static_cast<float>(i) / static_cast<float>(columns - 1));
            cluster.x.push_back(p.x());
            cluster.y.push_back(p.y());
            cluster.z.push_back(height);
            cluster.height.push_back(height);
        }
}

// The side of a car from -2 to 2 m ahead, 4 m to the left, and a bush that goes on behind it.
SegmentedFrame carAndBush(const Eigen::Vector2f& from, const Eigen::Vector2f& to)
{
    SegmentedFrame frame;
    frame.clusters.resize(1);
    addWall(frame.clusters[0], {2.0F, 4.0F}, {-2.0F, 4.0F}, 40);
    addWall(frame.clusters[0], from, to, 40);
    frame.points = frame.clusters[0].size();
    return frame;
}

// Without a dent between them.
SegmentedFrame carAtABush()
{
    return carAndBush({-2.7F, 4.1F}, {-7.0F, 5.0F});
}

PredictedTarget sureCar()
{
    PredictedTarget car = predictedCar(0.0, 4.9, 0.05);
    car.box.length = 4.1;
    car.isBounded = true;
    return car;
}

PredictedTarget bush(double x)
{
    PredictedTarget clutter = predictedCar(x, 4.7);
    clutter.isClutter = true;
    return clutter;
}

SegmentedFrame cutFor(const std::vector<PredictedTarget>& targets)
{
    const TrackerOptions options;
    return withVehiclesCutOut(carAtABush(), targets, std::vector<Track>(targets.size()),
                              Neighbourhood(), Discriminator(options.discriminator), options);
}

// The bush comes as near as the car does, behind a dent.
SegmentedFrame carBeforeADent()
{
    return carAndBush({-2.3F, 5.4F}, {-7.0F, 4.2F});
}

// Clusters by a discriminator that takes every piece for a vehicle, before a track that has been
// ruled out.
std::size_t clustersWhenEachPieceIsACar(const Track& ruledOut)
{
    TrackerOptions options;
    DiscriminatorModel model = untrainedModel();
    model.frame.offset = 3.0;
    options.discriminator.loaded = std::make_shared<DiscriminatorModel>(model);
    return withVehiclesCutOut(carBeforeADent(), {bush(-5.0)}, {ruledOut}, Neighbourhood(),
                              Discriminator(options.discriminator), options)
        .clusters.size();
}

TEST(VehicleCut, ClutterIsSearchedWhenItIsLookedAt)
{
    Track clutter;
    clutter.judgement.probability = 0.05;
    clutter.id = 1;
    int searched = 0;
    for (clutter.sightings = 10; clutter.sightings < 18; ++clutter.sightings)
        if (clustersWhenEachPieceIsACar(clutter) > 1) ++searched;
    EXPECT_EQ(searched, 2) << "each fourth time";
    clutter.sightings = 3;
    EXPECT_GT(clustersWhenEachPieceIsACar(clutter), 1U) << "it may have been ruled out by mistake";
}

TEST(VehicleCut, ACarKeepsItsHitsBesideKnownClutter)
{
    const SegmentedFrame cut = cutFor({sureCar(), bush(-5.0)});
    ASSERT_EQ(cut.clusters.size(), 2U);
    EXPECT_EQ(cut.isVehicle, (std::vector<bool>{false, true}));
    EXPECT_EQ(cut.clusters[1].size(), 120U);
    EXPECT_EQ(cut.clusters[0].size() + cut.clusters[1].size(), 240U);
}

TEST(VehicleCut, HitsOfTheRestThatAreInNoClusterAnyMoreAreLoose)
{
    SegmentedFrame frame = carAtABush();
    Cluster ahead;
    addWall(ahead, {3.2F, 4.0F}, {3.2F, 4.0F}, 2);
    for (const std::size_t i : {0U, 1U}) appendHit(frame.clusters[0], ahead, i);
    const TrackerOptions options;
    const SegmentedFrame cut =
        withVehiclesCutOut(std::move(frame), {sureCar(), bush(-5.0)}, std::vector<Track>(2),
                           Neighbourhood(), Discriminator(options.discriminator), options);
    ASSERT_EQ(cut.clusters.size(), 2U);
    EXPECT_EQ(cut.clusters[0].size() + cut.clusters[1].size(), 240U);
    EXPECT_EQ(cut.loose.size(), 2U);
}

TEST(VehicleCut, ACarThatDrivesKeepsItsHitsWhereverItPasses)
{
    PredictedTarget car = sureCar();
    car.velocity = {5.0, 0.0};
    car.speedSigma = 0.3;
    const SegmentedFrame cut = cutFor({car});
    ASSERT_EQ(cut.clusters.size(), 2U);
    EXPECT_EQ(cut.isVehicle, (std::vector<bool>{false, true}));
    EXPECT_EQ(cut.clusters[1].size(), 120U);
    car.speedSigma = 2.0;
    EXPECT_EQ(cutFor({car}).clusters.size(), 1U) << "it may stand";
}

TEST(VehicleCut, WithoutADentNothingElseIsCut)
{
    EXPECT_EQ(cutFor({sureCar()}).clusters.size(), 1U) << "it may be longer than it seemed";
    EXPECT_EQ(cutFor({sureCar(), bush(-15.0)}).clusters.size(), 1U) << "the bush is elsewhere";
    EXPECT_EQ(cutFor({predictedCar(0.0, 4.9, 0.05), bush(-5.0)}).clusters.size(), 1U)
        << "no vehicle for sure";
}
}  // namespace
}  // namespace vdamf
