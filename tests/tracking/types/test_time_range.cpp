// SPDX-License-Identifier: BSD-3-Clause
// The first and the last time of a scan's points, whatever their number and wherever these are.
#include "types/time_range.h"

#include <gtest/gtest.h>

namespace vdamf
{
namespace
{
TEST(TimeRange, IsOfAllPoints)
{
    for (std::size_t size = 1; size < 40; ++size)
        for (std::size_t at = 0; at < size; ++at)
        {
            std::vector<float> times(size, -0.03F);
            times[at] = 0.05F;
            EXPECT_EQ(timeRangeOf(times).last, 0.05F) << at << " of " << size;
            EXPECT_EQ(timeRangeOf(times).first, size == 1 ? 0.05F : -0.03F) << at << " of " << size;
            times[at] = -0.07F;
            EXPECT_EQ(timeRangeOf(times).first, -0.07F) << at << " of " << size;
        }
}

TEST(TimeRange, LeavesOutWhatIsNoTime)
{
    constexpr float kNone = std::numeric_limits<float>::infinity();
    for (const float bad : {kNone, -kNone, std::numeric_limits<float>::quiet_NaN()})
        for (std::size_t at = 0; at < 11; ++at)
        {
            std::vector<float> times(11, 0.02F);
            times[at] = bad;
            EXPECT_EQ(timeRangeOf(times).first, 0.02F) << bad << " at " << at;
            EXPECT_EQ(timeRangeOf(times).last, 0.02F) << bad << " at " << at;
        }
}

TEST(TimeRange, IsOpenWithoutAny)
{
    for (const std::vector<float>& none :
         {std::vector<float>{}, {std::numeric_limits<float>::quiet_NaN()}})
        EXPECT_GT(timeRangeOf(none).first, timeRangeOf(none).last);
}
}  // namespace
}  // namespace vdamf
