// SPDX-License-Identifier: BSD-3-Clause
// What is usual of vehicles' faces, the sums over their hits, and whether two faces meet.
#include "matched_filter/face_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "matched_filter/body_profile.h"
#include "matched_filter/corner_check.h"
#include "matched_filter/insets.h"
#include "matched_filter/range_noise.h"
#include "tracking/matched_filter/example_hits.h"

namespace vdamf
{
namespace
{
constexpr std::uint64_t height(double metres)
{
    return std::uint64_t{1} << static_cast<unsigned>(10.0 * metres);
}

TEST(BodyProfile, CarsAreLongestAtTheBumper)
{
    const BodyProfile bumper = bodyProfile(Face::Front, height(0.55));
    const BodyProfile nose = bodyProfile(Face::Front, height(0.75));
    const BodyProfile bonnet = bodyProfile(Face::Front, height(0.95));
    EXPECT_LT(bumper.beyondError, nose.beyondError);
    EXPECT_LT(nose.beyond, bonnet.beyond);
    EXPECT_LT(nose.beyondError, bonnet.beyondError);
    // Whatever else is seen, the bumper tells.
    EXPECT_EQ(bodyProfile(Face::Front, height(0.55) | height(0.95)).beyond, bumper.beyond);
    // Unlike bonnets, sides hardly recede.
    EXPECT_LT(bodyProfile(Face::Left, height(0.95)).beyond, 0.1 * bonnet.beyond);
}

TEST(BodyProfile, WhatIsTallIsFlat)
{
    const BodyProfile car = bodyProfile(Face::Front, height(0.95));
    const BodyProfile truck = bodyProfile(Face::Front, height(0.95) | height(2.85));
    EXPECT_LT(truck.beyond, 0.5 * car.beyond);
    EXPECT_LT(truck.beyondError, 0.5 * car.beyondError);
}

TEST(BodyProfile, UnknownHeightsTellNothing)
{
    for (const std::uint64_t heights : {std::uint64_t{0}, std::uint64_t{1}})
    {
        const BodyProfile profile = bodyProfile(Face::Front, heights);
        EXPECT_EQ(profile.beyond, 0.0);
        EXPECT_EQ(profile.beyondError, 0.0);
    }
}

NearFace faceWithHits(int count, unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> gauss;
    NearFace face;
    face.slope = -1.0;
    for (int i = 0; i < count; ++i)
        face.hits.add(0.9 + 0.05 * gauss(generator), 2.0 * gauss(generator), 1.0 + i % 3, 1e-4);
    return face;
}

TEST(LineSums, AreTheSameOnEveryPath)
{
    for (const int count : {1, 15, 16, 17, 400})
    {
        const NearFace face = faceWithHits(count, 3);
        const LineState line{0.01, 0.88, 0.06};
        const LineSums expected = lineSums(face, line, KernelPath::Baseline);
        const double scale = 1e-5 * count;
        for (const KernelPath path : kernelPaths())
        {
            const LineSums sums = lineSums(face, line, path);
            EXPECT_NEAR(sums.w, expected.w, scale);
            EXPECT_NEAR(sums.wa, expected.wa, 3.0 * scale);
            EXPECT_NEAR(sums.waa, expected.waa, 9.0 * scale);
            EXPECT_NEAR(sums.wr, expected.wr, scale);
            EXPECT_NEAR(sums.war, expected.war, 3.0 * scale);
            EXPECT_NEAR(sums.squares, expected.squares, scale);
            EXPECT_NEAR(sums.count, expected.count, scale);
        }
    }
}

TEST(Hull, OfWallsIsWhereTheHitsAre)
{
    const NearFace face = faceWithHits(2000, 5);
    NearFace noisy = face;
    noisy.noise = 0.05;
    // Gaussian hits: the line that weighs those inside less lies 0.48 sigma outwards.
    const LineState line{0.0, 0.9 + 0.481 * 0.05, 0.05};
    const Hull hull = hullOf(departureOf(noisy, line), noisy, line, {});
    EXPECT_NEAR(line.place + hull.outwards, 0.9, 0.01);
    EXPECT_LT(hull.error, 0.01);
    // The same scatter of a quiet sensor is the body's own.
    const Hull body = hullOf(departureOf(face, line), face, line, {0, Face::Left, 0.06});
    EXPECT_GT(line.place + body.outwards, 0.93);
    EXPECT_GT(body.error, hull.error);
}

// A face whose hits scatter on both sides of it, or lie inside of it up to a depth.
NearFaces wallOrBody(double noise, double depth)
{
    std::mt19937 generator(11);
    std::normal_distribution<double> gauss;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    NearFaces faces;
    faces[1].noise = 1.0;  // seen straight on
    for (int i = 0; i < 200; ++i)
    {
        const double u = uniform(generator);
        const double inside = depth * u * u * u;
        faces[1].hits.add(noise * gauss(generator) - inside, 4.0 * u - 2.0, 1.0, 0.0);
    }
    return faces;
}

TEST(RangeNoise, IsWhatScattersOnBothSides)
{
    for (const double noise : {0.02, 0.05, 0.1})
    {
        // The line that weighs those inside less lies 0.48 sigma outwards.
        const LineState line{0.0, 0.481 * noise, noise};
        const double estimated = estimatedRangeNoise(wallOrBody(noise, 0.0), line, line);
        EXPECT_NEAR(estimated, noise, 0.2 * noise);
    }
    const LineState line{0.0, 0.0, 0.1};
    EXPECT_LT(estimatedRangeNoise(wallOrBody(0.01, 0.4), line, line), 0.025);
}

TEST(Insets, MoveTheFacesSeenInwardsAndNoOthers)
{
    const OrientedBox box{20.0, 0.0, 0.0, 4.5, 1.8};  // shows its back to the sensor
    FaceSet back;
    back.add(Face::Back);
    const OrientedBox inner = withInsets(box, back, Eigen::Vector2d::Zero());
    EXPECT_NEAR((inner.x - 0.5 * inner.length) - (box.x - 0.5 * box.length), 0.32, 1e-9);
    EXPECT_NEAR(inner.width, box.width, 1e-12);
    EXPECT_NEAR(inner.y, box.y, 1e-12);
    EXPECT_NEAR(inner.heading, box.heading, 1e-12);
    const OrientedBox same = withInsets(box, {}, Eigen::Vector2d::Zero());
    EXPECT_NEAR((same.centre() - box.centre()).norm(), 0.0, 1e-12);
    EXPECT_EQ(same.length, box.length);
}

FaceSet backAndLeft()
{
    FaceSet seen;
    seen.add(Face::Back);
    seen.add(Face::Left);
    return seen;
}

TEST(MisplacedFace, IsNoneOfACarsOwn)
{
    for (const double clutter : {0.0, 0.1})
    {
        const Hits hits = exampleHits(kCar, 200, 0.02, clutter, 4);
        EXPECT_FALSE(misplacedFace(hits, kCar, backAndLeft()));
    }
}

TEST(MisplacedFace, IsOneThatTheOtherRowNeverReaches)
{
    Hits hits = exampleHits(kCar, 200, 0.02, 0.0, 4);
    // A bush 1.5 m behind the car, taken for its back.
    OrientedBox longer = kCar;
    longer.length += 1.5;
    const Eigen::Vector2d centre = kCar.centre() - rotation(kCar.heading).col(0) * 0.75;
    longer.x = centre.x();
    longer.y = centre.y();
    const auto misplaced = misplacedFace(hits, longer, backAndLeft());
    ASSERT_TRUE(misplaced);
    EXPECT_EQ(*misplaced, Face::Back);
}

TEST(MisplacedFace, IsOneThatTheOtherRowGoesOnBeyond)
{
    const Hits hits = exampleHits(kCar, 200, 0.02, 0.0, 4);
    OrientedBox shorter = kCar;
    shorter.length -= 2.0;
    const Eigen::Vector2d centre = kCar.centre() + rotation(kCar.heading).col(0) * 1.0;
    shorter.x = centre.x();
    shorter.y = centre.y();
    const auto misplaced = misplacedFace(hits, shorter, backAndLeft());
    ASSERT_TRUE(misplaced);
    EXPECT_EQ(*misplaced, Face::Back);
    FaceSet side;
    side.add(Face::Left);
    EXPECT_FALSE(misplacedFace(hits, shorter, side));
}

}  // namespace
}  // namespace vdamf
