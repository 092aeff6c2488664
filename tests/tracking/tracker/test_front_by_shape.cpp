// SPDX-License-Identifier: BSD-3-Clause
// Which end of what stands is its front.
#include "tracker/front_by_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "tracking/tracker/seen_as.h"
#include "tracking/tracker/simulated_frames.h"

namespace vdamf
{
namespace
{
constexpr double kCarEndAt = 15.0;  // m ahead
constexpr double kBoxLength = 4.4;  // m
constexpr double kBoxWidth = 1.8;   // m

void addRowAcross(Cluster& hits, double height, double x)
{
    for (int k = 0; k < 15; ++k)
    {
        hits.x.push_back(static_cast<float>(x));
        hits.y.push_back(static_cast<float>(0.1 * (k - 7)));
        hits.height.push_back(static_cast<float>(height));
    }
}

// An end with a bumper, windows that begin so far behind it, and a roof.
HitsAtOneTime endWithWindows(double depth, double roof)
{
    Cluster hits;
    addRowAcross(hits, 0.5, kCarEndAt);
    addRowAcross(hits, 0.8, kCarEndAt + 0.1);
    addRowAcross(hits, 1.25, kCarEndAt + depth);
    addRowAcross(hits, roof, kCarEndAt + depth + 0.6);
    return seenAs(std::move(hits));
}

// As it is measured, with the end held for its rear.
Sighting heldForRear(double width, double height)
{
    Sighting s;
    s.measurement.box = {kCarEndAt + 0.5 * kBoxLength, 0.0, 0.0, kBoxLength, width};
    s.measurement.facesSeen.add(Face::Back);
    s.height = height;
    return s;
}

// The same measurement with front and rear exchanged.
Sighting withFrontForRear(Sighting s)
{
    s.measurement.box.heading = kPi;
    s.measurement.facesSeen = FaceSet();
    s.measurement.facesSeen.add(Face::Front);
    return s;
}

double toldOf(double depth, double roof = 1.5, double width = kBoxWidth)
{
    return frontByShape(heldForRear(width, roof), endWithWindows(depth, roof));
}

TEST(FrontByShape, AWindscreenStandsFartherBehindItsEndThanRearWindows)
{
    EXPECT_GT(toldOf(0.1), 1.0) << "tailgate";
    EXPECT_GT(toldOf(0.4), 1.0) << "tailgate";
    EXPECT_GT(toldOf(0.8), 0.3) << "boot";
    EXPECT_LT(toldOf(1.5), -1.0) << "bonnet";
    EXPECT_LT(std::abs(toldOf(1.15)), 0.7) << "either";
}

TEST(FrontByShape, BonnetsOfVansAreShortAndTheirRearsUpright)
{
    EXPECT_GT(toldOf(0.0, 2.0, 2.0), 1.0);
    EXPECT_LT(toldOf(0.6, 2.0, 2.0), -1.0);
}

TEST(FrontByShape, IsToldForTheHeadingThatWasMeasured)
{
    for (const double depth : {0.2, 0.8, 1.5})
        EXPECT_NEAR(
            frontByShape(withFrontForRear(heldForRear(kBoxWidth, 1.5)), endWithWindows(depth, 1.5)),
            -toldOf(depth), 1e-6)
            << depth;
}

TEST(FrontByShape, TellsNothingWhereThereIsNothingToSee)
{
    EXPECT_EQ(toldOf(0.1, 2.6), 0.0) << "as high as a bus";
    EXPECT_EQ(toldOf(0.1, 1.5, 0.8), 0.0) << "as narrow as a two-wheeler";
    EXPECT_EQ(toldOf(3.0), 0.0) << "windows of no end";
    Sighting hidden = heldForRear(kBoxWidth, 1.5);
    hidden.measurement.hiddenEnds.add(Face::Back);
    EXPECT_EQ(frontByShape(hidden, endWithWindows(0.1, 1.5)), 0.0) << "where the end lies";
    Sighting upper = heldForRear(kBoxWidth, 1.5);
    upper.measurement.upperEnds.add(Face::Back);
    EXPECT_EQ(frontByShape(upper, endWithWindows(0.1, 1.5)), 0.0) << "how far it goes on below";
    HitsAtOneTime level = endWithWindows(0.1, 1.5);
    Hits planar = *level.hits;
    planar.heights = 0;
    level.hits = planar;
    EXPECT_EQ(frontByShape(heldForRear(kBoxWidth, 1.5), level), 0.0) << "heights";
    Cluster low;
    addRowAcross(low, 0.5, kCarEndAt);
    HitsAtOneTime bumper;
    bumper.hits = projectHits(low, 0.0);
    bumper.each = low;
    EXPECT_EQ(frontByShape(heldForRear(kBoxWidth, 0.5), bumper), 0.0) << "windows";
}

// Two of each body around the sensor, towards it and away from it, askew and straight.
TEST(FrontByShape, VehiclesThatStandAreHeldForTheWayTheyStand)
{
    const std::string scene = R"(
[scenario]
duration_s = 2

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
speed_mps = 0
)";
    int objects = 0;
    std::string all = scene;
    for (const char* kind : {"car", "hatchback", "suv", "van"})
        for (const int turn : {0, 180})
        {
            const double bearing = 45.0 * objects * kPi / 180.0;
            const int heading = (45 * objects + 25 + turn) % 360;
            all += "\n[object " + std::string(kind) + std::to_string(turn) + "]\nclass = " + kind +
                   "\nx_m = " + std::to_string(14.0 * std::cos(bearing)) +
                   "\ny_m = " + std::to_string(14.0 * std::sin(bearing)) +
                   "\nheading_deg = " + std::to_string(heading) + "\n";
            ++objects;
        }
    for (int seed = 1; seed <= 2; ++seed)
    {
        const auto tracked = trackedObjects(scenarioOf(all, seed));
        int found = 0;
        for (const auto& [name, seen] : tracked)
        {
            const Seen& last = seen.back();
            ASSERT_FALSE(last.tracks.empty()) << name << ", seed " << seed;
            const TrackReport& track = last.tracks.front();
            EXPECT_GT(std::cos(track.box.heading - last.truth.box.heading), 0.9)
                << name << ", seed " << seed;
            EXPECT_GT(track.forwardProbability, 0.8) << name << ", seed " << seed;
            EXPECT_GT(track.axesProbability, 0.99) << name << ", seed " << seed;
            ++found;
        }
        EXPECT_EQ(found, objects);
    }
}

}  // namespace
}  // namespace vdamf
