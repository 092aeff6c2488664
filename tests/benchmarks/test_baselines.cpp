// SPDX-License-Identifier: BSD-3-Clause
// The published baselines on figures with known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measurement/baselines.h"
#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
namespace
{
// The outline of two faces of a box, 5 cm from point to point.
PlanePoints twoFaces(const OrientedBox& box)
{
    const int count = static_cast<int>((box.length + box.width) / 0.05);
    PlanePoints points(2, count);
    for (int i = 0; i < count; ++i)
    {
        const double along = 0.05 * i;
        const Eigen::Vector2d onFace =
            along < box.length
                ? Eigen::Vector2d(along - 0.5 * box.length, -0.5 * box.width)
                : Eigen::Vector2d(-0.5 * box.length, along - box.length - 0.5 * box.width);
        points.col(i) = box.centre() + rotation(box.heading) * onFace;
    }
    return points;
}

double turn(double a, double b)
{
    return std::abs(std::remainder(a - b, kPi));
}

TEST(Baselines, LShapeFindsExactFaces)
{
    for (const double degrees : {0.0, 17.0, 45.0, 71.0, 89.0, 130.0, -60.0})
    {
        const OrientedBox box{12.0, -7.0, degrees * kDegree, 4.4, 1.8};
        const PlanePoints points = twoFaces(box);
        for (const OrientedBox& found : {lShapeByCloseness(points), lShapeByVariance(points)})
        {
            EXPECT_LT(turn(found.heading, box.heading), 0.01 * kDegree) << degrees;
            EXPECT_NEAR(found.length, box.length, 0.06) << degrees;
            EXPECT_NEAR(found.width, box.width, 0.06) << degrees;
            EXPECT_LT((found.centre() - box.centre()).norm(), 0.06) << degrees;
        }
    }
}

TEST(Baselines, MinimumAreaIsTheLeastOfAllHeadings)
{
    RandomStream random(3, 0);
    for (int figure = 0; figure < 50; ++figure)
    {
        PlanePoints points(2, 4 + figure);
        for (Eigen::Index i = 0; i < points.cols(); ++i)
            points.col(i) = Eigen::Vector2d(3.0 * random.gaussian(), random.gaussian());
        const OrientedBox found = minimumAreaBox(points);
        double least = 1e300;
        for (int k = 0; k < 9000; ++k)
        {
            const OrientedBox box = boundingBox(points, k * 0.01 * kDegree);
            least = std::min(least, box.length * box.width);
        }
        EXPECT_LE(found.length * found.width, least + 1e-9) << figure;
        EXPECT_GE(found.length * found.width, 0.99 * least) << figure;
    }
}

TEST(Baselines, PrincipalAxisOfALine)
{
    PlanePoints points(2, 3);
    points << 0.0, 1.0, 2.0, 0.0, 1.0, 2.0;
    const OrientedBox found = principalAxisBox(points);
    EXPECT_LT(turn(found.heading, 45.0 * kDegree), 1e-9);
    EXPECT_NEAR(found.length, 2.0 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(found.width, 0.0, 1e-9);
}

TEST(Baselines, OneAndTwoPointsAndEqualOnesAreNoHarm)
{
    PlanePoints one(2, 1);
    one << 3.0, 4.0;
    const PlanePoints equal = one.replicate(1, 5);
    PlanePoints two(2, 2);
    two << 3.0, 5.0, 4.0, 4.0;
    for (const PlanePoints& points : {one, two, equal})
    {
        for (const OrientedBox& box : {lShapeByCloseness(points), lShapeByVariance(points),
                                       minimumAreaBox(points), principalAxisBox(points)})
        {
            EXPECT_TRUE(std::isfinite(box.x + box.y + box.heading + box.length + box.width));
            EXPECT_NEAR(box.y, 4.0, 1e-6);
        }
    }
    EXPECT_NEAR(minimumAreaBox(two).length, 2.0, 1e-12);
}
}  // namespace
}  // namespace vdamf
