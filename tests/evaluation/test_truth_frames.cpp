// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/truth_frames.h"

#include <gmock/gmock.h>

#include "evaluation/small_sequences.h"

namespace vdamf
{
namespace
{
using testing::ElementsAre;
using testing::IsEmpty;

/// Two objects a frame, 0 to 9.
Scene tenFrames()
{
    Scene scene;
    for (int frame = 0; frame < 10; ++frame)
    {
        scene.object(frame, "a", carAt(0.0));
        scene.object(frame, "b", carAt(20.0));
    }
    return scene;
}

TEST(TruthFrames, AreThoseOfASpanOfTime)
{
    const Scene scene = tenFrames();
    const std::vector<TruthRow> part =
        truthWithin(scene.truth, {timeOf(3) + 0.0005, timeOf(5) - 0.0005});
    EXPECT_EQ(part.size(), 6U);
    EXPECT_THAT(frameTimes(part), ElementsAre(timeOf(3), timeOf(4), timeOf(5)));
    EXPECT_THAT(truthWithin(scene.truth, {timeOf(20), timeOf(30)}), IsEmpty());
}

TEST(TruthFrames, AreThoseAtGivenTimes)
{
    const Scene scene = tenFrames();
    const std::vector<TruthRow> part =
        truthAt(scene.truth, {timeOf(7) - 0.0005, timeOf(2), timeOf(4) + 0.05});
    EXPECT_EQ(part.size(), 4U);
    EXPECT_THAT(frameTimes(part), ElementsAre(timeOf(2), timeOf(7)));
    EXPECT_THAT(truthAt(scene.truth, {}), IsEmpty());
}

TEST(TruthFrames, SpansAreThoseOfTheRows)
{
    EXPECT_FALSE(spanOf(std::vector<TruthRow>()));
    EXPECT_FALSE(spanOf(std::vector<TrackRow>()));
    const std::optional<TimeSpan> span = spanOf(tenFrames().truth);
    ASSERT_TRUE(span);
    EXPECT_EQ(span->first, timeOf(0));
    EXPECT_EQ(span->last, timeOf(9));
    EXPECT_EQ(inWords(TimeSpan{1.5, 2.25}), "1.500000 to 2.250000 s");
}

TEST(TruthFrames, TheNearestTimeIsTheEarlierOfTwoAsNear)
{
    const std::vector<double> times{1.0, 2.0, 4.0};
    EXPECT_EQ(nearestTime(times, 0.0), 0U);
    EXPECT_EQ(nearestTime(times, 1.5), 0U);
    EXPECT_EQ(nearestTime(times, 1.6), 1U);
    EXPECT_EQ(nearestTime(times, 3.1), 2U);
    EXPECT_EQ(nearestTime(times, 9.0), 2U);
}
}  // namespace
}  // namespace vdamf
