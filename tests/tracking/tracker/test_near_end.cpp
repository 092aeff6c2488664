// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/near_end.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
// A car 20 m ahead, seen from behind and the right, with a row of hits on that side from `first`
// to `last` before the sensor (m), and its rear taken for a metre farther away than it is.
Sighting sideSeen(double first, double last)
{
    Sighting s;
    s.measurement.box = {22.75, 5.0, 0.0, 3.5, 1.8};
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.facesSeen.add(Face::Right);
    s.measurement.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.01, 0.01;
    s.side = {last - first, 30.0, {0.5 * (first + last), 4.1}};
    return s;
}

double varianceOfRear(const Measurement& m)
{
    Vector5d place;
    place << 1.0, 0.0, 0.0, -0.5, 0.0;
    return place.dot(m.covariance * place);
}

TEST(NearEnd, IsWhereTheRowOnTheSideBegins)
{
    const Sighting seen = sideSeen(20.0, 24.4);
    const Measurement m = withNearEndOfRow(seen);
    EXPECT_NEAR(m.box.x - 0.5 * m.box.length, 20.0, 1e-12);
    EXPECT_NEAR(m.box.x + 0.5 * m.box.length, 24.5, 1e-12) << "the other one stays";
    EXPECT_EQ(m.box.y, 5.0);
    EXPECT_EQ(toString(m.facesSeen), "R");
    EXPECT_TRUE(m.hiddenEnds.empty());
    EXPECT_NEAR(varianceOfRear(m), varianceOfRear(seen.measurement) + 0.15 * 0.15, 1e-12);
}

TEST(NearEnd, OfAVehicleSeenFromAhead)
{
    Sighting seen = sideSeen(21.1, 25.5);
    seen.sensor = {45.0, 0.0};
    seen.measurement.facesSeen.remove(Face::Back);
    seen.measurement.facesSeen.add(Face::Front);
    const Measurement m = withNearEndOfRow(seen);
    EXPECT_NEAR(m.box.x + 0.5 * m.box.length, 25.5, 1e-12);
    EXPECT_NEAR(m.box.x - 0.5 * m.box.length, 21.0, 1e-12);
    EXPECT_FALSE(m.facesSeen.seesEnd());
}

TEST(NearEnd, StaysWhereNothingLiesBeforeIt)
{
    for (const double first : {20.9, 22.0})
    {
        const Measurement m = withNearEndOfRow(sideSeen(first, 24.4));
        EXPECT_EQ(m.box.length, 3.5) << first;
        EXPECT_EQ(toString(m.facesSeen), "BR");
    }
    // What lies behind the far end tells nothing of the near one.
    EXPECT_EQ(withNearEndOfRow(sideSeen(21.0, 30.0)).box.length, 3.5);
    // Without a side there is no row of it, and perhaps none with one.
    Sighting none = sideSeen(20.0, 24.4);
    none.side = {};
    EXPECT_EQ(withNearEndOfRow(none).box.length, 3.5);
    Sighting rear = sideSeen(20.0, 24.4);
    rear.measurement.facesSeen.remove(Face::Right);
    EXPECT_EQ(withNearEndOfRow(rear).box.length, 3.5);
}
}  // namespace
}  // namespace vdamf
