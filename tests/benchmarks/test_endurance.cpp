// SPDX-License-Identifier: BSD-3-Clause
// Long runs in short: memory, time, identities and precision stay as they were at the begin.
#include <gtest/gtest.h>

#include "endurance/endurance.h"

namespace vdamf::endurance
{
namespace
{
#ifdef __SANITIZE_ADDRESS__
constexpr double kGrowth = 100.0;  // MB; the sanitizer keeps what was given back
#else
constexpr double kGrowth = 8.0;
#endif

Plan shortDrive()
{
    Plan plan;
    plan.rawlog = VDAMF_SOURCE_DIR "/fuzz/corpus/track/clouds";
    plan.rows = 4;
    plan.configuration.tracker.lifecycle.confirmHits = 1;  // it has five frames
    return plan;
}

void expectUnchanged(const Result& result, const Plan& plan)
{
    ASSERT_EQ(result.rows.size(), static_cast<std::size_t>(plan.rows));
    EXPECT_EQ(result.reused, 0U);
    EXPECT_GT(result.confirmed, result.rounds);
    EXPECT_EQ(result.tracks % result.rounds, 0U) << "rounds differ";
    EXPECT_LT(result.rows.back().megabytes, result.rows.front().megabytes + kGrowth);
    // Others may keep the machine busy; a list that grows would show more.
    EXPECT_LT(result.rows.back().milliseconds, 3.0 * result.rows.front().milliseconds);
    for (const Row& row : result.rows)
    {
        EXPECT_EQ(row.same, 1.0) << row.kilometres << " km";
        EXPECT_EQ(row.alike, 1.0) << row.kilometres << " km";
    }
}

TEST(Endurance, AnHourIsLikeItsFirstMinutes)
{
    Plan plan = shortDrive();
    plan.hours = 0.8;
    expectUnchanged(run(plan), plan);
}

TEST(Endurance, AMonthAndAThousandKilometresLoseNoPrecision)
{
    Plan plan = shortDrive();
    plan.hours = 30.0 * 24.0;
    plan.pause = 2.0 * 3600.0;
    plan.drift = 2000.25;
    const Result result = run(plan);
    expectUnchanged(result, plan);
    EXPECT_GT(result.rows.back().kilometres, 1000.0);
}

TEST(Endurance, NamesARawlogThatCannotBeReplayed)
{
    Plan plan = shortDrive();
    plan.rawlog = "missing.rawlog";
    EXPECT_THROW(run(plan), std::runtime_error);
}

}  // namespace
}  // namespace vdamf::endurance
