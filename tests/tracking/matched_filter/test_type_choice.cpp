// SPDX-License-Identifier: BSD-3-Clause
// Which type of vehicle a measured box speaks for.
#include "vdamf/tracking/matched_filter/type_choice.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tracking/matched_filter/example_hits.h"

namespace vdamf
{
namespace
{
FilterBank carsAndTrucks()
{
    FilterBank bank;
    bank.filters.emplace_back();
    TypedFilter car;
    car.type = VehicleType::Car;
    car.sizes = {0.8, 4.4, 0.4, 1.8, 0.1, 1.5, 0.1};
    TypedFilter truck;
    truck.type = VehicleType::Truck;
    truck.sizes = {0.2, 10.0, 2.0, 2.5, 0.1, 3.4, 0.3};
    bank.filters.push_back(car);
    bank.filters.push_back(truck);
    return bank;
}

Measurement boxOf(double length, double lengthSigma, double width, double widthSigma)
{
    Measurement m;
    m.box.length = length;
    m.box.width = width;
    m.covariance(3, 3) = lengthSigma * lengthSigma;
    m.covariance(4, 4) = widthSigma * widthSigma;
    return m;
}

std::vector<double> typesOf(const Measurement& m, double height)
{
    const FilterBank bank = carsAndTrucks();
    return typeProbabilities(typeLogLikelihoods(m, height, bank), bank);
}

TEST(TypeChoice, GoesByTheSizesThatAreKnown)
{
    const auto car = typesOf(boxOf(4.5, 0.1, 1.8, 0.1), 1.4);
    EXPECT_EQ(car[0], 0.0);
    EXPECT_GT(car[1], 0.99);
    const auto truck = typesOf(boxOf(9.0, 0.2, 2.5, 0.1), 3.3);
    EXPECT_GT(truck[2], 0.99);
    EXPECT_NEAR(std::accumulate(truck.begin(), truck.end(), 0.0), 1.0, 1e-12);
    // From behind, the width tells; nothing but a hidden length does not.
    EXPECT_GT(typesOf(boxOf(1.0, 3.0, 2.5, 0.05), 0.0)[2], 0.99);
    EXPECT_GT(typesOf(boxOf(1.0, 10.0, 1.0, 10.0), 0.0)[2], 0.05);
}

TEST(TypeChoice, MeasuresWithTheFilterOfTheType)
{
    FilterBank bank = carsAndTrucks();
    bank.filters[1].parameters.insets.side = 0.6;
    MeasureOptions options;
    options.filter = FilterKind::PaperInset;
    options.bank = std::make_shared<const FilterBank>(bank);
    const OrientedBox car{15.0, 4.0, 0.5, 4.4, 1.8};
    const Hits hits = exampleHits(car, 200, 0.02, 0.0, 8);
    const BankMeasurement m = measureWithBank(hits, 1.45, {0.0, 0.0}, car, options, std::nullopt);
    EXPECT_EQ(m.chosen, 1U);
    const Measurement own =
        measureTarget(hits, {0.0, 0.0}, car, withFilter(options, bank.filters[1].parameters));
    EXPECT_EQ(m.measurement.box.x, own.box.x);
}

}  // namespace
}  // namespace vdamf
