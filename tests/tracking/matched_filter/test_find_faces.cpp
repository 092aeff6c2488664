// SPDX-License-Identifier: BSD-3-Clause
// The second look at faces that hold too few of the hits, and what is said where little is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <utility>

#include "matched_filter/densest_corner.h"
#include "matched_filter/face_lines.h"
#include "tracking/matched_filter/example_hits.h"
#include "vdamf/tracking/matched_filter/covariance.h"
#include "vdamf/tracking/matched_filter/match_response.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
namespace
{
constexpr double kStep = 3.0 * kDegree;  // of the headings that the densest corner tries

void add(Hits& hits, const Eigen::Vector2d& at)
{
    hits.x.push_back(at.x());
    hits.y.push_back(at.y());
    hits.weight.push_back(1.0);
    hits.totalWeight += 1.0;
}

// With a bush as large as a face, 0.4 m beside the left side.
Hits besideABush(unsigned seed)
{
    Hits hits = exampleHits(kCar, 120, 0.03, 0.0, seed);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.5);
    for (int i = 0; i < 60; ++i)
        add(hits,
            kCar.centre() + rotation(kCar.heading) *
                                Eigen::Vector2d(uniform(generator), 1.3 + uniform(generator)));
    return hits;
}

TEST(DensestCorner, FindsTheFacesBesideABush)
{
    OrientedBox start = kCar;
    start.heading += 0.3;
    start.x += 0.5;
    const OrientedBox box = boxInDensestCorner(besideABush(1), start, kSensor);
    EXPECT_NEAR(box.heading, kCar.heading, kStep);
    EXPECT_LT((nearCorner(box) - nearCorner(kCar)).norm(), 0.15);
    EXPECT_EQ(box.length, start.length);
    EXPECT_EQ(box.width, start.width);
}

TEST(DensestCorner, TurnsTheWayOfTheStart)
{
    const Hits hits = exampleHits(kCar, 200, 0.02, 0.0, 2);
    OrientedBox backwards = kCar;
    backwards.heading = wrapAngle(kCar.heading + kPi + 0.2);
    const OrientedBox box = boxInDensestCorner(hits, backwards, kSensor);
    EXPECT_NEAR(wrapAngle(box.heading - kCar.heading - kPi), 0.0, kStep);
}

TEST(ShareOnNearFaces, IsOneOnTheFacesAndFallsOffThem)
{
    const Hits hits = exampleHits(kCar, 300, 0.0, 0.0, 3);
    EXPECT_GT(shareOnNearFaces(hits, kCar, kSensor, 0.06), 0.99);
    OrientedBox off = kCar;
    off.width += 0.4;
    off.length += 0.4;
    EXPECT_LT(shareOnNearFaces(hits, off, kSensor, 0.06), 0.3);
    EXPECT_EQ(shareOnNearFaces(Hits(), kCar, kSensor, 0.06), 0.0);
}

TEST(MeasureTarget, IsNotTurnedByABush)
{
    int good = 0;
    const int runs = 20;
    for (unsigned seed = 1; seed <= runs; ++seed)
    {
        std::mt19937 generator(seed);
        std::normal_distribution<double> gauss;
        OrientedBox start = kCar;
        start.x += 0.3 * gauss(generator);
        start.y += 0.3 * gauss(generator);
        start.heading += 0.14 * gauss(generator);
        MeasureOptions options;
        options.rangeNoise = 0.03;
        options.bodyDepth = 0.0;
        const Measurement m = measureTarget(besideABush(seed), kSensor, start, options);
        const bool onFaces = std::abs(wrapAngle(m.box.heading - kCar.heading)) < 2.0 * kDegree &&
                             (nearCorner(m.box) - nearCorner(kCar)).norm() < 0.1;
        good += onFaces ? 1 : 0;
    }
    EXPECT_GE(good, runs - 1);
}

