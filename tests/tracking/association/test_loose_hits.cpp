// SPDX-License-Identifier: BSD-3-Clause
#include "association/loose_hits.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace vdamf
{
namespace
{
using Assignment = std::vector<std::vector<std::size_t>>;

// Ahead on the right of a sensor at the origin, with its rear at x = 20 m and its left side at
// y = -3 m.
PredictedTarget carAhead()
{
    PredictedTarget target;
    target.box = {22.25, -3.9, 0.0, 4.5, 1.8};
    target.positionSigma = {0.1, 0.1};
    return target;
}

Cluster hitsAt(std::initializer_list<Eigen::Vector2f> places, float time = 0.0F)
{
    Cluster hits;
    for (const Eigen::Vector2f& place : places)
    {
        hits.x.push_back(place.x());
        hits.y.push_back(place.y());
        hits.z.push_back(0.5F);
        hits.height.push_back(0.5F);
        hits.time.push_back(time);
    }
    return hits;
}

Cluster onCar(const PredictedTarget& target, const Cluster& loose)
{
    return looseHitsOn({target}, Assignment{{0}}, loose, Eigen::Vector2d::Zero(), {}).front();
}

TEST(LooseHits, AreTheVehiclesThatTheyLieOn)
{
    // On the side, a little before it, well before it, and ahead of the car.
    const Cluster found =
        onCar(carAhead(), hitsAt({{24.0F, -3.0F}, {23.8F, -2.8F}, {23.0F, -2.0F}, {25.5F, -3.0F}}));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FLOAT_EQ(found.x[0] + found.x[1], 47.8F);
    EXPECT_EQ(found.height.size(), 2U);
    EXPECT_EQ(found.time.size(), 2U);
}

TEST(LooseHits, OneOfThemShowsThatTheVehicleIsThere)
{
    const auto shows = [](const Cluster& hits)
    { return anyLiesOn(carAhead(), hits, Eigen::Vector2d::Zero(), {}); };
    EXPECT_TRUE(shows(hitsAt({{23.0F, -2.0F}, {24.0F, -3.0F}})));
    EXPECT_FALSE(shows(hitsAt({{23.0F, -2.0F}, {22.0F, -4.9F}})));
    EXPECT_FALSE(shows(Cluster()));
    // Nor one far ahead in its lane, whichever way that runs.
    PredictedTarget across = carAhead();
    across.box = {0.0, 20.0, 0.5 * kPi, 4.5, 1.8};
    for (const bool isTruck : {false, true})
    {
        across.isDrivingTruck = isTruck;
        const Cluster ahead = hitsAt({{0.5F, 40.0F}});
        EXPECT_FALSE(anyLiesOn(across, ahead, Eigen::Vector2d::Zero(), {}));
        EXPECT_EQ(onCar(across, ahead).size(), 0U);
    }
    PredictedTarget vague = carAhead();
    vague.positionSigma.x() = 1.0;
    EXPECT_FALSE(anyLiesOn(vague, hitsAt({{24.0F, -3.0F}}), Eigen::Vector2d::Zero(), {}));
}

TEST(LooseHits, BehindTheFarFacesAreOthers)
{
    EXPECT_EQ(onCar(carAhead(), hitsAt({{22.0F, -4.9F}})).size(), 0U);
}

TEST(LooseHits, AreWhereTheVehicleWasWhenItWasHit)
{
    PredictedTarget fast = carAhead();
    fast.velocity = {20.0, 0.0};
    const Cluster late = hitsAt({{25.5F, -3.0F}}, 0.05F);
    EXPECT_EQ(onCar(fast, late).size(), 1U);
    EXPECT_EQ(onCar(carAhead(), late).size(), 0U);
}

TEST(LooseHits, AreOneVehiclesOnly)
{
    const Cluster loose = hitsAt({{24.0F, -3.0F}});
    const auto found = looseHitsOn({carAhead(), carAhead()}, Assignment{{0}, {1}}, loose,
                                   Eigen::Vector2d::Zero(), {});
    EXPECT_EQ(found[0].size() + found[1].size(), 1U);
}

TEST(LooseHits, AreOfNoneWithoutACluster)
{
    const auto found = looseHitsOn({carAhead()}, Assignment{{}}, hitsAt({{24.0F, -3.0F}}),
                                   Eigen::Vector2d::Zero(), {});
    EXPECT_EQ(found.front().size(), 0U);
}

TEST(LooseHits, AreNoTrucksNorClutterNorOfWhatIsInAVaguePlace)
{
    const Cluster loose = hitsAt({{24.0F, -3.0F}});
    PredictedTarget truck = carAhead();
    truck.box = {24.0, -4.2, 0.0, 8.0, 2.4};
    PredictedTarget bush = carAhead();
    bush.isClutter = true;
    PredictedTarget vague = carAhead();
    vague.positionSigma = {0.5, 0.1};
    for (const PredictedTarget& target : {truck, bush, vague})
        EXPECT_EQ(onCar(target, loose).size(), 0U);
    EXPECT_EQ(onCar(carAhead(), loose).size(), 1U);
}
}  // namespace
}  // namespace vdamf
