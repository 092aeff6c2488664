// SPDX-License-Identifier: BSD-3-Clause
// How well positions can be known at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/regression_rows.h"
#include "position_floor/floor.h"
#include "position_floor/table.h"

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;

Eigen::AlignedBox2d hits(double rear, double front, double right, double left)
{
    return {Eigen::Vector2d(rear, right), Eigen::Vector2d(front, left)};
}

constexpr BodySize kUsual{4.5, 1.8, 1.5};
constexpr BodySize kLong{5.1, 1.8, 1.5};

TEST(PositionFloor, WhereAllFacesAreSeenPositionsAreKnown)
{
    EXPECT_EQ(leastSquaredOffset(hits(-2.5, 2.5, -0.9, 0.9), kLong, kUsual), 0.0);
}

TEST(PositionFloor, BeyondTheRearAloneALongCarIsTakenForAUsualOne)
{
    EXPECT_NEAR(leastSquaredOffset(hits(-2.55, -2.3, -0.9, 0.9), kLong, kUsual), 0.3 * 0.3, 1e-12);
    EXPECT_NEAR(leastSquaredOffset(hits(2.3, 2.55, -0.9, 0.9), kLong, kUsual), 0.3 * 0.3, 1e-12);
}

TEST(PositionFloor, ItIsNoShorterThanItsHitsReach)
{
    EXPECT_NEAR(leastSquaredOffset(hits(-2.55, 2.15, -0.9, 0.9), kLong, kUsual), 0.2 * 0.2, 1e-12);
}

TEST(PositionFloor, WhereNeitherOfTwoFacesIsSeenNothingIsCounted)
{
    EXPECT_EQ(leastSquaredOffset(hits(-1.0, 1.0, -0.9, 0.9), kLong, kUsual), 0.0);
}

// A car ahead that stands beside nothing: its rear alone is in view until the platform passes it.
Scenario passed(double length)
{
    IniDocument document = IniDocument::parse(
        "[scenario]\nduration_s = 4\n[sensor]\nz_m = 1.9\n"
        "[platform]\nx_m = 0\nspeed_mps = 15\n"
        "[object car]\nclass = car\nx_m = 25\ny_m = 0\n",
        "scene of a test");
    document.set("object car.length_m=" + std::to_string(length));
    return readScenario(document);
}

TEST(PositionFloor, WhatIsPassedIsKnownInHindsight)
{
    const PositionFloor floor = positionFloor(seenBoxes(passed(5.1)), passed(5.1), passed(4.5));
    EXPECT_GT(floor.boxes, 20U);
    EXPECT_GT(floor.online, 0.1) << "0.3 m until its front shows";
    EXPECT_LT(floor.online, 0.3);
    EXPECT_EQ(floor.hindsight, 0.0);
    EXPECT_EQ(positionFloor(seenBoxes(passed(4.5)), passed(4.5), passed(4.5)).online, 0.0)
        << "of usual length";
}

TEST(PositionFloor, WhoTakesTrucksAndBusesForTheSameErrsByAQuarterOfWhatTheirLengthsDiffer)
{
    Scenario scenario = passed(4.5);
    SceneObject& object = scenario.scene.objects.front();
    object.objectClass = ObjectClass::Bus;
    object.size = typicalSize(ObjectClass::Bus);
    SeenBoxes rearAlone;
    rearAlone.boxes = {{0, hits(-6.0, -5.8, -1.2, 1.2)}};
    rearAlone.inAll = {hits(-6.0, 6.0, -1.2, 1.2)};
    EXPECT_EQ(positionFloor(rearAlone, scenario, scenario).online, 0.0);
    const PositionFloor alike = positionFloor(rearAlone, scenario, withHeaviesAlike(scenario));
    EXPECT_NEAR(alike.online, 0.25 * (12.0 - 9.0), 1e-12);
    EXPECT_EQ(alike.hindsight, 0.0);
    EXPECT_EQ(withHeaviesAlike(passed(5.1)).scene.objects.front().size.length, 5.1) << "a car";
}

TEST(PositionFloor, TellsInHowManyRunsTheTrackerHadNoChance)
{
    const FloorRows floor{{regressionRow("turn/seed_1", 0.1), regressionRow("turn/seed_2", 0.2),
                           regressionRow("stop/seed_1", 0.05)},
                          {regressionRow("turn/seed_1", 0.3), regressionRow("turn/seed_2", 0.3),
                           regressionRow("stop/seed_1", 0.05)},
                          {regressionRow("turn/seed_1", 0.0), regressionRow("turn/seed_2", 0.0),
                           regressionRow("stop/seed_1", 0.0)}};
    const std::vector<RegressionRow> tracked{regressionRow("turn/seed_2", 0.3),
                                             regressionRow("turn/seed_1", 0.13)};
    const std::string table = floorTable(floor, tracked, 0.12);
    EXPECT_THAT(table,
                HasSubstr("turn                         2      0.000    0.158       1    0.300"
                          "       2    0.231       2\n"));
    EXPECT_THAT(table,
                HasSubstr("stop                         1      0.000    0.050       0    0.050"
                          "       0        -       -\n"))
        << "of which the tracker's table has none";
    EXPECT_THAT(table, HasSubstr("all                          3"));
    EXPECT_THAT(floorTable(floor, {}, 0.12), Not(HasSubstr("tracker")));
}
}  // namespace
}  // namespace vdamf
