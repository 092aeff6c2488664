// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/partial_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace vdamf
{
namespace
{
// A car 20 m ahead whose rear shows a row of some metres on its left half.
Sighting rearSeen(double metres)
{
    Sighting s;
    s.measurement.box = {22.25, 0.0, 0.0, 4.5, 1.8};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.01, 0.01;
    s.end.metres = metres;
    s.height = 1.5;
    s.around = {20.05, 0.9 - 0.5 * metres, 0.0, 0.1, metres};
    return s;
}

// Of a place on the box, m^2, along x.
double varianceAt(const Measurement& m, double x, double y)
{
    Vector5d byBox = Vector5d::Zero();
    byBox.head<3>() << 1.0, 0.0, -(y - m.box.y);
    byBox(3) = (x - m.box.x) / m.box.length;
    return byBox.dot(m.covariance * byBox);
}

HitsAtOneTime hitsOnRear(double lowest)
{
    Cluster hits;
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 10; ++k)
        {
            hits.x.push_back(20.0F);
            hits.y.push_back(-0.9F + 0.2F * static_cast<float>(k));
            hits.height.push_back(static_cast<float>(lowest + 0.15 * row));
        }
    HitsAtOneTime seen;
    seen.hits = projectHits(hits, 0.0);
    seen.each = std::move(hits);
    return seen;
}

TEST(PartialFaces, APieceOfAnEndTellsLittleOfTheHeading)
{
    Sighting piece = rearSeen(0.6);
    piece.measurement.hiddenEnds.add(Face::Right);
    const Measurement m = withTurnOfPieces(piece);
    EXPECT_NEAR(std::sqrt(m.covariance(2, 2)), 0.165, 0.01);
    // The piece itself stays where it was seen.
    EXPECT_NEAR(varianceAt(m, 20.05, 0.6), varianceAt(piece.measurement, 20.05, 0.6), 0.002);
    EXPECT_GT(varianceAt(m, 20.0, -0.9), varianceAt(piece.measurement, 20.0, -0.9) + 0.05);
}

TEST(PartialFaces, AWholeFaceTellsItAsMeasured)
{
    const Sighting whole = rearSeen(1.8);
    EXPECT_EQ(withTurnOfPieces(whole).covariance, whole.measurement.covariance);
    Sighting withSide = rearSeen(0.6);
    withSide.measurement.hiddenEnds.add(Face::Right);
    withSide.measurement.facesSeen.add(Face::Left);
    withSide.side.metres = 4.2;
    EXPECT_EQ(withTurnOfPieces(withSide).covariance, withSide.measurement.covariance);
}

TEST(PartialFaces, HitsAboveTheBumperMayLieBehindTheEnd)
{
    const Sighting rear = rearSeen(1.8);
    const Measurement& seen = rear.measurement;
    const Measurement low = withRecessOfEnd(rear, hitsOnRear(0.3));
    EXPECT_EQ(low.covariance, seen.covariance);
    const Measurement high = withRecessOfEnd(rear, hitsOnRear(1.05));
    EXPECT_NEAR(varianceAt(high, 20.0, 0.0) - varianceAt(seen, 20.0, 0.0), 0.16, 0.01);
    EXPECT_NEAR(varianceAt(high, 24.5, 0.0), varianceAt(seen, 24.5, 0.0), 0.01);
}

TEST(PartialFaces, WithoutHeightsNothingIsKnownOfTheBumper)
{
    const Sighting rear = rearSeen(1.8);
    HitsAtOneTime level = hitsOnRear(1.05);
    Hits hits = *level.hits;
    hits.heights = 0;
    level.hits = hits;
    EXPECT_EQ(withRecessOfEnd(rear, level).covariance, rear.measurement.covariance);
}

TEST(PartialFaces, TrucksAreUpright)
{
    Sighting truck = rearSeen(1.8);
    truck.height = 3.0;
    EXPECT_EQ(withRecessOfEnd(truck, hitsOnRear(1.5)).covariance, truck.measurement.covariance);
}
}  // namespace
}  // namespace vdamf
