// SPDX-License-Identifier: BSD-3-Clause
// The canonical frame of section 5 and what the classifier sees of an object in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "vdamf/tracking/discrimination/classify.h"
#include "vdamf/tracking/discrimination/features.h"

namespace vdamf
{
namespace
{
// Hits on rear and left side of a car, box frame: x to the front, y to the left.
Cluster carHits()
{
    Cluster c;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(0.0F, 1.0F);
    for (int i = 0; i < 400; ++i)
    {
        const bool onSide = i % 3 != 0;
        c.x.push_back(onSide ? -2.2F + 4.4F * any(random) : -2.2F);
        c.y.push_back(onSide ? 0.9F : -0.9F + 1.8F * any(random));
        c.height.push_back(0.25F + 1.2F * any(random));
        c.z.push_back(c.height.back() - 1.7F);
    }
    return c;
}

struct SeenCar
{
    Cluster cluster;
    ObjectView view;
};

// The car's box at a pose, the sensor at a place of the box frame, all turned and moved together.
// `mirrored`: seen in a mirror along the box's axis.
SeenCar sceneAt(double x, double y, double heading, const Eigen::Vector2d& sensorInBox,
                bool mirrored = false)
{
    SeenCar s;
    s.cluster = carHits();
    const double sign = mirrored ? -1.0 : 1.0;
    const Eigen::Matrix2d r = rotation(heading);
    for (std::size_t i = 0; i < s.cluster.size(); ++i)
    {
        const Eigen::Vector2d at =
            r * Eigen::Vector2d(s.cluster.x[i], sign * s.cluster.y[i]) + Eigen::Vector2d(x, y);
        s.cluster.x[i] = static_cast<float>(at.x());
        s.cluster.y[i] = static_cast<float>(at.y());
    }
    s.view.box = {x, y, heading, 4.4, 1.8};
    s.view.sensor =
        r * Eigen::Vector2d(sensorInBox.x(), sign * sensorInBox.y()) + Eigen::Vector2d(x, y);
    s.view.match = 0.7;
    s.view.frameHits = 60000;
    return s;
}

const Eigen::Vector2d kBehindLeft(-14.0, 8.0);

// With the faces in the middle of cells, so that rounding moves no hit to another one.
std::vector<float> featuresOf(SeenCar& scene)
{
    DiscriminationGrid grid;
    grid.x = {-0.25, 6.75, 14};
    grid.y = {-0.25, 3.25, 7};
    scene.view.clusters = {&scene.cluster};
    return objectFeatures(scene.view, grid);
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
    return largest;
}

TEST(CanonicalFrame, HasTheClosestCornerAsOriginAndTheFacesAlongTheAxes)
{
    SeenCar scene = sceneAt(10.0, -5.0, 0.7, kBehindLeft);
    scene.view.clusters = {&scene.cluster};
    const CanonicalHits hits = toCanonicalFrame(scene.view);
    ASSERT_EQ(hits.size(), 400U);
    const Cluster box = carHits();
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        EXPECT_NEAR(hits.x[i], box.x[i] + 2.2F, 1e-5);
        EXPECT_NEAR(hits.y[i], 0.9F - box.y[i], 1e-5);
        EXPECT_EQ(hits.z[i], box.height[i]);
    }
    EXPECT_NEAR(hits.sensor.x(), -11.8, 1e-9);
    EXPECT_NEAR(hits.sensor.y(), -7.1, 1e-9);
}

TEST(CanonicalFrame, ThinsEvenlyAcrossClusters)
{
    SeenCar scene = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    const Cluster second = scene.cluster;
    scene.view.clusters = {&scene.cluster, &second};
    const CanonicalHits hits = toCanonicalFrame(scene.view, 160);
    EXPECT_EQ(hits.count, 800U);
    EXPECT_EQ(hits.size(), 160U);
    EXPECT_EQ(hits.z[1], scene.cluster.height[5]);
    EXPECT_EQ(hits.z[81], second.height[5]);
}

TEST(CanonicalFrame, TakesHitsOfAllRingsThatComeByTurns)
{
    SeenCar scene = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    for (std::size_t i = 0; i < scene.cluster.size(); ++i)
        scene.cluster.height[i] = static_cast<float>(i % 4);
    scene.view.clusters = {&scene.cluster};
    for (const std::size_t most : {200U, 100U, 50U})
    {
        const CanonicalHits hits = toCanonicalFrame(scene.view, most);
        ASSERT_LE(hits.size(), most);
        for (const float ring : {0.0F, 1.0F, 2.0F, 3.0F})
            EXPECT_NEAR(static_cast<double>(std::count(hits.z.begin(), hits.z.end(), ring)),
                        0.25 * static_cast<double>(hits.size()), 1.0);
    }
}

TEST(CanonicalFrame, DropsHitsThatAreNotFinite)
{
    SeenCar scene = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    scene.cluster.x[3] = std::numeric_limits<float>::quiet_NaN();
    scene.cluster.height[4] = std::numeric_limits<float>::infinity();
    scene.view.clusters = {&scene.cluster};
    EXPECT_EQ(toCanonicalFrame(scene.view).size(), 398U);
}

TEST(Features, DoNotDependOnPoseMirrorOrWhichEndIsTheFront)
{
    SeenCar here = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    const std::vector<float> expected = featuresOf(here);
    SeenCar there = sceneAt(35.0, -20.0, 2.1, kBehindLeft);
    SeenCar mirrored = sceneAt(35.0, -20.0, -1.1, kBehindLeft, true);
    SeenCar turned = sceneAt(3.0, 4.0, 0.4, kBehindLeft);
    turned.view.box.heading += kPi;
    // Hits on the border of two cells may change theirs by rounding.
    EXPECT_LT(largestDifference(featuresOf(there), expected), 0.04);
    EXPECT_LT(largestDifference(featuresOf(mirrored), expected), 0.04);
    EXPECT_LT(largestDifference(featuresOf(turned), expected), 0.04);
}

TEST(Features, OfCellsAreTheRootOfTheSharesOfTheHits)
{
    SeenCar scene = sceneAt(1.0, 2.0, 0.3, kBehindLeft);
    const std::vector<float> features = featuresOf(scene);
    const FeatureBlock cells = featureBlocks(DiscriminationGrid{}).front();
    double sum = 0.0;
    for (std::size_t i = 0; i < cells.size; ++i) sum += features[i] * features[i];
    EXPECT_NEAR(sum, 1.0, 1e-4);
}

TEST(Features, OfPairsOfDescriptorsShareTheSameBetweenTheirKnots)
{
    SeenCar scene = sceneAt(1.0, 2.0, 0.3, kBehindLeft);
    const std::vector<float> features = featuresOf(scene);
    const std::vector<FeatureBlock> blocks = featureBlocks(DiscriminationGrid{});
    std::size_t next = 0;
    for (const FeatureBlock& block : blocks)
    {
        EXPECT_EQ(block.first, next) << block.name;
        next += block.size;
        if (block.name == "cells") continue;
        double sum = 0.0;
        for (std::size_t i = 0; i < block.size; ++i)
        {
            EXPECT_GE(features[block.first + i], 0.0F);
            sum += static_cast<double>(features[block.first + i]);
        }
        const bool isOfPlanarScans = block.name.rfind("flat_", 0) == 0;
        EXPECT_NEAR(sum, isOfPlanarScans ? 0.0 : 0.5, 1e-5) << block.name;
    }
    EXPECT_EQ(next, features.size());
    EXPECT_EQ(next, featureCount(DiscriminationGrid{}));
}

TEST(Features, OfPlanarScansKnowNoHeights)
{
    SeenCar scene = sceneAt(1.0, 2.0, 0.3, kBehindLeft);
    scene.view.planar = true;
    const std::vector<float> features = featuresOf(scene);
    std::fill(scene.cluster.height.begin(), scene.cluster.height.end(), 0.6F);
    EXPECT_EQ(featuresOf(scene), features);
    for (const FeatureBlock& block : featureBlocks(DiscriminationGrid{}))
    {
        const float* const first = features.data() + block.first;
        const bool isUsed =
            std::any_of(first, first + block.size, [](float f) { return f > 0.0F; });
        EXPECT_EQ(isUsed, block.name.rfind("flat_", 0) == 0) << block.name;
    }
}

TEST(Features, TellHowHighMostHitsLieApartFromTheHighestOne)
{
    SeenCar car = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    for (std::size_t i = 0; i < car.cluster.size(); i += 12) car.cluster.height[i] = 1.44F;
    SeenCar hedge = car;
    for (std::size_t i = 0; i < hedge.cluster.size(); ++i)
        if (i % 12 != 0) hedge.cluster.height[i] *= 0.4F;
    const std::vector<float> a = featuresOf(car);
    const std::vector<float> b = featuresOf(hedge);
    const auto differenceOf = [&](const std::string& name)
    {
        for (const FeatureBlock& block : featureBlocks(DiscriminationGrid{}))
        {
            if (block.name != name) continue;
            double sum = 0.0;
            for (std::size_t i = 0; i < block.size; ++i)
                sum += std::abs(static_cast<double>(a[block.first + i] - b[block.first + i]));
            return sum;
        }
        ADD_FAILURE() << "no block " << name;
        return 0.0;
    };
    EXPECT_LT(differenceOf("length_top"), 0.2);
    EXPECT_GT(differenceOf("length_shoulder"), 0.4);
    EXPECT_GT(differenceOf("length_middle"), 0.4);
}

TEST(Features, OfFewerHitsOfTheSameSurfaceAreAlike)
{
    SeenCar dense = sceneAt(0.0, 0.0, 0.0, kBehindLeft);
    SeenCar sparse = dense;
    const auto keepThird = [](std::vector<float>& v)
    {
        // As many of the side and of the end as there were.
        for (std::size_t i = 0; 3 * i + 2 < v.size(); ++i) v[i] = v[3 * i + (i % 3)];
        v.resize(v.size() / 3);
    };
    for (auto* v :
         {&sparse.cluster.x, &sparse.cluster.y, &sparse.cluster.z, &sparse.cluster.height})
        keepThird(*v);
    sparse.view.frameHits /= 3;
    const std::vector<float> a = featuresOf(sparse);
    const std::vector<float> b = featuresOf(dense);
    const auto product = [](const std::vector<float>& u, const std::vector<float>& v)
    { return std::inner_product(u.begin(), u.end(), v.begin(), 0.0); };
    EXPECT_GT(product(a, b) / std::sqrt(product(a, a) * product(b, b)), 0.88);
}

TEST(Features, OfNothingAreZero)
{
    ObjectView view;
    const std::vector<float> features = objectFeatures(view, DiscriminationGrid{});
    EXPECT_EQ(features, std::vector<float>(featureCount(DiscriminationGrid{}), 0.0F));
}

TEST(Features, StayWithinZeroAndOneForOddViews)
{
    Cluster one;
    one.x = one.y = one.z = one.height = {2.0F};
    for (const Eigen::Vector2d& sensor : {Eigen::Vector2d(2.0, 2.0), Eigen::Vector2d(0.0, 0.0)})
    {
        ObjectView view;
        view.box = {2.0, 2.0, 0.0, 1.0, 1.0};
        view.sensor = sensor;
        view.clusters = {&one};
        view.match = std::numeric_limits<double>::quiet_NaN();
        for (const float f : objectFeatures(view, DiscriminationGrid{}))
        {
            EXPECT_TRUE(f >= 0.0F && f <= 1.0F) << f;
        }
    }
}

TEST(ObjectScore, IsThatOfTheFeatures)
{
    SeenCar scene = sceneAt(10.0, 5.0, 0.4, kBehindLeft);
    scene.view.clusters = {&scene.cluster};
    const DiscriminatorModel& model = defaultDiscriminatorModel();
    for (const bool planar : {false, true})
    {
        scene.view.planar = planar;
        EXPECT_NEAR(objectScore(scene.view, model),
                    vehicleScore(model, objectFeatures(scene.view, model.grid)), 1e-6);
    }
    scene.view.clusters.clear();
    EXPECT_EQ(objectScore(scene.view, model), model.bias);
}
}  // namespace
}  // namespace vdamf
