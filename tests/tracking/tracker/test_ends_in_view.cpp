// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/ends_in_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vdamf/tracking/estimation/visibility.h"
#include "vdamf/tracking/preprocessing/range_profile.h"

namespace vdamf
{
namespace
{
// Upright, across the y axis; m.
struct UprightPanel
{
    double y, fromX, toX, fromZ, toZ;
};

constexpr double kScannerHeight = 1.9;  // m
const UprightPanel kBusSide{20.0, -6.0, 6.0, 0.4, 3.2};

// A frame of a spinning LADAR: hits on the first of the panels are the target's, whose right side
// it is and whose box is as long as they reach.
struct SceneOfPanels
{
    SegmentedFrame frame;
    Sighting sighting;

    explicit SceneOfPanels(const std::vector<UprightPanel>& panels)
    {
        LadarFrame scan;
        scan.sensor.z() = kScannerHeight;
        AboveGround above;
        Cluster target;
        const auto cast = [&](double tangent, double slope)
        {
            const UprightPanel* hit = nullptr;
            for (const UprightPanel& p : panels)
            {
                const double z = kScannerHeight + slope * p.y * std::hypot(1.0, tangent);
                const double x = p.y * tangent;
                const bool meets = x >= p.fromX && x <= p.toX && z >= p.fromZ && z <= p.toZ;
                if (meets && (hit == nullptr || p.y < hit->y)) hit = &p;
            }
            if (hit == nullptr) return;
            const auto x = static_cast<float>(hit->y * tangent);
            const auto y = static_cast<float>(hit->y);
            const auto z =
                static_cast<float>(kScannerHeight + slope * hit->y * std::hypot(1.0, tangent));
            above.index.push_back(static_cast<std::uint32_t>(scan.points.size()));
            above.height.push_back(z);
            scan.points.x.push_back(x);
            scan.points.y.push_back(y);
            scan.points.z.push_back(z);
            if (hit != &panels.front()) return;
            target.x.push_back(x);
            target.y.push_back(y);
            target.z.push_back(z);
            target.height.push_back(z);
        };
        for (double slope = -0.3; slope < 0.2; slope += 0.0232)
            for (double tangent = -1.0; tangent < 1.0; tangent += 0.004) cast(tangent, slope);
        const auto [first, last] = std::minmax_element(target.x.begin(), target.x.end());
        frame.sensorZ = kScannerHeight;
        frame.profile = rangeProfile(scan, above);
        frame.clusters.push_back(target);
        sighting.clusters = {0};
        sighting.height = heightOf(target);
        sighting.measurement.box = {0.5 * (*first + *last), 21.25, 0.0,
                                    static_cast<double>(*last - *first), 2.5};
        sighting.measurement.facesSeen.add(Face::Right);
        sighting.measurement.covariance.setIdentity();
    }