TEST(ShareOnNearFaces, HasNoRoofOfACarOnItsSide)
{
    Hits hits;
    const Eigen::Matrix2d axes = rotation(kCar.heading);
    for (int i = 0; i < 20; ++i)
        add(hits, kCar.centre() + axes * Eigen::Vector2d(0.1 * i - 1.0, 0.5 * kCar.width));
    hits.height.assign(20, 0.8);
    std::fill_n(hits.height.begin(), 10, 1.45);
    EXPECT_NEAR(shareOnNearFaces(hits, kCar, kSensor, 0.06), 1.0, 1e-9) << "of anything";
    hits.heights = (1U << 8U) | (1U << 14U);
    EXPECT_NEAR(shareOnNearFaces(hits, kCar, kSensor, 0.06), 0.5, 1e-9) << "of a car";
    hits.heights |= std::uint64_t{1} << 25U;
    EXPECT_NEAR(shareOnNearFaces(hits, kCar, kSensor, 0.06), 1.0, 1e-9) << "of a truck";
}

// Of a car to the left: rows of hits along its bonnet and its roof, and few on its side.
Hits fromAbove(double roofHeight)
{
    Hits hits;
    const auto row = [&](int count, double x, double y, double height)
    {
        for (int i = 0; i < count; ++i)
        {
            add(hits, {x + 0.04 * i, y});
            hits.height.push_back(height);
        }
    };
    row(100, -1.6, 4.2, 0.9);
    row(20, -0.4, 3.6, roofHeight);
    row(20, -0.4, 3.0, 1.2);
    hits.heights = (1U << 9U) | (1U << 12U) | (1U << 14U);
    return hits;
}

TEST(MeasureTarget, DoubtsASideWithHitsBeforeIt)
{
    // Held for the row on its bonnet.
    const OrientedBox start{0.8, 5.1, 0.0, 4.5, 1.8};
    const SearchEffort first{0.0, true};
    const auto sigmaOfSide = [&](double roofHeight)
    {
        const Measurement m =
            measureTarget(fromAbove(roofHeight), kSensor, start, {}, std::nullopt, first);
        EXPECT_EQ(toString(m.facesSeen), "R") << roofHeight;
        EXPECT_NEAR(m.box.y - 0.5 * m.box.width, 4.2, 0.2) << roofHeight;
        Vector5d side = Vector5d::Zero();
        side(1) = 1.0;
        side(4) = -0.5;
        return std::sqrt(side.dot(m.covariance * side));
    };
    EXPECT_GT(sigmaOfSide(1.45), 0.4);
    EXPECT_LT(sigmaOfSide(1.3), 0.3) << "no roof";
}

OrientedBox disturbedCar(unsigned seed, double position, double heading)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> gauss;
    OrientedBox start = kCar;
    start.x += position * gauss(generator);
    start.y += position * gauss(generator);
    start.heading += heading * gauss(generator);
    return start;
}

TEST(MeasureTarget, LooksAgainOnlyWhereItMayAndHasTo)
{
    const SearchEffort first{0.0, true};
    int otherBesideABush = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        const OrientedBox start = disturbedCar(seed, 0.2, 0.1);
        const auto headings = [&](const Hits& hits)
        {
            return std::make_pair(
                measureTarget(hits, kSensor, start, {}).box.heading,
                measureTarget(hits, kSensor, start, {}, std::nullopt, first).box.heading);
        };
        const auto clear = headings(exampleHits(kCar, 120, 0.02, 0.0, seed));
        EXPECT_EQ(clear.first, clear.second) << "seed " << seed;
        const auto bush = headings(besideABush(seed));
        otherBesideABush += bush.first != bush.second ? 1 : 0;
    }
    EXPECT_GT(otherBesideABush, 0);
}

