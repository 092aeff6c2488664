// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/evaluation/error_summary.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vdamf
{
namespace
{
PoseError pairWith(double range, int points, const char* faces)
{
    PoseError error;
    error.range = range;
    error.points = points;
    for (const char* c = faces; *c != 0; ++c)
    {
        error.facesSeen.add(*c == 'F'   ? Face::Front
                            : *c == 'B' ? Face::Back
                            : *c == 'L' ? Face::Left
                                        : Face::Right);
    }
    return error;
}

std::vector<std::size_t> countsOf(const std::vector<ErrorGroup>& groups)
{
    std::vector<std::size_t> counts;
    for (const ErrorGroup& group : groups) counts.push_back(group.errors.pairs);
    return counts;
}

TEST(Statistics, OfFiveErrors)
{
    const ErrorStatistics s = statisticsOf({-4.0, 1.0, 2.0, -3.0, 10.0});
    EXPECT_EQ(s.count, 5U);
    EXPECT_DOUBLE_EQ(s.median, 3.0);  // of the sizes
    EXPECT_DOUBLE_EQ(s.p90, 4.0 + 0.6 * 6.0);
    EXPECT_DOUBLE_EQ(s.p95, 4.0 + 0.8 * 6.0);
    EXPECT_DOUBLE_EQ(s.max, 10.0);
    EXPECT_DOUBLE_EQ(s.rms, std::sqrt(26.0));
    EXPECT_DOUBLE_EQ(s.bias, 1.2);
    EXPECT_EQ(statisticsOf({}).count, 0U);
    EXPECT_DOUBLE_EQ(statisticsOf({-2.0}).p90, 2.0);
}

TEST(ErrorSummary, CountsWhatIsKnown)
{
    std::vector<PoseError> errors(4);
    errors[0].longitudinal = -0.3;
    errors[1].yawRate = 0.2;
    errors[2].flipped = true;
    errors[2].trueSpeed = 4.0;
    errors[3].flipped = true;
    errors[0].exchanged = errors[1].exchanged = true;
    errors[1].axesProbability = errors[2].axesProbability = 0.99;
    const ErrorSummary summary = summaryOf(errors);
    EXPECT_EQ(summary.pairs, 4U);
    EXPECT_EQ(summary.flips, 2U);
    EXPECT_EQ(summary.exchanged, 2U);
    EXPECT_EQ(summary.exchangedThoughSure, 1U);
    EXPECT_EQ(summary.frontShare(), 0.5);
    EXPECT_EQ(summaryOf({}).frontShare(), std::nullopt);
    EXPECT_EQ(flipsOfMoving(errors, 0.3), 1U);
    EXPECT_EQ(summary.longitudinal.count, 4U);
    EXPECT_DOUBLE_EQ(summary.longitudinal.bias, -0.075);
    EXPECT_EQ(summary.yawRate.count, 1U);
    EXPECT_EQ(summary.corner.count, 0U);
}

TEST(ErrorSummary, GroupsAreHalfOpenAndLeaveOutTheUnknown)
{
    std::vector<PoseError> errors = {pairWith(0.0, 0, ""),     pairWith(9.999, 19, "F"),
                                     pairWith(10.0, 20, "B"),  pairWith(20.0, 49, "LR"),
                                     pairWith(40.0, 50, "FL"), pairWith(59.9, 199, "BR"),
                                     pairWith(60.0, 200, "R"), pairWith(1e3, 5000, "FB")};
    errors.push_back(pairWith(0.0, -1, "F"));
    errors.back().range.reset();
    const double sigmas[] = {0.02, 0.2499, 0.25, 0.49, 0.5, 0.99, 1.0, 3.0};
    for (std::size_t k = 0; k < 8; ++k) errors[k].lengthSigma = sigmas[k];
    using Counts = std::vector<std::size_t>;
    EXPECT_EQ(countsOf(byRange(errors)), (Counts{2, 1, 1, 2, 2}));
    EXPECT_EQ(countsOf(byPoints(errors)), (Counts{2, 2, 2, 2}));
    EXPECT_EQ(countsOf(byFaces(errors)), (Counts{4, 2, 2, 1}));
    EXPECT_EQ(countsOf(byLengthSigma(errors)), (Counts{2, 2, 2, 2}));
}

TEST(ErrorSummary, PhantomSpeedIsThatOfStillObjects)
{
    std::vector<PoseError> errors(3);
    errors[0].trackSpeed = -0.4;
    errors[1].trueSpeed = -0.2;
    errors[1].trackSpeed = 0.2;
    errors[2].trueSpeed = 9.0;
    errors[2].trackSpeed = 9.0;
    const ErrorStatistics phantom = phantomSpeed(errors, 0.3);
    EXPECT_EQ(phantom.count, 2U);
    EXPECT_DOUBLE_EQ(phantom.max, 0.4);
    EXPECT_DOUBLE_EQ(phantom.median, 0.3);
}

TEST(ErrorSummary, ScatterIsAroundTheMeanPlaceOfEachTrack)
{
    std::vector<PoseError> errors(5);
    errors[0].longitudinal = 1.0;  // 0.1 from its mean, as the next one
    errors[1].longitudinal = 1.2;
    errors[2].trackId = 7;  // alone: a place of its own
    errors[2].lateral = -3.0;
    errors[3].objectId = "other";
    errors[4].trueSpeed = 9.0;
    errors[4].lateral = 50.0;
    const ErrorStatistics scatter = standingScatter(errors, 0.3);
    EXPECT_EQ(scatter.count, 4U);
    EXPECT_NEAR(scatter.max, 0.1, 1e-12);
    EXPECT_NEAR(scatter.rms, 0.1 / std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace vdamf
