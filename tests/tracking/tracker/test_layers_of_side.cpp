// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_side.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tracking/tracker/seen_as.h"

namespace vdamf
{
namespace
{
constexpr double kSideAt = -5.0;    // m to the left of the sensor: it sees the left side
constexpr double kNearEnd = 14.0;   // m ahead, of the rear
constexpr double kVanLength = 5.0;  // m

// Hits of one height on the left side, from and to a distance ahead, turned about the near corner.
void addSideRow(Cluster& hits, double height, double inset, double from, double to, double turn)
{
    for (double along = from; along <= to; along += 0.1)
    {
        const Eigen::Vector2d at = rotation(turn) * Eigen::Vector2d(along - kNearEnd, -inset);
        hits.x.push_back(static_cast<float>(kNearEnd + at.x()));
        hits.y.push_back(static_cast<float>(kSideAt + at.y()));
        hits.height.push_back(static_cast<float>(height));
    }
}

// Of a van behind a low car: its far half shows above 1.5 m alone, where it is 0.12 m narrower.
HitsAtOneTime behindALowCar(double turn)
{
    Cluster hits;
    for (const double height : {0.5, 0.9, 1.3})
        addSideRow(hits, height, 0.0, kNearEnd, kNearEnd + 2.5, turn);
    for (const double height : {1.55, 1.7}) addSideRow(hits, height, 0.12, 14.0, 19.0, turn);
    return seenAs(std::move(hits));
}

// By which a line through all of those hits is turned: its far half inwards, to the right.
constexpr double kTurnOfLine = -0.023;

// Rear and left side of a box measured with that heading, about its near corner.
Sighting sideMeasuredAt(double heading)
{
    Sighting s;
    const Eigen::Vector2d corner(kNearEnd, kSideAt);
    const Eigen::Vector2d centre =
        corner + rotation(heading) * Eigen::Vector2d(0.5 * kVanLength, -1.0);
    s.measurement.box = {centre.x(), centre.y(), heading, kVanLength, 2.0};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.facesSeen.add(Face::Left);
    s.measurement.covariance.diagonal() << 0.01, 0.01, 2e-4, 0.01, 0.01;
    s.side.metres = kVanLength;
    return s;
}

double headingBySide(const Sighting& sighting, const HitsAtOneTime& seen)
{
    return withTurnOfSideLayers(sighting, seen).box.heading;
}

TEST(LayersOfSide, TellTheDirectionThatALineThroughAllOfThemMisses)
{
    for (const double turn : {0.0, 0.02, -0.02})
    {
        const Sighting measured = sideMeasuredAt(turn + kTurnOfLine);
        const Measurement m = withTurnOfSideLayers(measured, behindALowCar(turn));
        EXPECT_NEAR(m.box.heading, turn, 0.003) << turn;
        const Eigen::Vector2d corner =
            m.box.centre() + rotation(m.box.heading) * Eigen::Vector2d(-0.5 * kVanLength, 1.0);
        EXPECT_NEAR(corner.x(), kNearEnd, 1e-9) << "the near corner stays";
        EXPECT_NEAR(corner.y(), kSideAt, 1e-9);
        EXPECT_EQ(m.box.length, kVanLength);
    }
}

TEST(LayersOfSide, TurnTheRightSideOfAFrontTheSameWay)
{
    // The same hits, of a vehicle that faces the sensor.
    Sighting towards = sideMeasuredAt(kTurnOfLine);
    towards.measurement.box.heading = kPi + kTurnOfLine;
    towards.measurement.facesSeen = FaceSet();
    towards.measurement.facesSeen.add(Face::Front);
    towards.measurement.facesSeen.add(Face::Right);
    EXPECT_NEAR(std::remainder(headingBySide(towards, behindALowCar(0.0)), kPi), 0.0, 0.003);
}

TEST(LayersOfSide, LeaveAloneWhatErrsByOtherThings)
{
    EXPECT_NEAR(headingBySide(sideMeasuredAt(-0.05), behindALowCar(0.0)), -0.05 - kTurnOfLine,
                0.003)
        << "by no more than the line is turned";
    EXPECT_NEAR(headingBySide(sideMeasuredAt(0.0), behindALowCar(0.0)), 0.0, 1e-3)
        << "it followed a row";
    EXPECT_EQ(headingBySide(sideMeasuredAt(0.02), behindALowCar(0.0)), 0.02) << "the other way";
    Cluster whole;
    for (const double height : {0.5, 0.9, 1.3, 1.7})
        addSideRow(whole, height, height > 1.5 ? 0.12 : 0.0, 14.0, 19.0, 0.0);
    EXPECT_NEAR(headingBySide(sideMeasuredAt(-0.03), seenAs(std::move(whole))), -0.03, 1e-3)
        << "all heights show everywhere";
}

TEST(LayersOfSide, TellNothingOfWhatIsVagueOrShort)
{
    const HitsAtOneTime seen = behindALowCar(0.0);
    Sighting vague = sideMeasuredAt(-0.03);
    vague.measurement.covariance(2, 2) = 0.01;
    EXPECT_EQ(headingBySide(vague, seen), -0.03);
    Sighting shortOne = sideMeasuredAt(-0.03);
    shortOne.side.metres = 1.5;
    EXPECT_EQ(headingBySide(shortOne, seen), -0.03);
    Sighting sure = sideMeasuredAt(-0.03);
    sure.measurement.covariance(2, 2) = 1e-10;
    EXPECT_EQ(headingBySide(sure, seen), -0.03) << "more than the rows are";
    Sighting end = sideMeasuredAt(-0.03);
    end.measurement.facesSeen.remove(Face::Left);
    EXPECT_EQ(headingBySide(end, seen), -0.03);
    HitsAtOneTime flat = behindALowCar(0.0);
    Hits hits = *flat.hits;
    hits.heights = 0;
    flat.hits = std::move(hits);
    EXPECT_EQ(headingBySide(sideMeasuredAt(-0.03), flat), -0.03);
}

}  // namespace
}  // namespace vdamf
