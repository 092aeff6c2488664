// SPDX-License-Identifier: BSD-3-Clause
// Which end of what turns is its front.
#include "tracker/front_by_axle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr double kTurnerLength = 4.5;   // m
constexpr double kAxleFraction = 0.28;  // of it: the axle that does not steer

struct BendDriven
{
    double speed = 3.0;    // m/s
    double radius = 6.0;   // m, of the axle's path; to the left
    double heldFor = 0.0;  // rad, from where the front is
    int frames = 15;
};

FaceSet sideAndRear()
{
    FaceSet faces;
    faces.add(Face::Left);
    faces.add(Face::Back);
    return faces;
}

// The boxes of a car whose rear axle goes along a circle, ten a second.
std::vector<PathPoint> pathOf(const BendDriven& drive)
{
    std::vector<PathPoint> path;
    const double d = kAxleFraction * kTurnerLength;
    for (int k = 0; k < drive.frames; ++k)
    {
        const double heading = 0.3 + 0.1 * k * drive.speed / drive.radius;
        const Eigen::Vector2d ahead(std::cos(heading), std::sin(heading));
        const Eigen::Vector2d left(-ahead.y(), ahead.x());
        const Eigen::Vector2d centre = -drive.radius * left + d * ahead;
        PathPoint point;
        point.time = 0.1 * k;
        point.box = {centre.x(), centre.y(), wrapAngle(heading + drive.heldFor), kTurnerLength,
                     1.8};
        point.located = sideAndRear();
        path.push_back(point);
    }
    return path;
}

double oddsOfFront(const BendDriven& drive)
{
    return frontByAxle(pathOf(drive), MotionOptions());
}

TEST(FrontByAxle, TellsTheFrontWhicheverWayItDrivesAndTurns)
{
    for (const double speed : {3.0, -3.0})
    {
        for (const double radius : {6.0, -6.0})
        {
            EXPECT_GT(oddsOfFront({speed, radius}), 3.0) << speed << ' ' << radius;
            EXPECT_LT(oddsOfFront({speed, radius, kPi}), -3.0) << speed << ' ' << radius;
        }
    }
}

TEST(FrontByAxle, IsNotTheOtherWayRoundWhereTheHeadingIs)
{
    EXPECT_NEAR(oddsOfFront({3.0, 6.0}), -oddsOfFront({3.0, 6.0, kPi}), 1e-9);
}

TEST(FrontByAxle, ExpectsTheWayAcrossOfAnAxleThere)
{
    // Way across: of the chord between two headings, by the axle's place.
    const BendDriven drive{3.0, 6.0, 0.0, 8};
    const double turn = 0.7 * drive.speed / drive.radius;
    const double across = kAxleFraction * kTurnerLength * turn;
    const double way = std::hypot(drive.radius, kAxleFraction * kTurnerLength) * turn;
    std::vector<PathPoint> path = pathOf(drive);
    path.front().headingVariance = path.back().headingVariance = 0.02;
    const double variance = 0.01 + std::pow(0.026 * way, 2) +
                            std::pow(0.5 * kTurnerLength, 2) * 0.04 +
                            std::pow(0.1 * kTurnerLength * turn, 2);
    const double odds = frontByAxle(path, MotionOptions());
    EXPECT_NEAR(odds, 2.0 * across * across / variance, 0.01 * odds);
}

TEST(FrontByAxle, OfWhatMayBeArticulatedTellsNothing)
{
    std::vector<PathPoint> path = pathOf({});
    for (PathPoint& point : path) point.box.length = 9.0;
    EXPECT_DOUBLE_EQ(frontByAxle(path, MotionOptions()), 0.0);
}

TEST(FrontByAxle, WithoutABendTellsNothing)
{
    EXPECT_DOUBLE_EQ(oddsOfFront({10.0, 200.0}), 0.0);
    EXPECT_DOUBLE_EQ(oddsOfFront({3.0, 6.0, 0.0, 2}), 0.0);
    EXPECT_DOUBLE_EQ(frontByAxle({}, MotionOptions()), 0.0);
}

TEST(FrontByAxle, WhatTurnsOnTheSpotOrAllAtOnceIsTheFit)
{
    EXPECT_DOUBLE_EQ(oddsOfFront({0.5, 0.5}), 0.0);
    std::vector<PathPoint> path = pathOf({3.0, 1e4});
    for (std::size_t k = 8; k < path.size(); ++k)
    {
        path[k].box.heading += 0.4;
        path[k].box.y += 0.5;
    }
    EXPECT_DOUBLE_EQ(frontByAxle(path, MotionOptions()), 0.0);
}

