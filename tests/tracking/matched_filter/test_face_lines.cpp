// SPDX-License-Identifier: BSD-3-Clause
// The step from the matched filter's box to the faces of the vehicle.
#include "matched_filter/face_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tracking/decompositions.h"
#include "tracking/matched_filter/example_hits.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
namespace
{
FaceSet setOf(std::initializer_list<Face> faces)
{
    FaceSet set;
    for (const Face face : faces) set.add(face);
    return set;
}

const FaceSet kSeen = setOf({Face::Back, Face::Left});

TEST(FaceLines, FindExactFacesFromATurnedAndShiftedBox)
{
    const Hits hits = exampleHits(kCar, 300, 0.0, 0.0, 1);
    OrientedBox start = kCar;
    start.heading += 0.03;
    start.x += 0.1;
    start.y -= 0.05;
    FaceLineOptions options;
    options.rangeNoise = 1e-4;
    options.iterations = 30;
    const auto lines = fitFaceLines(hits, start, kSeen, kSensor, options);
    ASSERT_TRUE(lines && lines->end.exists && lines->side.exists);
    const OrientedBox box = onFaceLines(start, *lines);
    EXPECT_NEAR(box.heading, kCar.heading, 1e-3);
    // The turn is linear: 0.03 rad leave 0.03^2 / 2 of the car's half length, a millimetre.
    EXPECT_LT((nearCorner(box) - nearCorner(kCar)).norm(), 3e-3);
}

TEST(FaceLines, AFaceWithoutHitsHasNoLine)
{
    const OrientedBox rear{15.0, 0.0, 0.0, 4.5, 1.8};
    const Hits hits = exampleHits(rear, 100, 0.02, 0.0, 2);
    const auto end = fitFaceLines(hits, rear, setOf({Face::Back}), kSensor, {});
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->end.exists);
    EXPECT_FALSE(end->side.exists);
    EXPECT_EQ(end->covariance(2, 2), 0.0);
    EXPECT_NEAR(end->end.at, -2.25, 0.01);
    EXPECT_FALSE(fitFaceLines(hits, rear, setOf({}), kSensor, {}));
    EXPECT_FALSE(fitFaceLines(Hits(), rear, setOf({Face::Back}), kSensor, {}));
}

TEST(FaceLines, ClutterBehindTheFacesHardlyMovesThem)
{
    const Hits clean = exampleHits(kCar, 300, 0.02, 0.0, 3);
    const Hits cluttered = exampleHits(kCar, 300, 0.02, 0.15, 3);
    const auto a = fitFaceLines(clean, kCar, kSeen, kSensor, {});
    const auto b = fitFaceLines(cluttered, kCar, kSeen, kSensor, {});
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(a->end.at, b->end.at, 0.01);
    EXPECT_NEAR(a->side.at, b->side.at, 0.01);
    EXPECT_NEAR(a->turn, b->turn, 0.2 * kPi / 180.0);
}

// Hits of a side that is tapered: they lie up to `depth` inside of the hull.
Hits taperedSide(double depth, unsigned seed)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Hits hits;
    for (int i = 0; i < 300; ++i)
    {
        const double u = uniform(generator);
        hits.x.push_back(10.0 + 4.0 * (uniform(generator) - 0.5));
        hits.y.push_back(10.0 - 0.9 + depth * u * u);
        hits.weight.push_back(1.0);
        hits.totalWeight += 1.0;
    }
    return hits;
}

TEST(FaceLines, GoToTheHullOfATaperedBody)
{
    const OrientedBox box{10.0, 10.0, 0.0, 4.5, 1.8};
    const FaceSet side = setOf({Face::Right});
    const Eigen::Vector2d sensor(10.0, 0.0);
    for (const double depth : {0.1, 0.2, 0.3})
    {
        FaceLineOptions options;
        options.rangeNoise = 0.005;
        const auto lines = fitFaceLines(taperedSide(depth, 4), box, side, sensor, options);
        ASSERT_TRUE(lines);
        EXPECT_NEAR(lines->side.at, -0.9, 0.15 * depth) << depth;
        EXPECT_GT(lines->side.shape, 0.0);
        EXPECT_GT(lines->covariance(2, 2), 1e-5);  // less sure than on a plane
    }
}

