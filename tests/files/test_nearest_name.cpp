// SPDX-License-Identifier: BSD-3-Clause
// Suggestions for misspelt names.
#include <gtest/gtest.h>

#include "vdamf/files/nearest_name.h"

namespace vdamf
{
namespace
{
TEST(NearestName, EditDistance)
{
    EXPECT_EQ(editDistance("", ""), 0U);
    EXPECT_EQ(editDistance("", "abc"), 3U);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
    EXPECT_EQ(editDistance("gpa_m", "gap_m"), 1U);
    EXPECT_EQ(editDistance("abc", "abc"), 0U);
}

TEST(NearestName, OnlyPlausibleNames)
{
    const std::vector<std::string> known = {"max_gap_s", "max_range_m", "label"};
    EXPECT_EQ(nearestName("max_gaps", known), "max_gap_s");
    EXPECT_EQ(nearestName("lable", known), "label");
    EXPECT_EQ(nearestName("max_gap", known), "max_gap_s");
    EXPECT_EQ(nearestName("sensor", known), "");
    EXPECT_EQ(nearestName("", known), "");
    EXPECT_EQ(nearestName(std::string(100000, 'x'), known), "");
}

}  // namespace
}  // namespace vdamf
