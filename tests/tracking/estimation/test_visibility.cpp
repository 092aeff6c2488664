// SPDX-License-Identifier: BSD-3-Clause
// Visibility corrections of section 4.5.
#include "vdamf/tracking/estimation/visibility.h"

#include <gtest/gtest.h>

#include <random>

namespace vdamf
{
namespace
{
Measurement measured(const OrientedBox& box, FaceSet faces)
{
    Measurement m;
    m.box = box;
    m.covariance = (Vector5d() << 1e-4, 1e-4, 1e-5, 1e-3, 1e-3).finished().asDiagonal();
    m.facesSeen = faces;
    m.hits = 100;
    return m;
}

FaceSet faces(std::initializer_list<Face> list)
{
    FaceSet set;
    for (const Face f : list) set.add(f);
    return set;
}

SizeMemory sizeOf(double length, double width)
{
    return {{length, 0.01}, {width, 0.01}};
}

TEST(NearestPoint, IsACornerOrAFacePoint)
{
    const OrientedBox box{10.0, 0.0, 0.0, 4.0, 2.0};
    EXPECT_EQ(nearestPoint(box, {0.0, 5.0}), Eigen::Vector2d(-1.0, 1.0));
    EXPECT_EQ(nearestPoint(box, {0.0, 0.0}), Eigen::Vector2d(-1.0, 0.0));
    EXPECT_EQ(nearestPoint(box, {11.0, -9.0}), Eigen::Vector2d(0.5, -1.0));
}

TEST(AnchoredPose, KeepsTheNearestCorner)
{
    // The sensor sees 3 of 4.5 m; the near corner is the rear right one.
    const double heading = 0.3;
    const Eigen::Vector2d corner(8.0, 3.0);
    const OrientedBox seen = [&]
    {
        const Eigen::Vector2d c = corner + rotation(heading) * Eigen::Vector2d(1.5, 0.9);
        return OrientedBox{c.x(), c.y(), heading, 3.0, 1.8};
    }();
    const Measurement m = measured(seen, faces({Face::Back, Face::Right}));
    const PoseMeasurement pose = anchoredPose(m, sizeOf(4.5, 1.8), {0.0, 0.0}, VisibilityOptions());
    const Eigen::Vector2d expected = corner + rotation(heading) * Eigen::Vector2d(2.25, 0.9);
    EXPECT_LT((pose.pose.head<2>() - expected).norm(), 1e-12);
    EXPECT_EQ(pose.pose(2), heading);
}

TEST(AnchoredPose, CovarianceEqualsMonteCarlo)
{
    VisibilityOptions options;
    options.positionFloor = options.headingFloor = 0.0;
    const OrientedBox box{9.0, 4.0, 0.9, 3.0, 1.6};  // a corner is nearest
    Measurement m = measured(box, faces({Face::Back, Face::Right}));
    Matrix5d root = Matrix5d::Zero();
    root << 0.03, 0, 0, 0, 0, 0.01, 0.02, 0, 0, 0, 0.004, -0.003, 0.01, 0, 0, 0.05, 0.01, 0, 0.04,
        0, -0.01, 0.03, 0, 0.01, 0.03;
    m.covariance = root * root.transpose();
    const SizeMemory size = sizeOf(4.5, 1.8);
    const Eigen::Vector2d sensor(0.0, 0.0);
    const PoseMeasurement pose = anchoredPose(m, size, sensor, options);
    std::mt19937_64 generator(3);
    std::normal_distribution<double> gauss;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    const int runs = 20000;
    for (int k = 0; k < runs; ++k)
    {
        Vector5d u;
        for (int i = 0; i < 5; ++i) u(i) = gauss(generator);
        const Vector5d e = root * u;
        Measurement s = m;
        s.box = {box.x + e(0), box.y + e(1), box.heading + e(2), box.length + e(3),
                 box.width + e(4)};
        const Eigen::Vector3d d = anchoredPose(s, size, sensor, options).pose - pose.pose;
        sum += d * d.transpose();
    }
    const Eigen::Matrix3d sampled = sum / runs;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            EXPECT_NEAR(sampled(i, j), pose.covariance(i, j),
                        0.04 * std::sqrt(pose.covariance(i, i) * pose.covariance(j, j)));
}

TEST(Resized, HoldsTheNearestCornerAndThePathOfEveryPoint)
{
    VehicleState s;
    s.mean << 20.0, 5.0, 0.2, 6.0, 0.1, 1.0;
    const Eigen::Vector2d sensor(0.0, 0.0);
    const SizeMemory before = sizeOf(3.0, 1.5);
    const SizeMemory after = sizeOf(4.5, 1.8);
    const OrientedBox start{20.0, 5.0, 0.2, 3.0, 1.5};
    const VehicleState grown = resized(s, before, after, nearestPoint(start, sensor));
    const auto nearCorner = [&](const VehicleState& state, const SizeMemory& size)
    {
        const OrientedBox box{state.mean(kX), state.mean(kY), state.mean(kHeading),
                              size.length.mean, size.width.mean};
        return corners(box)[2];  // rear right
    };
    EXPECT_LT((nearCorner(grown, after) - nearCorner(s, before)).norm(), 1e-12);
    // The body moves as before: the near corner is at the same place after a step.
    const MotionOptions motion;
    const auto stepped = [&](const VehicleState& state)
    {
        VehicleState next;
        MotionOptions still = motion;
        still.axisTime = 1e9;
        next.mean = predictState(state.mean, 0.5, 4.5, still);
        return next;
    };
    EXPECT_LT((nearCorner(stepped(grown), after) - nearCorner(stepped(s), before)).norm(), 1e-6);
}

TEST(UpdatedSize, AveragesAndIgnoresLossOfVisibility)
{
    const VisibilityOptions options;
    const FaceSet both = faces({Face::Back, Face::Left});
    SizeMemory memory = initialSize(measured({0, 0, 0, 4.5, 1.8}, both), options);
    EXPECT_NEAR(memory.length.mean, 4.5, 0.1);  // after a car's prior
    for (int k = 0; k < 20; ++k)
        memory =
            updatedSize(memory, measured({0, 0, 0, k % 2 == 0 ? 4.4 : 4.6, 1.8}, both), options);
    EXPECT_NEAR(memory.length.mean, 4.5, 0.05);
    EXPECT_LT(memory.length.variance, 0.01);
    // Half hidden: hardly counts. Not seen at all: does not count.
    const SizeMemory lost = updatedSize(memory, measured({0, 0, 0, 2.2, 1.8}, both), options);
    EXPECT_NEAR(lost.length.mean, memory.length.mean, 0.05);
    const SizeMemory unseen =
        updatedSize(memory, measured({0, 0, 0, 2.2, 1.8}, faces({Face::Back})), options);
    EXPECT_EQ(unseen.length.mean, memory.length.mean);
    // More than remembered is real.
    const SizeMemory more = updatedSize(memory, measured({0, 0, 0, 5.5, 1.8}, both), options);
    EXPECT_GT(more.length.mean, memory.length.mean + 0.05);
}

TEST(InitialSize, AssumesACarBehindACarsEnd)
{
    const VisibilityOptions options;
    const SizeMemory rear =
        initialSize(measured({0, 0, 0, 1.0, 1.7}, faces({Face::Back})), options);
    EXPECT_EQ(rear.length.mean, options.carLength);
    EXPECT_GT(rear.length.variance, rear.width.variance);
    const SizeMemory post =
        initialSize(measured({0, 0, 0, 0.9, 0.7}, faces({Face::Back})), options);
    EXPECT_EQ(post.length.mean, 0.9);
    VisibilityOptions plain;
    plain.assumeVehicleSize = false;
    EXPECT_EQ(initialSize(measured({0, 0, 0, 1.0, 1.7}, faces({Face::Back})), plain).length.mean,
              1.0);
}

TEST(AlignedWith, TurnsFrontAndFaces)
{
    const Measurement m = measured({1, 2, 0.1, 4.5, 1.8}, faces({Face::Back, Face::Left}));
    const Measurement same = alignedWith(m, 0.3);
    EXPECT_EQ(toString(same.facesSeen), "BL");
    const Measurement turned = alignedWith(m, 3.0);
    EXPECT_NEAR(turned.box.heading, 0.1 - kPi, 1e-12);
    EXPECT_EQ(toString(turned.facesSeen), "FR");
}

}  // namespace
}  // namespace vdamf