TEST(FrontByAxle, NeedsTheWayAcrossInView)
{
    std::vector<PathPoint> path = pathOf({});
    for (PathPoint& point : path) point.located = FaceSet();
    EXPECT_DOUBLE_EQ(frontByAxle(path, MotionOptions()), 0.0);
}

TEST(FrontByAxle, AWidthThatGrowsMakesItLessSure)
{
    std::vector<PathPoint> path = pathOf({});
    path.back().box.width += 0.8;
    const double sure = frontByAxle(pathOf({}), MotionOptions());
    EXPECT_GT(frontByAxle(path, MotionOptions()), 0.0);
    EXPECT_LT(frontByAxle(path, MotionOptions()), 0.75 * sure);
}

TEST(FrontByAxle, ErrorsOfMeasurementsSeldomTellTheWrongEnd)
{
    std::mt19937 random(7);
    std::normal_distribution<double> metres(0.0, 0.07), radians(0.0, 0.02);
    int wrong = 0;
    int told = 0;
    for (int run = 0; run < 2000; ++run)
    {
        std::vector<PathPoint> path = pathOf({2.0, run % 2 == 0 ? 5.0 : -12.0});
        for (PathPoint& point : path)
        {
            point.box.x += metres(random);
            point.box.y += metres(random);
            point.box.heading += radians(random);
        }
        const double odds = frontByAxle(path, MotionOptions());
        told += std::abs(odds) > 1.0 ? 1 : 0;
        wrong += odds < -1.0 ? 1 : 0;
    }
    EXPECT_GT(told, 1500);
    EXPECT_LT(wrong, told / 100);
}

// Nobody has seen it drive forward.
TEST(FrontByAxle, OutweighsTheCourseOfWhatIsSlowAlone)
{
    for (const double speed : {2.0, 8.0})
    {
        HeadingCues cues;
        cues.course = {0.0, speed};
        cues.forth = 1.0;
        HeadingBelief belief;
        for (int k = 0; k < 10; ++k) belief = belief.after(cues);
        EXPECT_GT(belief.forwardProbability(), 0.95);
        cues.axle = -8.0;
        for (int k = 0; k < 5; ++k) belief = belief.after(cues);
        EXPECT_EQ(belief.turnDue(2.5), speed < 4.0 ? 2 : 0);
        if (speed > 4.0) continue;
        belief = belief.turned(2);
        cues.course->direction = kPi;
        cues.forth = 0.0;
        cues.axle = 0.0;
        for (int k = 0; k < 30; ++k) belief = belief.after(cues);
        EXPECT_EQ(belief.turnDue(0.0), 0) << "it reverses, now straight";
        EXPECT_GT(belief.forwardProbability(), 0.9);
        EXPECT_GT(belief.forwardProbabilityByCourse(), 0.9);
    }
}

TEST(FrontByAxle, OneFrameThatErrsTurnsNothing)
{
    HeadingCues cues;
    cues.course = {0.0, 2.0};
    cues.forth = 1.0;
    HeadingBelief belief;
    for (int k = 0; k < 10; ++k) belief = belief.after(cues);
    cues.dt = 0.3;
    cues.axle = -4.0;
    belief = belief.after(cues);
    EXPECT_EQ(belief.turnDue(2.5), 0);
    EXPECT_EQ(belief.after(cues).after(cues).turnDue(2.5), 2);
}

// A car comes out of a bay backwards and then drives off.
TEST(FrontByAxle, WhoBacksOutOfABayHasItsFrontBehindTheWayItGoes)
{
    const Scenario scenario = scenarioOf(R"([scenario]
duration_s = 9
start_time_s = 1700000000
[sensor]
model = HDL-32E
x_m = 0.8
z_m = 1.9
[platform]
x_m = 0
y_m = 0
heading_deg = 0
speed_mps = 0
[object leaver]
class = car
x_m = 20
y_m = 9.5
heading_deg = 90
speed_mps = 0
segments = keep 0.5, speed_to -2 1.5, turn 90 5, stop 1, speed_to 5 2
)");
    const std::map<std::string, std::vector<Seen>> objects = trackedObjects(scenario);
    int seen = 0;
    for (const Seen& here : objects.at("leaver"))
    {
        if (here.time < 4.5 || here.tracks.empty()) continue;
        ++seen;
        EXPECT_LT(std::abs(wrapAngle(here.tracks.front().box.heading - here.truth.box.heading)),
                  0.1)
            << here.time;
    }
    EXPECT_GT(seen, 40);
}

}  // namespace
}  // namespace vdamf
