// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/chi_square.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vdamf
{
namespace
{
TEST(ChiSquare, QuantilesOfPrintedTables)
{
    struct Entry
    {
        double probability;
        int freedom;
        double quantile;  // NIST/SEMATECH e-Handbook 1.3.6.7.4, three decimals
    };
    constexpr std::array<Entry, 10> kTable = {{{0.95, 1, 3.841},
                                               {0.99, 1, 6.635},
                                               {0.95, 2, 5.991},
                                               {0.99, 2, 9.210},
                                               {0.95, 3, 7.815},
                                               {0.99, 3, 11.345},
                                               {0.999, 10, 29.588},
                                               {0.025, 20, 9.591},
                                               {0.01, 50, 29.707},
                                               {0.975, 100, 129.561}}};
    for (const Entry& entry : kTable)
    {
        EXPECT_NEAR(chiSquareQuantile(entry.probability, entry.freedom), entry.quantile, 6e-4)
            << entry.probability << " " << entry.freedom;
    }
}

TEST(ChiSquare, ClosedFormsOfOneAndTwoDegrees)
{
    for (const double p : {1e-8, 1e-3, 0.1, 0.5, 0.9, 0.99, 0.999999})
    {
        // Two degrees: an exponential distribution. One: the square of a normal variable.
        EXPECT_NEAR(chiSquareQuantile(p, 2) / (-2.0 * std::log1p(-p)), 1.0, 1e-9) << p;
        const double z = normalQuantile(0.5 + 0.5 * p);
        // 0.5 + 0.5 p keeps 16 digits of 0.5, not of p.
        EXPECT_NEAR(chiSquareQuantile(p, 1) / (z * z), 1.0, 1e-9 + 1e-15 / p) << p;
        EXPECT_NEAR(chiSquareProbability(2.0 * p, 2), -std::expm1(-p), 1e-14);
        EXPECT_NEAR(chiSquareProbability(2.0 * p, 1), std::erf(std::sqrt(p)), 1e-14);
    }
}

TEST(ChiSquare, TheInverseInverts)
{
    for (const double freedom : {0.5, 1.0, 2.0, 3.0, 5.0, 30.0, 200.0, 3000.0, 9999.0})
    {
        for (const double p : {1e-6, 0.01, 0.025, 0.5, 0.68, 0.975, 0.99, 1.0 - 1e-6})
        {
            const double x = chiSquareQuantile(p, freedom);
            EXPECT_NEAR(chiSquareProbability(x, freedom), p, 1e-11 + 1e-9 * p) << freedom;
        }
    }
}

TEST(ChiSquare, ManyDegreesJoinWithoutAStep)
{
    for (const double p : {1e-4, 0.025, 0.5, 0.975, 0.9999})
    {
        const double below = chiSquareQuantile(p, 9999.0);
        const double at = chiSquareQuantile(p, 10000.0);
        const double above = chiSquareQuantile(p, 10001.0);
        EXPECT_NEAR(above - 2.0 * at + below, 0.0, 1e-9 * at) << p;
        EXPECT_NEAR(chiSquareProbability(chiSquareQuantile(p, 1e6), 1e6), p, 1e-6);
    }
    // The band of a mean over N = 1000 values of 3 dimensions (normal approximation: 1 -+ 0.0506).
    EXPECT_NEAR(chiSquareQuantile(0.975, 3e3) / 3e3, 1.0512, 5e-4);
}

TEST(ChiSquare, TheEdges)
{
    EXPECT_EQ(chiSquareProbability(0.0, 3), 0.0);
    EXPECT_EQ(chiSquareProbability(-1.0, 3), 0.0);
    EXPECT_EQ(chiSquareProbability(INFINITY, 3), 1.0);
    EXPECT_NEAR(chiSquareProbability(1e4, 3), 1.0, 1e-15);
}

TEST(NormalQuantile, KnownValues)
{
    EXPECT_NEAR(normalQuantile(0.5), 0.0, 1e-15);
    EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-13);
    EXPECT_NEAR(normalQuantile(0.001), -3.090232306167813, 1e-13);
    EXPECT_NEAR(normalQuantile(0.2), -normalQuantile(0.8), 1e-13);
}

}  // namespace
}  // namespace vdamf
