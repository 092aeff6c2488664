// SPDX-License-Identifier: BSD-3-Clause
// One front for all of a track's frames.
#include "hindsight/one_front.h"

#include <gtest/gtest.h>

#include "tracking/hindsight/example_history.h"

namespace vdamf
{
namespace
{
// The same box, told as if it were turned by quarters.
void tellTurned(TrackReport& report, int quarters)
{
    report.box.heading = wrapAngle(report.box.heading + 0.5 * kPi * quarters);
    report.facesSeen = turnedBy(report.facesSeen, quarters);
    for (int k = 0; k < quarters; ++k)
        report.heldPoint = {report.heldPoint.y(), -report.heldPoint.x()};
    if (quarters % 2 == 0) return;
    std::swap(report.box.length, report.box.width);
    std::swap(report.lengthVariance, report.widthVariance);
}

TEST(OneFront, WhatIsToldTurnedIsTheSameBox)
{
    for (const int quarters : {1, 2, 3})
    {
        const TrackReport report = standingCar(1)[0].report;
        TrackReport told = report;
        tellTurned(told, quarters);
        EXPECT_LT((heldPlace(told) - heldPlace(report)).norm(), 1e-12);
    }
}

TEST(OneFront, LeavesWhatNeverTurned)
{
    const TrackHistory history = withOneFront(standingCar(6));
    for (const TrackMoment& moment : history)
    {
        EXPECT_EQ(moment.report.box.heading, 0.3);
        EXPECT_EQ(toString(moment.report.facesSeen), "BL");
        EXPECT_FALSE(moment.wasAcross);
    }
}

TEST(OneFront, IsTheOneThatWasSurest)
{
    TrackHistory history = standingCar(8);
    for (std::size_t k = 0; k < 3; ++k)
    {
        TrackReport& report = history[k].report;
        tellTurned(report, 2);
        report.forwardProbability = 0.6;
        report.speed = -5.0;
        report.covariance(0, 3) = report.covariance(3, 0) = 0.005;
    }
    history = withOneFront(history);
    for (std::size_t k = 0; k < 3; ++k)
    {
        const TrackReport& report = history[k].report;
        EXPECT_NEAR(report.box.heading, 0.3, 1e-12);
        EXPECT_EQ(toString(report.facesSeen), "BL");
        EXPECT_EQ(report.heldPoint, Eigen::Vector2d(-1.0, 1.0));
        EXPECT_EQ(report.speed, 5.0) << "it moves as it did";
        EXPECT_EQ(report.covariance(0, 3), -0.005);
        EXPECT_EQ(report.covariance(3, 3), 0.04);
        EXPECT_EQ(report.forwardProbability, 0.9);
    }
}

TEST(OneFront, AxesLieAsMostHitsHaveThem)
{
    for (const int quarters : {1, 3})
    {
        TrackHistory history = standingCar(9);
        for (std::size_t k = 0; k < 4; ++k)
        {
            tellTurned(history[k].report, quarters);
            history[k].report.forwardProbability = 0.999;
            history[k].report.speed = 2.0;
        }
        history = withOneFront(history);
        for (std::size_t k = 0; k < history.size(); ++k)
        {
            const TrackReport& report = history[k].report;
            EXPECT_NEAR(report.box.heading, 0.3, 1e-12) << k;
            EXPECT_EQ(report.box.length, 4.4);
            EXPECT_EQ(report.heldPoint, Eigen::Vector2d(-1.0, 1.0));
            EXPECT_EQ(toString(report.facesSeen), "BL");
            EXPECT_EQ(history[k].wasAcross, k < 4);
        }
        EXPECT_EQ(history[0].report.speed, 0.0);
        EXPECT_GT(history[0].report.covariance(3, 3), 100.0) << "it was across the heading";
    }
    TrackHistory few = standingCar(9);
    for (std::size_t k = 5; k < 9; ++k)
    {
        tellTurned(few[k].report, 1);
        few[k].report.points = 3;
    }
    EXPECT_NEAR(withOneFront(few)[8].report.box.heading, 0.3, 1e-12) << "at its end as well";
}

TEST(OneFront, TurnsOfItsOwnAndGapsAreNone)
{
    TrackHistory history = standingCar(40);
    for (std::size_t k = 0; k < history.size(); ++k)
    {
        history[k].report.box.heading = 0.1 * static_cast<double>(k);
        history[k].report.yawRate = 1.0;
    }
    const TrackHistory turning = withOneFront(history);
    for (std::size_t k = 0; k < history.size(); ++k)
        EXPECT_EQ(turning[k].report.box.heading, history[k].report.box.heading);

    // Out of sight it coasts.
    history = standingCar(30);
    for (std::size_t k = 5; k < 30; ++k)
    {
        TrackReport& report = history[k].report;
        if (k >= 25) report.box.heading = 0.3 + 0.5 * kPi;
        if (k < 25) report.points = 0;
    }
    EXPECT_EQ(withOneFront(history)[0].report.box.heading, 0.3) << "it turned out of sight";
    EXPECT_EQ(withOneFront(history)[29].report.box.heading, 0.3 + 0.5 * kPi);
}

TEST(OneFront, HeadingsThatErrAreNoTurns)
{
    TrackHistory history = standingCar(12);
    for (std::size_t k = 0; k < 5; ++k)
        history[k].report.box.heading = 0.3 + 0.2 * static_cast<double>(5 - k);
    history[0].report.box.heading = 0.1;  // then by 1 rad to one side, and back bit by bit
    for (std::size_t k = 0; k < 12; ++k)
        EXPECT_EQ(withOneFront(history)[k].report.box.heading, history[k].report.box.heading) << k;
}
}  // namespace
}  // namespace vdamf
