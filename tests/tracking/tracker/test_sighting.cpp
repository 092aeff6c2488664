// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/sighting.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
// A closed rear and a left side ahead, with the shape of a rear.
Sighting rearAndSide()
{
    Sighting s;
    s.measurement.box = {22.0, 1.0, 0.1, 4.4, 1.8};
    for (const Face face : {Face::Back, Face::Left}) s.measurement.facesSeen.add(face);
    s.around = {21.8, 1.0, 0.1, 4.0, 1.7};
    s.side.metres = 4.0;
    s.end.metres = 1.7;
    s.endAboveBumper = 0.3;
    s.front = 2.0;
    s.isBusEnd = true;
    return s;
}

TEST(SightingTurned, ByAQuarterItsSideIsAnEndOfUnknownShape)
{
    for (const int quarters : {1, 3})
    {
        const Sighting s = turnedBy(rearAndSide(), quarters);
        EXPECT_NEAR(s.measurement.box.heading, wrapAngle(0.1 + 0.5 * kPi * quarters), 1e-12);
        EXPECT_EQ(s.measurement.box.width, 4.4);
        EXPECT_EQ(s.around.heading, s.measurement.box.heading);
        EXPECT_EQ(s.around.width, 4.0);
        EXPECT_EQ(s.end.metres, 4.0);
        EXPECT_EQ(s.side.metres, 1.7);
        EXPECT_EQ(s.endAboveBumper, 0.0);
        EXPECT_EQ(s.front, 0.0);
        EXPECT_FALSE(s.isBusEnd);
    }
}

TEST(SightingTurned, ByAHalfTheShapeSpeaksAgainstItsFront)
{
    const Sighting s = turnedBy(rearAndSide(), 2);
    EXPECT_EQ(toString(s.measurement.facesSeen), "FR");
    EXPECT_EQ(s.measurement.box.width, 1.8);
    EXPECT_EQ(s.around.length, 4.0);
    EXPECT_EQ(s.side.metres, 4.0);
    EXPECT_EQ(s.endAboveBumper, 0.3);
    EXPECT_EQ(s.front, -2.0);
    EXPECT_TRUE(s.isBusEnd);
    EXPECT_EQ(turnedBy(rearAndSide(), 4).front, 2.0) << "by a whole turn nothing changes";
    EXPECT_NEAR(turnedBy(rearAndSide(), 4).measurement.box.heading, 0.1, 1e-12);
}

}  // namespace
}  // namespace vdamf
