// SPDX-License-Identifier: BSD-3-Clause
// How far boxes reach along a direction, and into each other.
#include "types/box_extent.h"

#include <gtest/gtest.h>

#include <random>

namespace vdamf
{
namespace
{
TEST(BoxExtent, HalfAlongIsThatOfTheFarthestCorner)
{
    const OrientedBox box{3.0, -2.0, 0.7, 4.3, 1.8};
    for (double direction = -3.0; direction < 3.2; direction += 0.25)
    {
        double farthest = 0.0;
        for (const Eigen::Vector2d& corner : corners(box))
            farthest = std::max(farthest, rotation(direction).col(0).dot(corner - box.centre()));
        EXPECT_NEAR(halfAlong(box, direction), farthest, 1e-12);
    }
}

TEST(BoxExtent, DepthIsTheShortestMoveThatPartsThem)
{
    const OrientedBox car{0, 0, 0, 4.0, 2.0};
    EXPECT_NEAR(depthInEachOther(car, {0.0, 1.5, 0, 4.0, 2.0}), 0.5, 1e-12) << "beside";
    EXPECT_NEAR(depthInEachOther(car, {0.0, 2.5, 0, 4.0, 2.0}), -0.5, 1e-12) << "apart";
    EXPECT_NEAR(depthInEachOther(car, {0.0, 0.0, 0.5 * kPi, 4.0, 2.0}), 3.0, 1e-12) << "across";
    EXPECT_NEAR(depthInEachOther(car, car), 2.0, 1e-12);
}

// Apart exactly where a line along a face of one lies between all corners of both.
TEST(BoxExtent, ThoseThatShareAPointLieInEachOther)
{
    std::mt19937 generator{3};
    std::uniform_real_distribution<double> place(-4.0, 4.0);
    int together = 0;
    for (int k = 0; k < 2000; ++k)
    {
        const OrientedBox a{0, 0, place(generator), 4.3, 1.8};
        const OrientedBox b{place(generator), place(generator), place(generator), 4.9, 1.9};
        bool share = false;
        for (double u = -0.5; u <= 0.5; u += 0.02)
            for (double v = -0.5; v <= 0.5; v += 0.02)
            {
                const Eigen::Vector2d p =
                    b.centre() + rotation(b.heading) * Eigen::Vector2d(u * b.length, v * b.width);
                const Eigen::Vector2d q = toBoxFrame(a, p).cwiseAbs();
                share = share || (q.x() < 0.5 * a.length && q.y() < 0.5 * a.width);
            }
        const double depth = depthInEachOther(a, b);
        if (share)
        {
            EXPECT_GT(depth, 0.0);
            ++together;
        }
        else
            EXPECT_LT(depth, 0.15);  // between the points tried
    }
    EXPECT_GT(together, 200);
}
}  // namespace
}  // namespace vdamf
