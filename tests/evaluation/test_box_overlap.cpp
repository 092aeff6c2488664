// SPDX-License-Identifier: BSD-3-Clause
// Overlap of boxes: cases known by hand, grid sampling, and invariance.
#include "vdamf/evaluation/box_overlap.h"

#include <gtest/gtest.h>

#include <random>

namespace vdamf
{
namespace
{
bool contains(const OrientedBox& box, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d p = toBoxFrame(box, point);
    return std::abs(p.x()) <= 0.5 * box.length && std::abs(p.y()) <= 0.5 * box.width;
}

// Area by counting the cells of a grid over a whose centres lie in both.
double sampledIntersection(const OrientedBox& a, const OrientedBox& b, int cells)
{
    int inside = 0;
    for (int i = 0; i < cells; ++i)
    {
        for (int j = 0; j < cells; ++j)
        {
            const Eigen::Vector2d inA(((i + 0.5) / cells - 0.5) * a.length,
                                      ((j + 0.5) / cells - 0.5) * a.width);
            inside += contains(b, a.centre() + rotation(a.heading) * inA) ? 1 : 0;
        }
    }
    return a.length * a.width * inside / (static_cast<double>(cells) * cells);
}

OrientedBox randomBox(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> position(-3.0, 3.0);
    std::uniform_real_distribution<double> heading(-kPi, kPi);
    std::uniform_real_distribution<double> size(0.5, 6.0);
    return {position(random), position(random), heading(random), size(random), size(random)};
}

TEST(BoxOverlap, KnownByHand)
{
    const OrientedBox square = {0.0, 0.0, 0.0, 2.0, 2.0};
    EXPECT_DOUBLE_EQ(birdsEyeIou(square, square), 1.0);
    EXPECT_DOUBLE_EQ(intersectionArea(square, {1.0, 0.0, 0.0, 2.0, 2.0}), 2.0);
    EXPECT_DOUBLE_EQ(birdsEyeIou(square, {1.0, 0.0, 0.0, 2.0, 2.0}), 1.0 / 3.0);
    // A cross of two bars, and a small box inside.
    EXPECT_NEAR(intersectionArea({0, 0, 0, 4, 1}, {0, 0, kPi / 2, 4, 1}), 1.0, 1e-12);
    EXPECT_NEAR(intersectionArea(square, {0.3, -0.2, 0.7, 0.5, 0.4}), 0.2, 1e-12);
    // The square turned by 45 degrees: a regular octagon of inradius 1.
    EXPECT_NEAR(intersectionArea(square, {0, 0, kPi / 4, 2, 2}), 8.0 * std::tan(kPi / 8.0), 1e-12);
    // A corner of the turned square reaches into it.
    EXPECT_NEAR(intersectionArea(square, {1.0 + std::sqrt(2.0) - 0.5, 0, kPi / 4, 2, 2}), 0.25,
                1e-12);
}

TEST(BoxOverlap, HeadingByHalfATurnIsTheSameBox)
{
    const OrientedBox a = {1.0, 2.0, 0.3, 4.5, 1.8};
    OrientedBox b = a;
    b.heading += kPi;
    EXPECT_NEAR(birdsEyeIou(a, b), 1.0, 1e-12);
}

TEST(BoxOverlap, ApartTouchingAndEmpty)
{
    const OrientedBox square = {0.0, 0.0, 0.0, 2.0, 2.0};
    EXPECT_EQ(birdsEyeIou(square, {2.5, 0.0, 0.0, 2.0, 2.0}), 0.0);
    EXPECT_EQ(birdsEyeIou(square, {2.0, 0.0, 0.0, 2.0, 2.0}), 0.0);
    EXPECT_EQ(birdsEyeIou(square, {50.0, 0.0, 0.0, 2.0, 2.0}), 0.0);
    EXPECT_EQ(birdsEyeIou(square, {0.0, 0.0, 0.0, 0.0, 2.0}), 0.0);
    EXPECT_EQ(birdsEyeIou({}, {}), 0.0);
    EXPECT_EQ(birdsEyeIou(square, {0.0, 0.0, 0.0, -2.0, -2.0}), 0.0);
}

TEST(BoxOverlap, AgreesWithSampling)
{
    std::mt19937_64 random(3);
    int overlapping = 0;
    for (int i = 0; i < 200; ++i)
    {
        const OrientedBox a = randomBox(random);
        const OrientedBox b = randomBox(random);
        const double sampled = sampledIntersection(a, b, 200);
        // A grid of n x n cells misses by about a cell along the cut line, much of it averaged out.
        EXPECT_NEAR(intersectionArea(a, b), sampled, 0.01 * a.length * a.width);
        overlapping += sampled > 0.0 ? 1 : 0;
    }
    EXPECT_GT(overlapping, 100);
}

TEST(BoxOverlap, IsSymmetricAndMovesWithTheWorld)
{
    std::mt19937_64 random(4);
    for (int i = 0; i < 200; ++i)
    {
        const OrientedBox a = randomBox(random);
        const OrientedBox b = randomBox(random);
        const double iou = birdsEyeIou(a, b);
        EXPECT_NEAR(birdsEyeIou(b, a), iou, 1e-12);
        const auto moved = [](OrientedBox box)
        {
            const Eigen::Vector2d centre = rotation(1.1) * box.centre();
            return OrientedBox{centre.x() + 5e5, centre.y() - 3e6, box.heading + 1.1, box.length,
                               box.width};
        };
        EXPECT_NEAR(birdsEyeIou(moved(a), moved(b)), iou, 1e-8);
    }
}

}  // namespace
}  // namespace vdamf
