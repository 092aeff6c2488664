// SPDX-License-Identifier: BSD-3-Clause
// bestAssignment() against all assignments there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "vdamf/evaluation/matching.h"

namespace vdamf
{
namespace
{
using Scores = std::vector<std::vector<double>>;

/// The sum of an assignment's scores; fails where a column is used twice or a pair is worth
/// nothing.
double checkedSum(const Scores& scores, const std::vector<int>& columns)
{
    EXPECT_EQ(columns.size(), scores.size());
    std::vector<int> used;
    double sum = 0.0;
    for (std::size_t row = 0; row < scores.size(); ++row)
    {
        if (columns[row] < 0) continue;
        const double score = scores[row].at(static_cast<std::size_t>(columns[row]));
        EXPECT_GT(score, 0.0);
        EXPECT_EQ(std::count(used.begin(), used.end(), columns[row]), 0);
        used.push_back(columns[row]);
        sum += score;
    }
    return sum;
}

/// The highest sum with the rows from `row` on, by trying everything.
double highestSum(const Scores& scores, std::size_t row, std::vector<bool> used)
{
    if (row == scores.size()) return 0.0;
    double best = highestSum(scores, row + 1, used);
    for (std::size_t column = 0; column < used.size(); ++column)
    {
        if (used[column]) continue;
        used[column] = true;
        best = std::max(best, scores[row][column] + highestSum(scores, row + 1, used));
        used[column] = false;
    }
    return best;
}

Scores randomScores(std::mt19937_64& random, std::size_t rows, std::size_t columns)
{
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    std::uniform_int_distribution<int> kind(0, 3);
    Scores scores(rows, std::vector<double>(columns));
    for (std::vector<double>& row : scores)
    {
        // Zeros, ties and values that outweigh many others.
        const auto value = [&]
        {
            switch (kind(random))
            {
                case 0:
                    return 0.0;
                case 1:
                    return 0.5;
                case 2:
                    return 8.0 + any(random);
                default:
                    return any(random);
            }
        };
        std::generate(row.begin(), row.end(), value);
    }
    return scores;
}

TEST(BestAssignment, IsTheBestOfAll)
{
    std::mt19937_64 random(11);
    std::uniform_int_distribution<std::size_t> upTo6(1, 6);
    for (int i = 0; i < 400; ++i)
    {
        const Scores scores = randomScores(random, upTo6(random), upTo6(random));
        const double best = highestSum(scores, 0, std::vector<bool>(scores[0].size(), false));
        EXPECT_NEAR(checkedSum(scores, bestAssignment(scores)), best, 1e-12);
    }
    const Scores seven = randomScores(random, 7, 7);
    EXPECT_NEAR(checkedSum(seven, bestAssignment(seven)),
                highestSum(seven, 0, std::vector<bool>(7, false)), 1e-12);
}

TEST(BestAssignment, SmallCases)
{
    EXPECT_TRUE(bestAssignment({}).empty());
    EXPECT_EQ(bestAssignment({{}, {}}), (std::vector<int>{-1, -1}));
    EXPECT_EQ(bestAssignment({{0.0}}), (std::vector<int>{-1}));
    EXPECT_EQ(bestAssignment({{-1.0, 0.5}}), (std::vector<int>{1}));
    EXPECT_EQ(bestAssignment({{0.5}, {0.6}, {0.0}}), (std::vector<int>{-1, 0, -1}));
    // The best single pair (0, 0) must stand back: 3 < 2 + 2.
    EXPECT_EQ(bestAssignment({{3.0, 2.0}, {2.0, 0.0}}), (std::vector<int>{1, 0}));
    // Two rows want one column, and a third pair is worth nothing.
    EXPECT_EQ(bestAssignment({{2.0, -1.0}, {1.0, -1.0}}), (std::vector<int>{0, -1}));
}

TEST(BestAssignment, LargeTablesFindAHiddenPermutation)
{
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> less(0.0, 0.9);
    std::vector<int> hidden(200);
    std::iota(hidden.begin(), hidden.end(), 0);
    std::shuffle(hidden.begin(), hidden.end(), random);
    Scores scores(200, std::vector<double>(200));
    for (std::size_t row = 0; row < 200; ++row)
    {
        for (double& score : scores[row]) score = less(random);
        scores[row][static_cast<std::size_t>(hidden[row])] = 1.0;
    }
    EXPECT_EQ(bestAssignment(scores), hidden);
}

}  // namespace
}  // namespace vdamf