TEST(FaceLines, MergedHitsTellTheSame)
{
    Cluster cluster;
    const Hits single = exampleHits(kCar, 600, 0.03, 0.0, 5);
    for (std::size_t i = 0; i < single.size(); ++i)
    {
        cluster.x.push_back(static_cast<float>(single.x[i]));
        cluster.y.push_back(static_cast<float>(single.y[i]));
    }
    FaceLineOptions options;
    options.rangeNoise = 0.03;
    const auto each = fitFaceLines(projectHits(cluster, 0.0), kCar, kSeen, kSensor, options);
    const auto merged = fitFaceLines(projectHits(cluster, 0.1), kCar, kSeen, kSensor, options);
    ASSERT_TRUE(each && merged);
    EXPECT_NEAR(each->end.at, merged->end.at, 0.01);
    EXPECT_NEAR(each->side.at, merged->side.at, 0.01);
    EXPECT_NEAR(std::sqrt(merged->covariance(1, 1) / each->covariance(1, 1)), 1.0, 0.25);
}

TEST(MeasureTarget, FaceLinesHaveNoBias)
{
    Eigen::Vector2d corner = Eigen::Vector2d::Zero();
    double length = 0.0;
    double width = 0.0;
    const int runs = 40;
    for (unsigned seed = 1; seed <= runs; ++seed)
    {
        const Hits hits = exampleHits(kCar, 200, 0.02, 0.05, seed);
        MeasureOptions options;
        options.bodyDepth = 0.0;  // upright walls
        const Measurement m = measureTarget(hits, kSensor, disturbed(kCar, seed), options);
        corner += (nearCorner(m.box) - nearCorner(kCar)) / runs;
        length += (m.box.length - kCar.length) / runs;
        width += (m.box.width - kCar.width) / runs;
    }
    EXPECT_LT(corner.norm(), 0.01);
    EXPECT_NEAR(length, 0.0, 0.05);
    EXPECT_NEAR(width, 0.0, 0.05);
}

// The covariance of heading and near faces against the errors of many scans.
TEST(MeasureTarget, FaceLinesKnowHowGoodTheyAre)
{
    double nees = 0.0;
    int inside95 = 0;
    const int runs = 300;
    for (unsigned seed = 1; seed <= runs; ++seed)
    {
        MeasureOptions options;
        options.rangeNoise = 0.03;
        options.bodyDepth = 0.0;  // upright walls
        const Hits hits = exampleHits(kCar, 120, 0.03, 0.0, 1000 + seed);
        const Measurement m = measureTarget(hits, kSensor, disturbed(kCar, seed), options);
        Vector5d error;
        error << m.box.x - kCar.x, m.box.y - kCar.y, wrapAngle(m.box.heading - kCar.heading),
            m.box.length - kCar.length, m.box.width - kCar.width;
        // From pose and size to the back, the left side and the heading.
        Eigen::Matrix<double, 3, 5> faces = Eigen::Matrix<double, 3, 5>::Zero();
        faces.topLeftCorner<2, 2>() = rotation(-kCar.heading);
        faces(0, 3) = -0.5;
        faces(1, 4) = 0.5;
        faces(2, 2) = 1.0;
        const Eigen::Vector3d e = faces * error;
        const Eigen::Matrix3d p = faces * m.covariance * faces.transpose();
        const double one = squaredMahalanobis(e, p);
        nees += one / (3.0 * runs);
        inside95 += one < 7.815 ? 1 : 0;
    }
    EXPECT_GT(nees, 0.5);
    EXPECT_LT(nees, 1.3);
    EXPECT_GT(inside95, 0.9 * runs);
}

TEST(MeasureTarget, AnUnseenLengthIsUnknown)
{
    const OrientedBox rear{15.0, 0.0, 0.0, 4.5, 1.8};
    const Hits hits = exampleHits(rear, 100, 0.02, 0.0, 2);
    const Measurement m =
        measureTarget(hits, kSensor, rear, MeasureOptions(), Eigen::Vector2d(4.5, 1.8));
    EXPECT_EQ(toString(m.facesSeen), "B");
    EXPECT_GT(m.covariance(3, 3), 0.5);
    EXPECT_LT(m.covariance(4, 4), 0.02);
    // The back itself is known all the same.
    Vector5d back = Vector5d::Zero();
    back(0) = 1.0;
    back(3) = -0.5;
    EXPECT_LT(back.dot(m.covariance * back), 1e-3);
}

