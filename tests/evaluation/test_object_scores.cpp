// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/object_scores.h"

#include <gtest/gtest.h>

#include "example_pairs.h"

namespace vdamf
{
namespace
{
TEST(ObjectScores, TimesGapsAndIdentities)
{
    // Found in the frames 2, 3, 6 and 9 of 0 to 9, by track 7 and at last by track 8.
    Sequence sequence;
    for (int k = 0; k < 10; ++k)
    {
        const TruthRow car = exampleCar(100.0 + 0.1 * k);
        ScoredFrame frame = {car.time, car.sensor, {car}, {k > 0}, {}};
        if (k == 2 || k == 3 || k == 6) frame.tracks = {trackOn(car, 7)};
        if (k == 9) frame.tracks = {trackOn(car, 8)};
        sequence.frames.push_back(frame);
    }
    const auto scores = objectScores(sequence, matchFrames(sequence, 0.5));
    ASSERT_EQ(scores.size(), 1U);
    EXPECT_EQ(scores[0].id, "car");
    EXPECT_EQ(scores[0].objectClass, "Car");
    EXPECT_EQ(scores[0].frames, 9U);  // in the first one it does not count
    EXPECT_EQ(scores[0].found, 4U);
    EXPECT_EQ(scores[0].tracks, 2U);
    EXPECT_NEAR(scores[0].meanOverlap, 1.0, 1e-9);
    EXPECT_NEAR(scores[0].timeToFirst.value(), 0.1, 1e-9);
    EXPECT_NEAR(scores[0].longestGap, 0.3, 1e-9);
}

TEST(ObjectScores, ObjectsThatNeverCountAreNotTold)
{
    const TruthRow lost = exampleCar(100.0, "lost");
    TruthRow walker = exampleCar(100.0, "walker");
    walker.objectClass = "Pedestrian";
    Sequence sequence;
    sequence.frames.push_back({100.0, {}, {lost, walker}, {true, false}, {}});
    const auto scores = objectScores(sequence, matchFrames(sequence, 0.5));
    ASSERT_EQ(scores.size(), 1U);
    EXPECT_EQ(scores[0].id, "lost");
    EXPECT_EQ(scores[0].found, 0U);
    EXPECT_FALSE(scores[0].timeToFirst.has_value());
    EXPECT_EQ(scores[0].longestGap, 0.0);
}

}  // namespace
}  // namespace vdamf
