// SPDX-License-Identifier: BSD-3-Clause
// Which frames of a track the discriminator looks at.
#include "tracker/discriminate.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace vdamf
{
namespace
{
// All objects score the bias.
Discriminator always(double bias)
{
    DiscriminatorModel model = untrainedModel();
    model.bias = bias;
    DiscriminatorOptions options;
    options.loaded = std::make_shared<const DiscriminatorModel>(model);
    return Discriminator(options);
}

// Hits along the side of a car.
SegmentedFrame frameWith(std::size_t hits)
{
    SegmentedFrame frame;
    frame.sensor = {0.0, -10.0};
    frame.points = 1000;
    Cluster side;
    for (std::size_t i = 0; i < hits; ++i)
    {
        side.x.push_back(4.0F * static_cast<float>(i) / static_cast<float>(hits) - 2.0F);
        side.y.push_back(-0.9F);
        side.z.push_back(0.5F);
        side.height.push_back(0.5F);
    }
    frame.clusters.push_back(side);
    return frame;
}

Track carAlong(std::uint64_t id)
{
    Measurement measurement;
    measurement.box = {0.0, 0.0, 0.0, 4.3, 1.8};
    Track track;
    track.id = id;
    track.measurement = measurement;
    return track;
}

// After one more sighting of so many hits; whether they were looked at shows in their number.
Track seen(Track track, const Discriminator& discriminator, std::size_t hits)
{
    ++track.sightings;
    track.hits = static_cast<int>(hits);
    track.judgement = discriminator.judged(track, frameWith(hits), {0});
    return track;
}

int looksIn(const Discriminator& discriminator, int sightings)
{
    Track track = carAlong(7);
    int looks = 0;
    for (int k = 0; k < sightings; ++k)
    {
        const std::size_t hits = 100 + static_cast<std::size_t>(k);
        track = seen(std::move(track), discriminator, hits);
        looks += track.judgement.hits == hits ? 1 : 0;
    }
    return looks;
}

TEST(Discriminate, LooksAtFewerFramesOnceItKnows)
{
    EXPECT_EQ(looksIn(always(0.0), 5), 5);
    EXPECT_EQ(looksIn(always(0.0), 45), 5 + 20);
    EXPECT_LE(looksIn(always(2.0), 45), 2 + 11);
    EXPECT_GE(looksIn(always(2.0), 45), 1 + 5);
    EXPECT_LE(looksIn(always(6.0), 45), 2 + 6);
    EXPECT_GE(looksIn(always(6.0), 45), 1 + 5);
    EXPECT_EQ(looksIn(always(2.0), 45), looksIn(always(-2.0), 45)) << "sure that it is none";
}

// A flat end that is hit in two parts, a revolution and 0.8 m apart, is as flat as at one time.
TEST(Discriminate, PutsTogetherWhatWasHitAtBothEndsOfARevolution)
{
    DiscriminatorOptions options;
    options.keepFeatures = true;
    const Discriminator discriminator{options};
    constexpr float kSpeed = 8.0F;
    const auto features = [&](float speed, bool areParts)
    {
        Cluster rear;
        for (int i = 0; i < 40; ++i)
        {
            const float time = i < 20 ? 0.0F : 0.1F;
            rear.x.push_back(-2.0F + speed * (time - 0.05F));
            rear.y.push_back(0.05F * (static_cast<float>(i) - 19.5F));
            rear.height.push_back(0.2F + 0.3F * static_cast<float>(i % 4));
            rear.z.push_back(rear.height.back());
            rear.time.push_back(time);
        }
        SegmentedFrame frame;
        frame.sensor = {-15.0, 0.0};
        frame.points = 1000;
        frame.clusters.push_back(rear);
        Track track = carAlong(3);
        track.hits = 40;
        track.areParts = areParts;
        track.state.mean << 0.0, 0.0, 0.0, speed, 0.0, 1.2, 4.3;
        return discriminator.judged(track, frame, {0}).features;
    };
    const std::vector<float> atOnce = features(0.0F, false);
    const std::vector<float> inParts = features(kSpeed, true);
    ASSERT_EQ(atOnce.size(), inParts.size());
    float most = 0.0F;
    for (std::size_t i = 0; i < atOnce.size(); ++i)
        most = std::max(most, std::abs(atOnce[i] - inParts[i]));
    EXPECT_LT(most, 1e-3F);
    EXPECT_NE(features(kSpeed, false), inParts);
}

TEST(Discriminate, LooksAgainWhereMoreOrLessIsSeen)
{
    const Discriminator discriminator = always(2.0);
    for (const std::size_t other : {160U, 60U})
        for (std::uint64_t id = 0; id < 4; ++id)
        {
            Track track = carAlong(id);
            for (int k = 0; k < 20; ++k) track = seen(std::move(track), discriminator, 100);
            EXPECT_EQ(seen(track, discriminator, other).judgement.hits, other);
        }
}

// A car of which little is seen is taken to lie across, and looks like no vehicle there.
TEST(Discriminate, ForgetsMostOfWhatItSawInABoxThatHasTurned)
{
    const Discriminator no = always(-2.0);
    const Discriminator yes = always(2.0);
    const auto later = [&](double turn)
    {
        Track track = carAlong(7);
        for (int k = 0; k < 20; ++k) track = seen(std::move(track), no, 100);
        EXPECT_LT(track.judgement.probability, 0.1);
        track.measurement->box.heading = turn;
        track = seen(std::move(track), yes, 101);
        const bool looked = track.judgement.hits == 101;
        for (int k = 0; k < 7; ++k) track = seen(std::move(track), yes, 200);
        return std::pair(looked, track.judgement.probability);
    };
    for (const double across : {0.5 * kPi, -0.5 * kPi, 1.0, 2.2})
    {
        EXPECT_TRUE(later(across).first) << across;
        EXPECT_GT(later(across).second, 0.5) << across;
    }
    for (const double alike : {0.0, kPi, 0.6, -2.6})
        EXPECT_LT(later(alike).second, 0.3) << alike << ": front and rear may be exchanged";
}

TEST(Discriminate, LooksAtTheSameFirstFramesWhateverTheIdentity)
{
    for (const double logOdds : {0.0, 2.5, 6.0})
        for (std::uint64_t id = 0; id < 8; ++id)
        {
            Track track = carAlong(id);
            for (const std::size_t hits : {100U, 101U, 102U})
            {
                track = seen(std::move(track), always(logOdds), hits);
                EXPECT_EQ(track.judgement.hits, hits) << id;
            }
        }
}

TEST(Discriminate, TakesWhatItDoesNotLookAtToSayTheSame)
{
    const Discriminator discriminator = always(0.7);
    Track track = carAlong(3);
    VehicleEvidence evidence;
    for (int k = 0; k < 30; ++k)
    {
        track = seen(std::move(track), discriminator, 100);
        evidence = withFrame(evidence, 0.7, TrackCalibration(), 0.0);
    }
    EXPECT_NEAR(track.judgement.evidence.sum, evidence.sum, 1e-9);
    EXPECT_NEAR(track.judgement.evidence.frames, evidence.frames, 1e-9);
}
// The rear of a bus, flat as a wall, that drives 8 m/s.
Track rearOfABus(double interval = 0.1)
{
    Track track = carAlong(7);
    track.sightings = 20;
    track.height = 3.0;
    track.around = {0.0, 0.0, 0.0, 0.2, 2.4};
    track.state.mean(kSpeed) = 8.0;
    track.state.covariance(kSpeed, kSpeed) = 0.01;
    for (int k = 0; interval * k < 1.45; ++k)
        track.path.push_back({interval * k, {8.0 * interval * k, 0.0, 0.0, 9.0, 2.5}, {}});
    return track;
}

TEST(Discriminate, WhatDrivesAsVehiclesDoIsOneWhateverItLooksLike)
{
    const Discriminator discriminator = always(-4.0);
    const Track bus = seen(rearOfABus(), discriminator, 100);
    EXPECT_TRUE(bus.judgement.hasDriven);
    EXPECT_FALSE(discriminator.rulesOut(bus));
    EXPECT_TRUE(seen(rearOfABus(0.35), discriminator, 100).judgement.hasDriven) << "3 frames/s";
    // And still is when it stops.
    Track stopped = bus;
    stopped.state.mean(kSpeed) = 0.0;
    stopped = seen(stopped, discriminator, 100);
    EXPECT_TRUE(stopped.judgement.hasDriven);
    EXPECT_FALSE(discriminator.rulesOut(stopped));
    Track never = rearOfABus();
    never.state.mean(kSpeed) = 0.0;
    never = seen(never, discriminator, 100);
    EXPECT_LT(never.judgement.probability, 0.1);
    EXPECT_GT(bus.judgement.probability, 10.0 * never.judgement.probability);
}

TEST(Discriminate, WhatIsNoneAndStandsLiesAlongItsLongerSide)
{
    const Discriminator discriminator = always(-4.0);
    Track parked = carAlong(1);
    parked.sightings = 10;
    parked.judgement.probability = 0.02;
    parked.stoodProbability = 0.9;
    parked.around = {0.0, 0.0, 0.0, 0.4, 1.7};
    const OrientedBox bicycle = discriminator.extentOf(parked);
    EXPECT_DOUBLE_EQ(bicycle.length, 1.7);
    EXPECT_DOUBLE_EQ(bicycle.width, 0.4);
    EXPECT_DOUBLE_EQ(bicycle.heading, 0.5 * kPi);
    Track goes = parked;
    goes.stoodProbability = 0.1;
    EXPECT_DOUBLE_EQ(discriminator.extentOf(goes).length, 0.4) << "its speed is along its heading";
    HeadingCues row;
    row.neighbours = 2.0;
    Track piece = parked;
    piece.front = piece.front.after(row);
    EXPECT_DOUBLE_EQ(discriminator.extentOf(piece).heading, 0.0) << "of a car in a row, by its end";
    Track wall = piece;
    wall.around.width = 4.0;
    EXPECT_DOUBLE_EQ(discriminator.extentOf(wall).length, 4.0) << "wider than any end";
    Track car = parked;
    car.judgement.probability = 0.9;
    EXPECT_EQ(discriminator.extentOf(car).length, car.box().length);
}

TEST(Discriminate, WhatOnlySeemsToDriveIsNoVehicle)
{
    const Discriminator discriminator = always(-4.0);
    const auto hasDriven = [&](const Track& track)
    { return seen(track, discriminator, 100).judgement.hasDriven; };
    Track guardRail = rearOfABus();
    guardRail.around = {0.0, 0.0, 0.0, 15.0, 0.4};
    EXPECT_FALSE(hasDriven(guardRail));
    Track person = rearOfABus();
    person.height = 1.8;
    EXPECT_FALSE(hasDriven(person));
    // Other parts of a hedge come into view.
    Track jumps = rearOfABus();
    for (std::size_t k = 0; k < 14; ++k) jumps.path[k].box.x = 0.0;
    EXPECT_FALSE(hasDriven(jumps));
    Track grows = rearOfABus();
    for (int k = 0; k < 15; ++k) grows.path[static_cast<std::size_t>(k)].box.length = 4.0 + 1.6 * k;
    EXPECT_FALSE(hasDriven(grows));
    Track isNew = rearOfABus();
    isNew.path.resize(8);
    EXPECT_FALSE(hasDriven(isNew));
    Track stands = rearOfABus();
    stands.stoodProbability = 0.6;
    EXPECT_FALSE(hasDriven(stands));
    Track vague = rearOfABus();
    vague.state.covariance(kSpeed, kSpeed) = 9.0;
    EXPECT_FALSE(hasDriven(vague));
}

}  // namespace
}  // namespace vdamf