TEST(MeasureTarget, BeginsWhereTheHitsAreWhereTheStartIsNotEnough)
{
    const SearchEffort both{std::numeric_limits<double>::infinity(), false};
    int more = 0;
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        const Hits hits = exampleHits(kCar, 120, 0.02, 0.0, seed);
        const OrientedBox start = disturbedCar(seed, 0.8, 0.3);
        const Measurement one = measureTarget(hits, kSensor, start, {});
        const Measurement better = measureTarget(hits, kSensor, start, {}, std::nullopt, both);
        EXPECT_GE(better.match, one.match) << "seed " << seed;
        more += better.iterations > one.iterations ? 1 : 0;
    }
    EXPECT_GT(more, 0);
}

TEST(MeasureTarget, SaysSoWhereNoFaceIsSeen)
{
    Hits few;
    for (const double x : {14.0, 15.0, 16.0}) add(few, {x, 0.1 * (x - 15.0)});
    const Measurement m =
        measureTarget(few, kSensor, OrientedBox{15.0, 0.0, 0.0, 4.5, 1.8}, MeasureOptions());
    EXPECT_TRUE(m.facesSeen.empty());
    EXPECT_GT(m.covariance(0, 0), 0.4);
    EXPECT_GT(m.covariance(1, 1), 0.1);
    EXPECT_GT(m.covariance(2, 2), 0.05);
    EXPECT_GT(m.covariance(3, 3), 1.0);
    EXPECT_GT(m.covariance(4, 4), 0.3);
}

TEST(FitCovariance, HitsExactlyInARowDoNotTellTheSizeAcross)
{
    Hits row;
    for (int i = 0; i < 20; ++i) add(row, {10.0, 0.08 * (i - 9.5)});
    const OrientedBox box{12.25, 0.0, 0.0, 4.5, 1.8};
    const Matrix5d p =
        fitCovariance(row, FilterShape::paper(), box, bearingToSensor(box, kSensor), 0.05);
    EXPECT_GT(p.diagonal().minCoeff(), 0.0);
    EXPECT_GT(p(3, 3), 0.3);
}

TEST(FaceLines, ABodySeenInARowMayReachFarther)
{
    FaceSet seen;
    seen.add(Face::Back);
    seen.add(Face::Left);
    Hits hits = exampleHits(kCar, 200, 0.02, 0.0, 4);
    FaceLineOptions options;
    options.bodyDepth = 0.1;
    const auto whole = fitFaceLines(hits, kCar, seen, kSensor, options);
    hits.heights = 1U << 8U;
    const auto row = fitFaceLines(hits, kCar, seen, kSensor, options);
    ASSERT_TRUE(whole && row);
    EXPECT_LT(row->end.at, whole->end.at - 0.03);  // the back is at the negative end
    EXPECT_GT(row->side.at, whole->side.at);
    EXPECT_GT(row->covariance(1, 1), whole->covariance(1, 1) + 0.003);
    const FaceLines raw = throughHits(*row);
    EXPECT_NEAR(raw.end.at, throughHits(*whole).end.at, 1e-9);
    EXPECT_NEAR(raw.end.at, -2.25, 0.02);
}

TEST(Hits, ManyCellsAreAllFound)
{
    std::mt19937 generator(7);
    std::uniform_real_distribution<float> uniform(-10.0F, 10.0F);
    Cluster cluster;
    std::set<std::pair<int, int>> cells;
    for (int i = 0; i < 5000; ++i)
    {
        cluster.x.push_back(uniform(generator));
        cluster.y.push_back(uniform(generator));
        cells.emplace(static_cast<int>(std::floor(cluster.x.back() * 2.0)),
                      static_cast<int>(std::floor(cluster.y.back() * 2.0)));
    }
    const Hits hits = projectHits(cluster, 0.5);
    EXPECT_EQ(hits.size(), cells.size());
    EXPECT_EQ(hits.totalWeight, 5000.0);
}

TEST(WidestEnd, TrucksAreWider)
{
    EXPECT_LT(widestEnd(1.5), widestEnd(3.0));
    EXPECT_GT(widestEnd(1.5), 1.95);  // no car's end is taken for a side
}

}  // namespace
}  // namespace vdamf
