// SPDX-License-Identifier: BSD-3-Clause
// Riders and people go where their hits go, whatever the faces say that are fitted to them.
#include "tracker/faceless.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "simulated_frames.h"
#include "tracker/neighbourhood.h"

namespace vdamf
{
namespace
{
constexpr double kStep = 0.1;  // s
constexpr double kRide = 4.0;  // m/s

// A bicycle seen from its side, which is taken for the end of a car that stands across.
Sighting bicycleAt(const Eigen::Vector2d& place, double direction, double time)
{
    const double across = wrapAngle(direction - 80.0 * kPi / 180.0);
    Sighting s;
    s.time = time;
    s.measurement.box = {place.x(), place.y(), across, 0.5, 1.65};
    s.measurement.covariance = (Vector5d() << 1e-3, 1e-3, 2e-3, 4.0, 1e-2).finished().asDiagonal();
    s.measurement.facesSeen.add(Face::Back);
    s.measurement.hits = 120;
    s.measurement.match = 0.4;
    s.around = {place.x(), place.y(), direction, 1.7, 0.5};
    s.height = 1.7;
    s.end = {1.65, 110.0};
    return s;
}

class Faceless : public ::testing::Test
{
protected:
    // A frame later; the probability is that of a vehicle.
    void see(const Sighting& sighting, double probability)
    {
        if (track_.id == 0)
            track_ = startedTrack(1, sighting, {0.0, 16.0}, options_);
        else
        {
            track_ = predictedTrack(std::move(track_), kStep, {0.0, 0.0}, filter_, options_.motion);
            track_ = sightedTrack(std::move(track_), sighting, Neighbourhood(), filter_, options_);
        }
        track_.judgement.probability = probability;
    }

    void rideStraightOn(int frames, double probability)
    {
        for (int k = 0; k < frames; ++k)
            see(bicycleAt({10.0 + kRide * kStep * k, 5.0}, 0.0, kStep * k), probability);
    }

