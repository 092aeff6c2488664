// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/tracking/estimation/visibility.h"
#include "vdamf/tracking/preprocessing/range_profile.h"

namespace vdamf
{
namespace
{
// A profile with one blocking sector range.
RangeProfile blockedBetween(double fromBearing, double toBearing, float range)
{
    RangeProfile profile;
    profile.nearest.assign(720, std::numeric_limits<float>::infinity());
    for (std::size_t k = 0; k < profile.nearest.size(); ++k)
    {
        const double bearing = -kPi + 2.0 * kPi * (static_cast<double>(k) + 0.5) / 720.0;
        if (bearing > fromBearing && bearing < toBearing) profile.nearest[k] = range;
    }
    return profile;
}

FaceSet leftSide()
{
    FaceSet seen;
    seen.add(Face::Left);
    return seen;
}

// A 12 m wall along +x, seen from its left (the sensor at +y): front at x = 6, back at x = -6.
const OrientedBox kWall{0.0, 0.0, 0.0, 12.0, 0.7};
const Eigen::Vector2d kSensorOnLeft(0.0, 8.0);

TEST(RangeProfile, KeepsTheNearestHighHit)
{
    LadarFrame frame;
    frame.sensor = {100.0, 50.0, 2.0};
    frame.origin = {98.0, 50.0, 0.0};
    frame.points.x = {12.0F, 7.0F, 5.0F};
    frame.points.y = {0.01F, 0.01F, 0.01F};
    frame.points.z = {1.0F, 1.0F, 0.3F};
    const AboveGround above{{0, 1, 2}, {1.0F, 1.0F, 0.3F}};
    const RangeProfile profile = rangeProfile(frame, above);
    EXPECT_NEAR(profile.at(0.001), 5.0, 1e-4);  // the low hit hides nothing
    EXPECT_NEAR(profile.at(2.0 * kPi + 0.001), 5.0, 1e-4);
    EXPECT_TRUE(std::isinf(profile.at(1.0)));
    EXPECT_TRUE(std::isinf(RangeProfile{}.at(0.0)));
}

TEST(HiddenEnds, FreeEndsAreSeen)
{
    EXPECT_TRUE(blockedEnds(kWall, leftSide(), kSensorOnLeft, blockedBetween(0, 0, 0)).empty());
}

TEST(HiddenEnds, ANearerObjectBesideAnEndHidesIt)
{
    // The ray past the front goes to (6.6, 0.35): bearing about -49 deg.
    const double bearing = std::atan2(0.35 - 8.0, 6.6);
    const RangeProfile near = blockedBetween(bearing - 0.05, bearing + 0.05, 5.0F);
    EXPECT_EQ(toString(blockedEnds(kWall, leftSide(), kSensorOnLeft, near)), "F");
    // So does what lies as far away: it may be the rest of the face.
    const RangeProfile beside = blockedBetween(bearing - 0.05, bearing + 0.05, 10.2F);
    EXPECT_EQ(toString(blockedEnds(kWall, leftSide(), kSensorOnLeft, beside)), "F");
    const RangeProfile behind = blockedBetween(bearing - 0.05, bearing + 0.05, 20.0F);
    EXPECT_TRUE(blockedEnds(kWall, leftSide(), kSensorOnLeft, behind).empty());
    // A face with hits of its own is never hidden.
    FaceSet both = leftSide();
    both.add(Face::Front);
    EXPECT_TRUE(blockedEnds(kWall, both, kSensorOnLeft, near).empty());
}

TEST(HiddenEnds, GrazingRaysDoNotTellAnEnd)
{
    const Eigen::Vector2d along(-8.0, 1.0);  // almost in line with the wall
    EXPECT_TRUE(grazedEnds(kWall, leftSide(), along, 0.0).has(Face::Front));
}

TEST(HiddenEnds, RaysThatMayGrazeDoNotTellAnEndEither)
{
    const Eigen::Vector2d oblique(-21.6, 6.0);  // rays past the front meet the wall at 11 deg
    EXPECT_TRUE(grazedEnds(kWall, leftSide(), oblique, 0.0).empty());
    EXPECT_TRUE(grazedEnds(kWall, leftSide(), oblique, 0.01).empty());
    EXPECT_EQ(toString(grazedEnds(kWall, leftSide(), oblique, 0.08)), "F");
}

TEST(HiddenEnds, OfACarLeaveTheOtherEndAsTheFixedPoint)
{
    Measurement m;
    m.box = {10.0, 0.0, 0.0, 12.0, 2.0};
    m.facesSeen = leftSide();
    m.hiddenEnds.add(Face::Back);
    EXPECT_EQ(toString(turnedBy(m, 2).hiddenEnds), "F");
    const VisibilityOptions options;
    const Eigen::Vector2d sensor(0.0, 5.0);
    const auto box = [&]
    { return boxThrough(m, faceErrors(m, options), Eigen::Vector2d(12.0, 2.0), sensor, options); };
    EXPECT_EQ(box().fixedPoint, Eigen::Vector2d(1.0, 1.0));
    // Both hidden: the row may slide along itself, its distance is as good as before.
    m.hiddenEnds.add(Face::Front);
    EXPECT_GT(box().covariance(0, 0), 40.0);
    EXPECT_LT(withKnown(box(), 4, 2.0, 0.01).covariance(1, 1), 0.1);
}

// Behind and to the left of a car that heads along x: its rear is at x = 9.75, its left side at
// y = -2.1, their corner at a bearing of -0.21.
TEST(ShadowEdges, AreBesideWhatIsNearer)
{
    const OrientedBox car{12.0, -3.0, 0.0, 4.5, 1.8};
    FaceSet both;
    both.add(Face::Back);
    both.add(Face::Left);
    const auto edges = [&](FaceSet seen, const RangeProfile& profile)
    { return toString(shadowEdges(car, seen, Eigen::Vector2d::Zero(), profile)); };
    EXPECT_EQ(edges(both, RangeProfile()), "");
    EXPECT_EQ(edges(both, blockedBetween(-0.20, 0.2, 5.0F)), "L");
    EXPECT_EQ(edges(both, blockedBetween(-0.5, -0.205, 5.0F)), "B");
    EXPECT_EQ(edges(both, blockedBetween(-0.24, 0.2, 5.0F)), "L") << "the corner as well";
    EXPECT_EQ(edges(both, blockedBetween(-0.20, 0.2, 11.0F)), "") << "the car itself";
    EXPECT_EQ(edges(leftSide(), blockedBetween(-0.20, 0.2, 5.0F)), "") << "no corner";
    RangeProfile coarse;
    coarse.nearest.assign(90, 5.0F);
    EXPECT_EQ(edges(both, coarse), "") << "four degrees are 0.8 m";
    RangeProfile gap = blockedBetween(-0.20, 0.2, 5.0F);
    const RangeProfile other = blockedBetween(-0.5, -0.205, 5.0F);
    for (std::size_t k = 0; k < gap.nearest.size(); ++k)
        gap.nearest[k] = std::min(gap.nearest[k], other.nearest[k]);
    EXPECT_EQ(edges(both, gap), "");
}

}  // namespace
}  // namespace vdamf
