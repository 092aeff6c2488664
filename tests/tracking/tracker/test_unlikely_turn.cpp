// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/unlikely_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
const Eigen::Vector2d kHitsAt(9.0, 4.0);  // m

// A box measured about those hits.
Measurement turnedAbout(double heading, double sigma, Face seen)
{
    Measurement m;
    const Eigen::Vector2d centre = kHitsAt + rotation(heading) * Eigen::Vector2d(0.8, -0.9);
    m.box = {centre.x(), centre.y(), heading, 4.4, 1.8};
    m.covariance = 0.01 * Matrix5d::Identity();
    m.covariance(2, 2) = sigma * sigma;
    m.facesSeen.add(seen);
    return m;
}

VehicleState heading(double mean, double sigma)
{
    VehicleState s;
    s.mean << 10.0, 3.0, mean, 0.0, 0.0, 1.2, 4.4;
    s.covariance(kHeading, kHeading) = sigma * sigma;
    return s;
}

TEST(UnlikelyTurn, OfWhatStandsIsTakenBackAboutTheHits)
{
    const Measurement m =
        turnedBack(turnedAbout(-0.5, 0.18, Face::Left), heading(0.0, 0.02), kHitsAt);
    EXPECT_NEAR(m.box.heading, 0.0, 0.01);
    const Measurement straight = turnedAbout(m.box.heading, 0.18, Face::Left);
    EXPECT_NEAR((m.box.centre() - straight.box.centre()).norm(), 0.0, 0.15);
    EXPECT_NEAR((m.box.centre() - kHitsAt).norm(), (straight.box.centre() - kHitsAt).norm(), 0.15);
}

TEST(UnlikelyTurn, OfWhatIsMeasuredWellOrHardlyKnownIsBelieved)
{
    for (const double sigma : {0.01, 0.05})
    {
        const Measurement told = turnedAbout(-0.5, sigma, Face::Left);
        EXPECT_EQ(turnedBack(told, heading(0.0, 0.02), kHitsAt).box.heading, -0.5) << sigma;
    }
    const Measurement vague = turnedAbout(-0.5, 0.18, Face::Left);
    EXPECT_EQ(turnedBack(vague, heading(0.0, 0.06), kHitsAt).box.heading, -0.5) << "hardly known";
    const Measurement near = turnedAbout(-0.09, 0.18, Face::Left);
    EXPECT_EQ(turnedBack(near, heading(0.0, 0.02), kHitsAt).box.heading, -0.09) << "hardly turned";
}

TEST(UnlikelyTurn, OfAnEndAloneLeavesItsHeadingOpen)
{
    const Measurement end = turnedAbout(0.3, 0.02, Face::Back);
    const Measurement m = withUnlikelyTurn(end, heading(0.0, 0.02), kHitsAt);
    EXPECT_EQ(m.box.heading, 0.3);
    EXPECT_NEAR(std::sqrt(m.covariance(2, 2) + 0.02 * 0.02), 0.1, 1e-9) << "of three sigmas";
    const Measurement side = turnedAbout(0.3, 0.02, Face::Left);
    EXPECT_EQ(withUnlikelyTurn(side, heading(0.0, 0.02), kHitsAt).covariance, side.covariance);
}

TEST(UnlikelyTurn, AcrossOfAxesThatAreKnownIsAnotherFace)
{
    for (const double turn : {-1.45, 1.45})
    {
        Sighting seen;
        seen.measurement = turnedAbout(turn, 0.17, Face::Left);
        seen.around = {10.0, 0.1, turn, 1.5, 0.3};
        seen.side.metres = 1.5;
        seen.end.metres = 0.3;
        seen.front = 2.0;
        const auto next = turnedToKnownAxes(seen, heading(0.0, 0.07), 0.99);
        ASSERT_TRUE(next);
        const Measurement& m = next->measurement;
        EXPECT_NEAR(m.box.heading, turn - std::copysign(0.5 * kPi, turn), 1e-12);
        EXPECT_EQ(m.box.length, seen.measurement.box.width);
        EXPECT_EQ(m.box.width, seen.measurement.box.length);
        EXPECT_EQ(m.facesSeen.has(Face::Front), turn < 0.0);
        EXPECT_EQ(m.facesSeen.has(Face::Back), turn > 0.0);
        EXPECT_EQ(next->end.metres, 1.5) << "the row of hits goes with its face";
        EXPECT_EQ(next->side.metres, 0.3);
        EXPECT_NEAR(next->around.heading, m.box.heading, 1e-12);
        EXPECT_EQ(next->around.length, 0.3);
        EXPECT_EQ(next->around.width, 1.5);
        EXPECT_EQ(next->front, 0.0) << "the shape of another end";
        EXPECT_FALSE(turnedToKnownAxes(seen, heading(0.0, 0.07), 0.9)) << "axes";
        EXPECT_FALSE(turnedToKnownAxes(seen, heading(0.0, 0.3), 0.99)) << "heading";
    }
    Sighting turning;
    turning.measurement = turnedAbout(0.7, 0.17, Face::Left);
    EXPECT_FALSE(turnedToKnownAxes(turning, heading(0.0, 0.07), 0.99));
}

}  // namespace
}  // namespace vdamf
