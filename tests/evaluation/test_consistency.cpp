// SPDX-License-Identifier: BSD-3-Clause
// Consistency of made errors: of a right filter, of wrong ones, and of one with a few blunders.
#include "vdamf/evaluation/consistency.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace vdamf
{
namespace
{
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Squared errors of a filter whose errors are `ratio` times as large as it says.
std::vector<double> squaredErrors(std::size_t count, int dimension, double ratio,
                                  std::mt19937_64& random)
{
    std::normal_distribution<double> normal;
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i)
    {
        double sum = 0.0;
        for (int k = 0; k < dimension; ++k) sum += std::pow(ratio * normal(random), 2);
        values.push_back(sum);
    }
    return values;
}

TEST(Consistency, TheBandHoldsNineteenOfTwentyMeans)
{
    std::mt19937_64 random(1);
    constexpr int kRuns = 2000;
    for (const int dimension : {1, 2, 3})
    {
        int inside = 0;
        for (int run = 0; run < kRuns; ++run)
        {
            const Consistency c =
                consistencyOf(squaredErrors(50, dimension, 1.0, random), dimension);
            inside += c.mean >= c.lowerBound && c.mean <= c.upperBound ? 1 : 0;
        }
        // 3.5 sigma of the binomial distribution.
        EXPECT_NEAR(static_cast<double>(inside) / kRuns, 0.95, 0.017) << dimension;
    }
}

TEST(Consistency, BandsOfTheLiterature)
{
    // Mean of N = 50 values of dimension 3: 0.787 to 1.239; N = 200: 0.890 to 1.116.
    const Consistency fifty = consistencyOf(std::vector<double>(50, 3.0), 3);
    EXPECT_NEAR(fifty.lowerBound, 0.787, 2e-3);
    EXPECT_NEAR(fifty.upperBound, 1.239, 2e-3);
    const Consistency more = consistencyOf(std::vector<double>(200, 3.0), 3);
    EXPECT_NEAR(more.lowerBound, 0.890, 2e-3);
    EXPECT_NEAR(more.upperBound, 1.116, 2e-3);
}

TEST(Consistency, OfARightFilter)
{
    std::mt19937_64 random(2);
    const Consistency c = consistencyOf(squaredErrors(20000, 3, 1.0, random), 3);
    EXPECT_EQ(c.count, 20000U);
    EXPECT_EQ(c.dimension, 3);
    EXPECT_NEAR(c.mean, 1.0, 0.02);
    EXPECT_NEAR(c.median, 2.366, 0.06);
    EXPECT_NEAR(c.within68, 0.68, 0.012);
    EXPECT_NEAR(c.within95, 0.95, 0.006);
    EXPECT_NEAR(c.within99, 0.99, 0.003);
    EXPECT_NEAR(c.covarianceScale, 1.0, 0.03);
    EXPECT_EQ(verdictOf(c), Verdict::Consistent);
    EXPECT_THAT(inWords(c), StartsWith("consistent"));
}

TEST(Consistency, SaysWhichWayAFilterIsWrong)
{
    std::mt19937_64 random(3);
    const Consistency bold = consistencyOf(squaredErrors(5000, 3, 1.6, random), 3);
    EXPECT_NEAR(bold.covarianceScale, 2.56, 0.12);
    EXPECT_EQ(verdictOf(bold), Verdict::Overconfident);
    EXPECT_THAT(inWords(bold), StartsWith("overconfident: errors are 1.6"));

    const Consistency shy = consistencyOf(squaredErrors(5000, 3, 0.5, random), 3);
    EXPECT_NEAR(shy.covarianceScale, 0.25, 0.02);
    EXPECT_EQ(verdictOf(shy), Verdict::Underconfident);
    EXPECT_THAT(inWords(shy), HasSubstr("0.0 % of the values lie above the 99 % point"));

    // 15 % of variance are within the tolerance, whatever the number of values.
    const Consistency nearly = consistencyOf(squaredErrors(50000, 3, std::sqrt(1.15), random), 3);
    EXPECT_GT(nearly.mean, nearly.upperBound);
    EXPECT_EQ(verdictOf(nearly), Verdict::Consistent);
}

TEST(Consistency, AFewBlundersAreNotAWrongCovariance)
{
    std::mt19937_64 random(4);
    std::vector<double> values = squaredErrors(950, 3, 1.0, random);
    values.insert(values.end(), 50, 400.0);
    const Consistency c = consistencyOf(values, 3);
    EXPECT_GT(c.mean, 5.0);
    EXPECT_NEAR(c.covarianceScale, 1.1, 0.1);
    EXPECT_EQ(verdictOf(c), Verdict::HeavyTailed);
    EXPECT_THAT(inWords(c), HasSubstr(" as the filter says, but "));
}

TEST(Consistency, WhatIsNotFiniteIsOutside)
{
    std::vector<double> values(90, 1.0);
    values.push_back(std::numeric_limits<double>::quiet_NaN());
    values.push_back(std::numeric_limits<double>::infinity());
    values.insert(values.end(), 8, -1.0);
    const Consistency c = consistencyOf(values, 1);
    EXPECT_EQ(c.count, 100U);
    EXPECT_DOUBLE_EQ(c.mean, 1.0);
    EXPECT_DOUBLE_EQ(c.median, 1.0);
    EXPECT_DOUBLE_EQ(c.within99, 0.9);
    EXPECT_NE(verdictOf(c), Verdict::Consistent);
}

TEST(Consistency, OfVariancesOfZeroIsToldWithoutANumber)
{
    std::vector<double> values(20, 1.0);
    values.insert(values.end(), 20, -1.0);
    const Consistency c = consistencyOf(values, 1);
    EXPECT_EQ(verdictOf(c), Verdict::Overconfident);
    EXPECT_EQ(inWords(c),
              "overconfident: half of the errors or more have no covariance (a variance of 0); "
              "50.0 % of the values lie above the 99 % point (expected 1 %)");
}

TEST(Consistency, OfNothingAndOfLittle)
{
    const Consistency nothing = consistencyOf({}, 3);
    EXPECT_EQ(nothing.count, 0U);
    EXPECT_EQ(verdictOf(nothing), Verdict::TooFew);
    EXPECT_EQ(verdictOf(consistencyOf(std::vector<double>(29, 3.0), 3)), Verdict::TooFew);
    EXPECT_NE(verdictOf(consistencyOf(std::vector<double>(30, 3.0), 3)), Verdict::TooFew);
    EXPECT_THAT(inWords(nothing), StartsWith("too few values"));
}

}  // namespace
}  // namespace vdamf
