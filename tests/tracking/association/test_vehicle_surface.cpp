// SPDX-License-Identifier: BSD-3-Clause
#include "association/vehicle_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tracking/association/predicted_car.h"
#include "tracking/sensor_at_origin.h"

namespace vdamf
{
namespace
{
// Seen from the origin: its rear and its right side.
PredictedTarget drivingCar()
{
    PredictedTarget car = predictedCar(12.0, 4.0);
    car.box.heading = 0.4;
    car.velocity = {8.0, 3.0};
    return car;
}

// Ten metres around it.
Cluster hitsAround(const PredictedTarget& target, std::size_t count, bool isTimed)
{
    std::mt19937 generator(5);
    const auto within = [&](double reach)
    {
        return static_cast<float>(reach *
                                  (2.0 * static_cast<double>(generator()) / 4294967296.0 - 1.0));
    };
    Cluster cluster;
    for (std::size_t i = 0; i < count; ++i)
    {
        cluster.x.push_back(static_cast<float>(target.box.x) + within(5.0));
        cluster.y.push_back(static_cast<float>(target.box.y) + within(5.0));
        if (isTimed) cluster.time.push_back(within(0.1));
    }
    return cluster;
}

TEST(VehicleSurface, ClaimsTheHitsThatItHas)
{
    constexpr std::int32_t kNone = 7;
    constexpr std::int32_t kOther = 3;
    PredictedTarget truck = drivingCar();
    truck.box.length = 20.0;
    truck.endSigma = {0.1, 2.0};  // it may be longer ahead
    for (const PredictedTarget& vehicle : {drivingCar(), truck})
        for (const bool isTimed : {false, true})
        {
            const VehicleSurface surface(vehicle, kSensor, {});
            const Cluster cluster = hitsAround(vehicle, 1001, isTimed);
            std::vector<std::int32_t> owner(cluster.size(), kNone);
            for (std::size_t i = 0; i < owner.size(); i += 5) owner[i] = kOther;
            std::vector<std::int32_t> expected = owner;
            std::size_t count = 0;
            for (std::size_t i = 0; i < owner.size(); ++i)
            {
                if (owner[i] != kNone || !surface.has(surface.placeOf(cluster, i))) continue;
                expected[i] = 1;
                ++count;
            }
            EXPECT_GT(count, 20U);
            EXPECT_LT(count, 700U);
            EXPECT_EQ(surface.claim(cluster, 1, kNone, owner), count);
            EXPECT_EQ(owner, expected);
        }
}

TEST(VehicleSurface, HasNoHitsBehindTheFacesThatLookAway)
{
    PredictedTarget car = predictedCar(12.0, 4.0);
    const auto has = [&](double along, double across) {
        return VehicleSurface(car, kSensor, {}).has({along, across});
    };
    EXPECT_TRUE(has(-2.35, 0.0)) << "before its rear, by less than hits scatter";
    EXPECT_TRUE(has(0.0, -1.0)) << "before its right side";
    EXPECT_FALSE(has(2.35, 0.0)) << "its front looks away";
    EXPECT_FALSE(has(0.0, 1.0)) << "its left side looks away";
    EXPECT_TRUE(has(2.2, 0.85));
    car.endSigma = {0.1, 1.0};
    EXPECT_TRUE(has(2.35, 0.0)) << "it may be longer there";
    EXPECT_FALSE(has(2.35, 1.0));
}

}  // namespace
}  // namespace vdamf
