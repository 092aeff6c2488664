// SPDX-License-Identifier: BSD-3-Clause
// The less it may be a vehicle, the less work a track is worth.
#include "tracker/attention.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
Track seenOften(double probability, int sightings)
{
    Track track;
    track.judgement.probability = probability;
    track.sightings = sightings;
    track.lastMatch = 2.0;
    return track;
}

const Discriminator kDiscriminator{DiscriminatorOptions()};

int framesPassedOver(double probability, int sightings)
{
    int passed = 0;
    for (int k = 0; k < 40; ++k)
        passed += isPassedOver(seenOften(probability, sightings + k), kDiscriminator) ? 1 : 0;
    return passed;
}

TEST(Attention, PassesOverWhatIsRuledOutAndMoreOfWhatIsSurelyNone)
{
    EXPECT_EQ(framesPassedOver(0.5, 10), 0);
    EXPECT_EQ(framesPassedOver(0.05, 10), 30);
    EXPECT_EQ(framesPassedOver(0.001, 10), 35);
}

TEST(Attention, PassesOverNoneOfTheFirstSightings)
{
    for (int sightings = 1; sightings < 6; ++sightings)
        EXPECT_FALSE(isPassedOver(seenOften(0.05, sightings), kDiscriminator)) << sightings;
    for (int sightings = 1; sightings < 3; ++sightings)
        EXPECT_FALSE(isPassedOver(seenOften(0.001, sightings), kDiscriminator)) << sightings;
    EXPECT_TRUE(isPassedOver(seenOften(0.001, 4), kDiscriminator));
}

TEST(Attention, LooksLessCloselyTheLessItMayBeAVehicle)
{
    const Attention vehicle = attentionFor(seenOften(0.9, 10), kDiscriminator);
    EXPECT_FALSE(vehicle.search.isFirstTaken);
    EXPECT_FALSE(vehicle.isPlaceEnough);
    EXPECT_NEAR(vehicle.search.enoughMatch, 1.2, 1e-9);
    const Attention ruledOut = attentionFor(seenOften(0.05, 10), kDiscriminator);
    EXPECT_TRUE(ruledOut.search.isFirstTaken);
    EXPECT_FALSE(ruledOut.isPlaceEnough);
    const Attention none = attentionFor(seenOften(0.001, 10), kDiscriminator);
    EXPECT_TRUE(none.search.isFirstTaken);
    EXPECT_TRUE(none.isPlaceEnough);
    Track drives = seenOften(0.001, 10);
    drives.state.mean(kSpeed) = -5.0;
    EXPECT_TRUE(attentionFor(drives, kDiscriminator).search.isFirstTaken);
    EXPECT_FALSE(attentionFor(drives, kDiscriminator).isPlaceEnough);
    EXPECT_FALSE(attentionFor(seenOften(0.05, 5), kDiscriminator).search.isFirstTaken);
    EXPECT_TRUE(attentionFor(seenOften(0.001, 3), kDiscriminator).isPlaceEnough);
    // By fewer frames nothing is ruled out.
    EXPECT_FALSE(attentionFor(seenOften(0.001, 2), kDiscriminator).search.isFirstTaken);
}

TEST(Attention, SearchesWhereTheHitsAreAsWellForWhatIsVague)
{
    Track vague = seenOften(0.9, 10);
    vague.state.covariance(kX, kX) = vague.state.covariance(kY, kY) = 1.0;
    EXPECT_TRUE(std::isinf(attentionFor(vague, kDiscriminator).search.enoughMatch));
}

}  // namespace
}  // namespace vdamf