// Hits of kCar, in its own axes.
class HitsOnCar
{
public:
    void addRow(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height, int count)
    {
        for (int k = 0; k < count; ++k)
        {
            const Eigen::Vector2d place =
                kCar.centre() + rotation(kCar.heading) * (from + (k + 0.5) / count * (to - from));
            hits_.x.push_back(static_cast<float>(place.x()));
            hits_.y.push_back(static_cast<float>(place.y()));
            hits_.height.push_back(static_cast<float>(height));
        }
    }

    Hits projected() const { return projectHits(hits_, 0.0); }

private:
    Cluster hits_;
};

// Of a car behind a lower one: its rear, its side as far as its wheel, and its windows.
HitsOnCar behindALowerOne()
{
    HitsOnCar car;
    for (const double height : {0.5, 0.7}) car.addRow({-2.25, -0.9}, {-2.25, 0.9}, height, 12);
    for (const double height : {0.5, 0.7}) car.addRow({-2.25, 0.9}, {-1.4, 0.9}, height, 10);
    return car;
}

double turnOf(const Hits& hits)
{
    const auto lines = fitFaceLines(hits, kCar, kSeen, kSensor, {});
    EXPECT_TRUE(lines && lines->end.exists && lines->side.exists);
    return lines ? lines->turn : 1.0;
}

TEST(FaceLines, WindowsThatLieFartherInsideDoNotTurnTheSideOfACar)
{
    HitsOnCar car = behindALowerOne();
    car.addRow({-1.0, 0.7}, {1.5, 0.7}, 1.2, 25);
    Hits hits = car.projected();
    EXPECT_NEAR(turnOf(hits), 0.0, 0.5 * kDegree);
    hits.height.clear();
    EXPECT_GT(std::abs(turnOf(hits)), 2.0 * kDegree) << "of hits without heights they would";
}

TEST(FaceLines, WindowsAloneShowWhereTheSideLeads)
{
    HitsOnCar car;
    car.addRow({-2.25, -0.9}, {-2.25, 0.9}, 0.6, 12);
    car.addRow({-2.1, 0.9}, {-1.9, 0.9}, 0.6, 2);
    car.addRow({-1.9, 0.9}, {1.5, 0.9}, 1.2, 35);
    EXPECT_NEAR(turnOf(car.projected()), 0.0, 0.5 * kDegree);
}

TEST(FaceLines, TheRoofIsNoSide)
{
    HitsOnCar car = behindALowerOne();
    const double without = turnOf(car.projected());
    car.addRow({0.0, 0.65}, {1.0, 0.55}, 1.45, 12);
    EXPECT_NEAR(turnOf(car.projected()), without, 1e-9);
}

TEST(Hits, MergedCentresKnowTheirScatter)
{
    Cluster cluster;
    cluster.x = {10.01F, 10.03F, 10.05F, 20.0F};
    cluster.y = {5.02F, 5.04F, 5.06F, 7.0F};
    const Hits hits = projectHits(cluster, 0.1);
    ASSERT_EQ(hits.size(), 2U);
    const std::size_t merged = hits.weight[0] > 1.0 ? 0 : 1;
    const double expected = 0.04 * 0.04 / 6.0;  // of -d, 0, d with d = 0.02
    EXPECT_NEAR(hits.varianceAlong(merged, 1.0, 0.0), expected, 1e-6);
    EXPECT_NEAR(hits.varianceAlong(merged, 0.0, 1.0), expected, 1e-6);
    EXPECT_NEAR(hits.varianceAlong(merged, std::sqrt(0.5), -std::sqrt(0.5)), 0.0, 1e-6);
    EXPECT_NEAR(hits.varianceAlong(1 - merged, 1.0, 0.0), 0.0, 1e-9);
    Hits single;
    single.x = single.y = single.weight = {1.0};
    single.totalWeight = 1.0;
    const Hits both = joined(single, hits);
    EXPECT_EQ(both.varianceAlong(0, 1.0, 0.0), 0.0);
    EXPECT_NEAR(both.varianceAlong(1 + merged, 1.0, 0.0), expected, 1e-6);
}

}  // namespace
}  // namespace vdamf
