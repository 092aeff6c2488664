// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_end.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "tracking/tracker/seen_as.h"

namespace vdamf
{
namespace
{
constexpr double kRearAt = 20.0;  // m ahead

// A row of hits of one height from a place to the right, m, on a line that is turned.
void addRow(Cluster& hits, double height, double x, double fromY, int count, double turn = 0.0)
{
    for (int k = 0; k < count; ++k)
    {
        const double y = fromY + 0.08 * k;
        hits.x.push_back(static_cast<float>(x - std::tan(turn) * y));
        hits.y.push_back(static_cast<float>(y));
        hits.height.push_back(static_cast<float>(height));
    }
}

// The rear of a truck behind what hides its right: its box shows to the left, to the right the
// frame half a metre behind it.
HitsAtOneTime boxAndFrame()
{
    Cluster hits;
    for (const double height : {1.3, 1.9, 2.5}) addRow(hits, height, kRearAt, 0.4, 8);
    addRow(hits, 0.7, kRearAt + 0.4, -0.4, 8);
    return seenAs(std::move(hits));
}

// By which a line through all hits is turned: x = x0 - tan(turn) y.
double turnOfAll(const HitsAtOneTime& seen)
{
    const Cluster& hits = *seen.each;
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    Eigen::Vector2d products = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2d by(1.0, -hits.y[i]);
        squares += by * by.transpose();
        products += hits.x[i] * by;
    }
    return std::atan(squares.ldlt().solve(products)(1));
}

// As it is measured: with a line through all hits, turned by so much about the middle of the rear.
Sighting rearTurned(double turn)
{
    Sighting s;
    const Eigen::Vector2d rear(kRearAt + 0.1, 0.3);
    const Eigen::Vector2d centre = rear + rotation(turn) * Eigen::Vector2d(4.0, -0.3);
    s.measurement.box = {centre.x(), centre.y(), turn, 8.0, 2.5};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.hiddenEnds.add(Face::Right);
    s.measurement.covariance.diagonal() << 0.1, 0.1, 0.007, 0.1, 0.1;
    return s;
}

TEST(LayersOfEnd, TellTheDirectionThatALineThroughAllOfThemMisses)
{
    const double turn = turnOfAll(boxAndFrame());
    ASSERT_GT(turn, 0.3);
    const Measurement m = withTurnOfLayers(rearTurned(turn), boxAndFrame());
    EXPECT_NEAR(m.box.heading, 0.0, 0.02);
    // What reaches farthest stays where it was measured, and the box turns about it.
    EXPECT_NEAR(m.box.x, kRearAt + 4.0, 0.15);
    EXPECT_EQ(m.box.length, 8.0);
}

TEST(LayersOfEnd, TurnFrontsAndRearsAlike)
{
    constexpr double kTurn = 0.2;
    Cluster hits;
    addRow(hits, 0.6, kRearAt, -0.8, 12, kTurn);
    addRow(hits, 1.2, kRearAt + 0.3, -0.2, 12, kTurn);
    const HitsAtOneTime seen = seenAs(std::move(hits));
    const double all = turnOfAll(seen);
    ASSERT_GT(std::abs(all - kTurn), 0.1);
    EXPECT_NEAR(withTurnOfLayers(rearTurned(all), seen).box.heading, kTurn, 0.02);
    Sighting front = rearTurned(all);
    front.measurement.box.heading = kPi + all;
    front.measurement.facesSeen = FaceSet();
    front.measurement.facesSeen.add(Face::Front);
    EXPECT_NEAR(std::remainder(withTurnOfLayers(front, seen).box.heading, kPi), kTurn, 0.02);
}

TEST(LayersOfEnd, AgreeWithAllHitsWhereHeightsAreMixed)
{
    Cluster hits;
    for (const double height : {0.5, 0.9})
        addRow(hits, height, kRearAt + 0.3 * height, -0.8, 20, 0.1);
    EXPECT_NEAR(withTurnOfLayers(rearTurned(0.05), seenAs(std::move(hits))).box.heading, 0.05,
                1e-3);
}

TEST(LayersOfEnd, OfTrucksMayBeWhatTheMeasurementFollowsAlready)
{
    const auto headingOf = [](double turn, double sigma, double height)
    {
        Sighting rear = rearTurned(turn);
        rear.height = height;
        rear.measurement.covariance(2, 2) = sigma * sigma;
        return withTurnOfLayers(rear, boxAndFrame()).box.heading;
    };
    const double all = turnOfAll(boxAndFrame());
    for (const double sigma : {0.002, 0.08})
    {
        EXPECT_NEAR(headingOf(0.0, sigma, 3.0), 0.0, 1e-3) << sigma;
        EXPECT_NEAR(headingOf(all, sigma, 3.0), 0.0, 0.02) << sigma;
    }
    // What is lower may be bowed: then rows, and all hits, are turned against its heading.
    EXPECT_LT(headingOf(0.0, 0.08, 1.5), -0.3);
}

TEST(LayersOfEnd, LeaveAloneWhatShowsMore)
{
    const Sighting piece = rearTurned(0.35);
    const auto headingOf = [](const Sighting& s, const HitsAtOneTime& seen)
    { return withTurnOfLayers(s, seen).box.heading; };
    Sighting whole = piece;
    whole.measurement.hiddenEnds = FaceSet();
    EXPECT_EQ(headingOf(whole, boxAndFrame()), 0.35);
    Sighting beside = piece;
    beside.measurement.facesSeen.add(Face::Left);
    EXPECT_EQ(headingOf(beside, boxAndFrame()), 0.35);
    HitsAtOneTime flat = boxAndFrame();
    Hits hits = *flat.hits;
    hits.heights = 0;
    flat.hits = std::move(hits);
    EXPECT_EQ(headingOf(piece, flat), 0.35);
}

TEST(LayersOfEnd, OfAFewHitsTellNothing)
{
    Cluster hits;
    addRow(hits, 1.3, kRearAt, 0.4, 2);
    addRow(hits, 0.7, kRearAt + 0.4, -0.4, 2);
    EXPECT_EQ(withTurnOfLayers(rearTurned(0.35), seenAs(std::move(hits))).box.heading, 0.35);
}

}  // namespace
}  // namespace vdamf