    Measurement measured() const { return withEndsOutOfView(sighting, frame); }
};

double varianceOfFront(const Measurement& m)
{
    return m.covariance(0, 0) + m.covariance(0, 3) + 0.25 * m.covariance(3, 3);
}

TEST(EndsInView, ABusIsSeenOverCarsThatQueueBeforeIt)
{
    const SceneOfPanels scene({kBusSide, {10.0, -9.0, 9.0, 0.2, 1.5}});
    const Measurement m = scene.measured();
    EXPECT_EQ(toString(m.hiddenEnds), "");
    EXPECT_EQ(toString(m.upperEnds), "");
    EXPECT_EQ(m.covariance, scene.sighting.measurement.covariance);
}

TEST(EndsInView, ACarIsNot)
{
    const SceneOfPanels scene({{20.0, -2.2, 2.2, 0.4, 1.7}, {10.0, -9.0, 9.0, 0.2, 1.2}});
    EXPECT_EQ(toString(scene.measured().hiddenEnds), "FB") << "its roof ends before its bonnet";
}

TEST(EndsInView, WindowsEndBeforeTheirCar)
{
    SceneOfPanels windows({{20.0, -1.5, 1.5, 1.05, 1.5}});
    EXPECT_EQ(toString(windows.measured().hiddenEnds), "FB");
    Cluster& hits = windows.frame.clusters.front();
    const auto atFront =
        static_cast<std::size_t>(std::max_element(hits.x.begin(), hits.x.end()) - hits.x.begin());
    hits.height[atFront] = 0.8F;
    EXPECT_EQ(toString(windows.measured().hiddenEnds), "B") << "its body shows at the front";
    windows.frame.planar = true;
    EXPECT_EQ(toString(windows.measured().hiddenEnds), "") << "heights are not known";
    const SceneOfPanels van({{20.0, -2.7, 2.7, 1.05, 2.1}});
    EXPECT_EQ(toString(van.measured().hiddenEnds), "FB") << "a bonnet may go on there";
    const SceneOfPanels truck({{20.0, -2.7, 2.7, 1.05, 2.4}});
    EXPECT_EQ(toString(truck.measured().hiddenEnds), "");
}

TEST(EndsInView, AVanIsToAMetre)
{
    const SceneOfPanels scene({{20.0, -2.7, 2.7, 0.4, 2.1}, {10.0, -9.0, 9.0, 0.2, 1.2}});
    const Measurement m = scene.measured();
    EXPECT_EQ(toString(m.hiddenEnds), "");
    EXPECT_EQ(toString(m.upperEnds), "FB") << "its windscreen may recede";
    EXPECT_NEAR(varianceOfFront(m), varianceOfFront(scene.sighting.measurement) + 1.0, 1e-9);
}

TEST(EndsInView, WhatIsHigherThanItHidesAnEnd)
{
    const SceneOfPanels scene({kBusSide, {10.0, -9.0, 1.5, 0.2, 1.5}, {10.0, 1.5, 9.0, 0.2, 4.0}});
    const Measurement m = scene.measured();
    EXPECT_NEAR(m.box.x + 0.5 * m.box.length, 3.0, 0.1);
    EXPECT_EQ(toString(m.hiddenEnds), "F");
    EXPECT_EQ(toString(m.upperEnds), "");
}

TEST(EndsInView, EndsOverVansMayBeThoseOfALoad)
{
    const SceneOfPanels scene({kBusSide, {10.0, -9.0, 9.0, 0.2, 2.2}});
    const Measurement m = scene.measured();
    EXPECT_EQ(toString(m.hiddenEnds), "");
    EXPECT_EQ(toString(m.upperEnds), "FB");
    EXPECT_NEAR(varianceOfFront(m), varianceOfFront(scene.sighting.measurement) + 1.0, 1e-9);
}

TEST(EndsInView, ACabGoesOnBeforeALoad)
{
    const UprightPanel load{20.0, -6.0, 3.5, 0.4, 3.2};
    const UprightPanel cab{20.0, 3.5, 6.0, 0.4, 2.5};
    const UprightPanel cars{10.0, -9.0, 9.0, 0.2, 1.5};
    const UprightPanel vans{10.0, -9.0, 9.0, 0.2, 2.2};
    const Measurement overCars = SceneOfPanels({load, cab, cars}).measured();
    EXPECT_EQ(toString(overCars.hiddenEnds), "F");
    EXPECT_EQ(toString(overCars.upperEnds), "");
    const Measurement overVans = SceneOfPanels({load, cab, vans}).measured();
    EXPECT_EQ(toString(overVans.hiddenEnds), "");
    EXPECT_EQ(toString(overVans.upperEnds), "FB") << "the cab is not seen";
}

TEST(EndsInView, UpperEndsDoNotShortenWhatIsForetold)
{
    Measurement m;
    m.box = {0.0, 0.0, 0.0, 9.5, 2.5};
    m.upperEnds.add(Face::Front);
    m.upperEnds.add(Face::Back);
    EXPECT_EQ(toString(withoutShortUpperEnds(m, {1.0, 0.0, 0.05, 12.0, 2.5}).hiddenEnds), "F");
    EXPECT_EQ(toString(withoutShortUpperEnds(m, {0.0, 0.0, 0.0, 10.5, 2.5}).hiddenEnds), "");
    m.upperEnds = FaceSet();
    EXPECT_EQ(toString(withoutShortUpperEnds(m, {1.0, 0.0, 0.0, 12.0, 2.5}).hiddenEnds), "");
}

TEST(EndsInView, AWindscreenIsNoEndOfAVan)
{
    constexpr double kVan = 2.0;  // m
    Measurement m;
    m.box = {0.0, 0.0, 0.0, 4.0, 2.0};
    m.facesSeen.add(Face::Left);
    m.upperEnds.add(Face::Front);
    const auto hidden = [&](double height, double forwardProbability, FaceSet known = {})
    { return toString(withoutUpperFront(m, height, forwardProbability, known).hiddenEnds); };
    EXPECT_EQ(hidden(kVan, 0.99), "F");
    EXPECT_EQ(hidden(kVan, 0.5), "F");
    EXPECT_EQ(hidden(3.0, 0.99), "") << "of a truck";
    m.hiddenEnds.add(Face::Back);
    EXPECT_EQ(hidden(kVan, 0.99), "B") << "nothing else tells where it is";
    FaceSet known;
    known.add(Face::Back);
    EXPECT_EQ(hidden(kVan, 0.99, known), "FB") << "it is known from before";
}

TEST(EndsInView, TheRearOfAVanIsUpright)
{
    Measurement m;
    m.box = {0.0, 0.0, 0.0, 5.2, 2.0};
    m.facesSeen.add(Face::Left);
    m.upperEnds.add(Face::Back);
    EXPECT_EQ(toString(withoutUpperFront(m, 2.0, 0.99).hiddenEnds), "");
    EXPECT_EQ(toString(withoutUpperFront(m, 2.0, 0.5).hiddenEnds), "B") << "it may be the front";
}

TEST(EndsInView, UpperEndsTurnWithTheBox)
{
    Measurement m;
    m.upperEnds.add(Face::Front);
    m.upperEnds.add(Face::Left);
    m.shadowEdges.add(Face::Left);
    EXPECT_EQ(toString(turnedBy(m, 2).upperEnds), "BR");
    EXPECT_EQ(toString(turnedBy(m, 1).shadowEdges), "F");
}

// A car drives behind another one, which hides its left half.
TEST(EndsInView, EdgesOfShadowsInsideOfWhatIsForetoldAreNoFaces)
{
    VehicleState car;
    car.mean << 0.0, 0.0, 0.0, 8.0, 0.0, 0.0, 4.5;
    car.width = 1.8;
    car.covariance.diagonal().setConstant(1e-3);
    car.widthVariance = 1e-3;
    Measurement m;
    m.box = {0.0, -0.3, 0.0, 4.5, 1.2};
    m.covariance.diagonal().setConstant(1e-3);
    m.facesSeen.add(Face::Front);
    m.facesSeen.add(Face::Left);
    m.shadowEdges.add(Face::Left);
    const Eigen::Vector2d hits(2.0, 0.0);
    const auto left = [&](const VehicleState& foretold)
    { return withoutShadowEdges(m, foretold, hits); };
    EXPECT_EQ(toString(left(car).facesSeen), "F");
    EXPECT_EQ(toString(left(car).hiddenEnds), "L");
    EXPECT_GT(std::sqrt(left(car).covariance(2, 2)), 0.1) << "rad";
    EXPECT_GT(left(car).covariance(1, 1), m.covariance(1, 1)) << "turned about the hits";
    m.box = {0.0, 0.02, 0.0, 4.5, 1.8};
    EXPECT_EQ(toString(left(car).facesSeen), "FL") << "where its side is";
    EXPECT_NEAR(left(car).covariance(2, 2), m.covariance(2, 2) + 0.05 * 0.05, 1e-9)
        << "if it is the side";
    m.box = {0.0, -0.3, 0.0, 4.5, 1.2};
    car.widthVariance = 1.0;
    EXPECT_EQ(toString(left(car).facesSeen), "FL") << "where its side is, is not known";
}

}  // namespace
}  // namespace vdamf
