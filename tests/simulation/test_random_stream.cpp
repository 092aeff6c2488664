// SPDX-License-Identifier: BSD-3-Clause
// Moments and independence of the random numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
namespace
{
TEST(RandomStream, SameSeedAndIndexGiveTheSameNumbers)
{
    RandomStream a(7, 3);
    RandomStream b(7, 3);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(a.gaussian(), b.gaussian());
}

TEST(RandomStream, NeighbouringSeedsAndIndicesAreUncorrelated)
{
    const int n = 20000;
    for (const auto& [seed, index] : {std::pair{7, 4}, {8, 3}, {3, 7}})
    {
        RandomStream a(7, 3);
        RandomStream b(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(index));
        double sum = 0.0;
        for (int i = 0; i < n; ++i) sum += (a.uniform() - 0.5) * (b.uniform() - 0.5) * 12.0;
        EXPECT_LT(std::abs(sum / n), 4.0 / std::sqrt(n)) << seed << ' ' << index;
    }
}

TEST(RandomStream, MomentsAreThoseOfTheDistributions)
{
    RandomStream random(1, 0);
    const int n = 200000;
    double uniform = 0.0;
    double gaussian = 0.0;
    double square = 0.0;
    double fourth = 0.0;
    double exponential = 0.0;
    for (int i = 0; i < n; ++i)
    {
        const double u = random.uniform();
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        uniform += u;
        const double g = random.gaussian();
        gaussian += g;
        square += g * g;
        fourth += g * g * g * g;
        exponential += random.exponential(0.3);
    }
    EXPECT_NEAR(uniform / n, 0.5, 0.004);
    EXPECT_NEAR(gaussian / n, 0.0, 0.01);
    EXPECT_NEAR(square / n, 1.0, 0.015);
    EXPECT_NEAR(fourth / n, 3.0, 0.1);
    EXPECT_NEAR(exponential / n, 0.3, 0.004);
}
}  // namespace
}  // namespace vdamf