    TrackerOptions options_;
    VehicleKalmanFilter filter_{options_.motion};
    Track track_;
};

TEST_F(Faceless, ABicycleGoesWhereItsHitsGo)
{
    rideStraightOn(12, 0.02);
    EXPECT_TRUE(track_.isFaceless);
    EXPECT_NEAR(track_.state.mean(kHeading), 0.0, 0.05);
    EXPECT_NEAR(track_.state.mean(kSpeed), kRide, 0.1);
    EXPECT_NEAR(track_.box().x, 10.0 + kRide * kStep * 11, 0.1);
    EXPECT_NEAR(track_.box().length, 1.7, 0.15);
    EXPECT_NEAR(track_.box().width, 0.5, 0.15);
    EXPECT_GT(track_.front.forwardProbability(), 0.95);
}

TEST_F(Faceless, WhatMayBeAVehicleHasFaces)
{
    rideStraightOn(12, 0.2);
    EXPECT_FALSE(track_.isFaceless);
}

TEST_F(Faceless, AVehicleAfterAllHasFacesAgain)
{
    rideStraightOn(12, 0.02);
    track_.judgement.probability = 0.4;
    see(bicycleAt({10.0 + kRide * kStep * 12, 5.0}, 0.0, kStep * 12), 0.4);
    EXPECT_FALSE(track_.isFaceless);
}

TEST_F(Faceless, SoHasWhatIsLargerOrHigherThanARider)
{
    for (int k = 0; k < 12; ++k)
    {
        Sighting large = bicycleAt({10.0 + kRide * kStep * k, 5.0}, 0.0, kStep * k);
        large.around.length = 3.5;
        see(large, 0.02);
    }
    EXPECT_FALSE(track_.isFaceless);
    track_ = {};
    for (int k = 0; k < 12; ++k)
    {
        Sighting high = bicycleAt({10.0 + kRide * kStep * k, 5.0}, 0.0, kStep * k);
        high.height = 3.0;
        see(high, 0.02);
    }
    EXPECT_FALSE(track_.isFaceless);
}

TEST_F(Faceless, WhatStandsOrJumpsGoesNowhere)
{
    for (int k = 0; k < 20; ++k)
        see(bicycleAt({10.0 + 0.1 * (k % 2), 5.0 + 0.004 * k}, 0.0, kStep * k), 0.02);
    EXPECT_FALSE(track_.isFaceless);
    track_ = {};
    for (int k = 0; k < 20; ++k)
        see(bicycleAt({10.0 + (k < 10 ? 0.0 : 1.0), 5.0}, 0.0, kStep * k), 0.02);
    EXPECT_FALSE(track_.isFaceless);
}

TEST_F(Faceless, WhoTurnsOnTheSpotIsFollowed)
{
    rideStraightOn(12, 0.02);
    const Eigen::Vector2d corner(10.0 + kRide * kStep * 11, 5.0);
    for (int k = 1; k <= 10; ++k)
        see(bicycleAt(corner + Eigen::Vector2d(0.0, 1.5 * kStep * k), 0.5 * kPi, kStep * (11 + k)),
            0.02);
    EXPECT_NEAR(track_.state.mean(kHeading), 0.5 * kPi, 0.3);
    EXPECT_NEAR(track_.state.mean(kSpeed), 1.5, 0.4);
}

TEST_F(Faceless, WhoIsFastHardlyTurns)
{
    const auto headingSigmaAfterAMiss = [&](double speed)
    {
        track_ = {};
        for (int k = 0; !track_.isFaceless && k < 20; ++k)
            see(bicycleAt({10.0 + speed * kStep * k, 5.0}, 0.0, kStep * k), 0.02);
        EXPECT_TRUE(track_.isFaceless) << speed;
        track_ = predictedTrack(std::move(track_), 0.4, {0.0, 0.0}, filter_, options_.motion);
        return std::sqrt(track_.state.covariance(kHeading, kHeading));
    };
    EXPECT_GT(headingSigmaAfterAMiss(kRide), 0.12) << "who is slow may";
    EXPECT_LT(headingSigmaAfterAMiss(25.0), 0.1);
}

TEST(BodyAround, IsNoThinnerThanABodyAndGrowsAwayFromTheSensor)
{
    const OrientedBox front{10.0, 0.0, 0.0, 0.1, 0.6};
    const OrientedBox person = bodyAround(front, {0.0, 0.0});
    EXPECT_DOUBLE_EQ(person.length, 0.5);
    EXPECT_DOUBLE_EQ(person.width, 0.6);
    EXPECT_DOUBLE_EQ(person.x, 10.2) << "the hits stay where they are";
    EXPECT_DOUBLE_EQ(person.y, 0.0);
    const OrientedBox behind = bodyAround({0.0, -10.0, 0.5 * kPi, 0.1, 0.6}, {0.0, 0.0});
    EXPECT_NEAR(behind.y, -10.2, 1e-12);
    const OrientedBox bicycle{10.0, 0.0, 0.0, 1.8, 0.6};
    EXPECT_EQ(bodyAround(bicycle, {0.0, 0.0}).x, bicycle.x);
}

TEST(FacelessScene, RidersAndWalkersKeepTheirIdentityHeadingAndSpeed)
{
    const std::string scene = R"(
[scenario]
duration_s = 6

[sensor]
x_m = 0.8
z_m = 1.9

[platform]
speed_mps = 3

[object cyclist]
class = bicycle
x_m = 9
y_m = -4
speed_mps = 4.2

[object crossing]
class = bicycle
x_m = 24
y_m = -12
heading_deg = 90
speed_mps = 4

[object walker]
class = pedestrian
x_m = 16
y_m = 6
heading_deg = 180
speed_mps = 1.4
)";
    for (const int seed : {1, 2, 3})
        for (const auto& [name, frames] : trackedObjects(scenarioOf(scene, seed)))
        {
            SCOPED_TRACE(name + ", seed " + std::to_string(seed));
            std::set<std::uint64_t> ids;
            int found = 0;
            double heading = 0.0;
            double speed = 0.0;
            for (const Seen& seen : frames)
            {
                // Its way has to be seen first.
                if (seen.time < 1.2 || seen.tracks.empty()) continue;
                const TrackReport& track = seen.tracks.front();
                ids.insert(track.id);
                ++found;
                heading += std::pow(wrapAngle(track.box.heading - seen.truth.box.heading), 2);
                speed += std::pow(track.speed - seen.truth.speed, 2);
            }
            EXPECT_GT(found, 40);
            EXPECT_EQ(ids.size(), 1U);
            EXPECT_LT(std::sqrt(heading / found), 0.2);
            EXPECT_LT(std::sqrt(speed / found), 0.6);
        }
}

}  // namespace
}  // namespace vdamf
