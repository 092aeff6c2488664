// SPDX-License-Identifier: BSD-3-Clause
// The type of a track, carried from frame to frame.
#include "tracker/type_filters.h"

#include <gtest/gtest.h>

#include <memory>

namespace vdamf
{
namespace
{
MeasureOptions withBank()
{
    FilterBank bank;
    bank.filters.emplace_back();
    TypedFilter car;
    car.type = VehicleType::Car;
    car.sizes = {0.8, 4.4, 0.4, 1.8, 0.1, 1.5, 0.1};
    car.parameters.shape.sigma = 0.15;
    TypedFilter truck;
    truck.type = VehicleType::Truck;
    truck.sizes = {0.2, 10.0, 2.0, 2.5, 0.1, 3.4, 0.3};
    truck.parameters.shape.sigma = 0.25;
    bank.filters.push_back(car);
    bank.filters.push_back(truck);
    MeasureOptions options;
    options.bank = std::make_shared<const FilterBank>(bank);
    return options;
}

Sighting sightingOf(double length, double width, double height)
{
    Sighting sighting;
    sighting.measurement.box.length = length;
    sighting.measurement.box.width = width;
    sighting.measurement.covariance.diagonal().setConstant(0.01);
    sighting.height = height;
    return sighting;
}

const Sighting kCarSighting = sightingOf(4.5, 1.8, 1.45);
const Sighting kTruck = sightingOf(9.0, 2.5, 3.3);

TEST(TypeFilters, MeasureATrackWithTheFilterOfItsType)
{
    const TypeFilters filters(withBank());
    Track track;
    EXPECT_EQ(filters.optionsFor(track).sigma, 0.2);
    track = filters.judged(track, kTruck);
    ASSERT_TRUE(track.type);
    EXPECT_EQ(track.type->type, VehicleType::Truck);
    EXPECT_GT(track.type->probability, 0.99);
    EXPECT_EQ(filters.optionsFor(track).sigma, 0.25);
}

TEST(TypeFilters, ForgetAFrameThatWasWrongAndOutlastOneLater)
{
    const TypeFilters filters(withBank());
    Track track = filters.judged({}, kTruck);
    for (int i = 0; i < 20; ++i) track = filters.judged(track, kCarSighting);
    ASSERT_TRUE(track.type);
    EXPECT_EQ(track.type->type, VehicleType::Car);
    track = filters.judged(track, kTruck);
    EXPECT_EQ(track.type->type, VehicleType::Car);
    for (int i = 0; i < 20; ++i) track = filters.judged(track, kTruck);
    EXPECT_EQ(track.type->type, VehicleType::Truck);
}

TEST(TypeFilters, TakeASizeThatSomethingHidesForLittle)
{
    const TypeFilters filters(withBank());
    Sighting half = sightingOf(4.4, 2.5, 3.3);
    half.measurement.hiddenEnds.add(Face::Front);
    EXPECT_EQ(filters.judged({}, half).type->type, VehicleType::Truck);
}

TEST(TypeFilters, AreSilentWhereOneFilterServesAll)
{
    const TypeFilters filters{MeasureOptions()};
    EXPECT_FALSE(filters.judged({}, kCarSighting).type);
    MeasureOptions one;
    FilterBank bank;
    bank.filters.emplace_back();
    one.bank = std::make_shared<const FilterBank>(bank);
    EXPECT_FALSE(TypeFilters(one).judged({}, kCarSighting).type);
}

}  // namespace
}  // namespace vdamf
