// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/end_above_bumper.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracking/tracker/rear_seen.h"

namespace vdamf
{
namespace
{
Measurement recessOf(Sighting sighting, const HitsAtOneTime& seen)
{
    sighting.endAboveBumper = endAboveBumper(sighting, seen);
    return withRecessOfEnd(sighting);
}

TEST(EndAboveBumper, HitsAboveTheBumperMayLieBehindTheEnd)
{
    const Sighting rear = rearSeen(1.8);
    const Measurement& seen = rear.measurement;
    const Measurement low = recessOf(rear, hitsOnRear(0.3));
    EXPECT_EQ(low.covariance, seen.covariance);
    const auto recess = [&seen](const Sighting& of, double lowest)
    {
        const Measurement m = recessOf(of, hitsOnRear(lowest));
        EXPECT_NEAR(varianceAt(m, 24.5, 0.0), varianceAt(seen, 24.5, 0.0), 0.01);
        return std::sqrt(varianceAt(m, 20.0, 0.0) - varianceAt(seen, 20.0, 0.0));
    };
    EXPECT_NEAR(recess(rear, 0.75), 0.14, 0.01);
    EXPECT_NEAR(recess(rear, 1.05), 1.04, 0.02) << "they may be on a bonnet or a windscreen";
    Sighting van = rear;
    van.height = 1.9;
    EXPECT_NEAR(recess(van, 1.05), 0.4, 0.02);
}

// Of a rear half hidden by what is nearer the roof shows, and at the corner all of the side.
HitsAtOneTime roofAndCorner(double lowestOfRear)
{
    Cluster hits = *hitsOnRear(lowestOfRear).each;
    for (int k = 0; k < 8; ++k)
    {
        hits.x.push_back(20.02F + 0.03F * static_cast<float>(k));
        hits.y.push_back(0.85F);
        hits.height.push_back(0.4F);
    }
    return seenAs(std::move(hits));
}

TEST(EndAboveBumper, LowHitsAtTheCornerAreTheSides)
{
    Sighting rear = rearSeen(1.8);
    const HitsAtOneTime seen = roofAndCorner(0.95);
    // All of them could be the rear's,
    EXPECT_EQ(recessOf(rear, seen).covariance, rear.measurement.covariance);
    // but not where the side is seen as well;
    rear.measurement.facesSeen.add(Face::Left);
    const Measurement m = recessOf(rear, seen);
    EXPECT_GT(varianceAt(m, 20.0, 0.0), varianceAt(rear.measurement, 20.0, 0.0) + 0.05);
    // of a short row at the corner nothing tells whose it is.
    rear.end.metres = 0.5;
    EXPECT_EQ(recessOf(rear, seen).covariance, rear.measurement.covariance);
}

TEST(EndAboveBumper, TheEdgeOfWhatHidesARoofIsNoEnd)
{
    Sighting rear = rearSeen(1.8);
    rear.measurement.facesSeen.add(Face::Left);
    const Measurement m = recessOf(rear, roofAndCorner(1.3));
    EXPECT_FALSE(m.facesSeen.seesEnd());
    EXPECT_TRUE(m.facesSeen.has(Face::Left));
    EXPECT_TRUE(m.hiddenEnds.has(Face::Back));
}

TEST(EndAboveBumper, WithoutHeightsNothingIsKnownOfTheBumper)
{
    const Sighting rear = rearSeen(1.8);
    HitsAtOneTime level = hitsOnRear(1.05);
    Hits hits = *level.hits;
    hits.heights = 0;
    level.hits = hits;
    EXPECT_EQ(recessOf(rear, level).covariance, rear.measurement.covariance);
}

TEST(EndAboveBumper, TrucksAreUpright)
{
    Sighting truck = rearSeen(1.8);
    truck.height = 3.0;
    EXPECT_EQ(recessOf(truck, hitsOnRear(1.5)).covariance, truck.measurement.covariance);
}

// Of the rear of a car that is known to be `inside` metres nearer to the sensor than it was seen.
double sigmaOfRearSeen(double lowest, double inside)
{
    Sighting rear = rearSeen(1.8);
    rear.endAboveBumper = endAboveBumper(rear, hitsOnRear(lowest));
    VehicleState foretold;
    foretold.mean << 22.25 - 0.5 * inside, 0.0, 0.0, 0.0, 0.0, 1.0, 4.5 + inside;
    foretold.width = 1.8;
    const Measurement m = withEndAsForetold(rear.measurement, rear, foretold);
    EXPECT_NEAR(varianceAt(m, 24.5, 0.0), varianceAt(rear.measurement, 24.5, 0.0), 1e-9)
        << "the front is not in question";
    return std::sqrt(varianceAt(m, 20.0, 0.0) - varianceAt(rear.measurement, 20.0, 0.0));
}

TEST(EndAboveBumper, InsideOfWhereItIsForetoldItIsAsUncertainAsThat)
{
    EXPECT_NEAR(sigmaOfRearSeen(0.75, 0.6), 0.6, 1e-9);
    EXPECT_NEAR(sigmaOfRearSeen(0.75, 2.0), 0.8, 1e-6) << "hits 0.1 m above it lie no farther in";
    EXPECT_NEAR(sigmaOfRearSeen(1.05, 2.0), 1.2, 1e-9) << "all of a bonnet";
    EXPECT_EQ(sigmaOfRearSeen(0.75, -0.3), 0.0) << "farther out it is where it was seen";
    EXPECT_EQ(sigmaOfRearSeen(0.5, 0.6), 0.0) << "hits on the bumper show it";
}

TEST(EndAboveBumper, AsForetoldOfAFrontToo)
{
    Sighting front = rearSeen(1.8);
    front.endAboveBumper = 0.1;
    front.measurement.box.heading = kPi;
    front.measurement.facesSeen = {};
    front.measurement.facesSeen.add(Face::Front);
    VehicleState foretold;
    foretold.mean << 22.0, 0.0, kPi, 0.0, 0.0, 1.0, 5.0;
    foretold.width = 1.8;
    const Measurement m = withEndAsForetold(front.measurement, front, foretold);
    Vector5d byFront = Vector5d::Zero();  // of its place along x
    byFront(0) = 1.0;
    byFront(3) = -0.5;
    const Matrix5d added = m.covariance - front.measurement.covariance;
    EXPECT_NEAR(byFront.dot(added * byFront), 0.5 * 0.5, 1e-9);
    // One that lies across shows no end of it.
    foretold.mean(kHeading) = 0.5 * kPi;
    EXPECT_EQ(withEndAsForetold(front.measurement, front, foretold).covariance,
              front.measurement.covariance);
}

}  // namespace
}  // namespace vdamf
