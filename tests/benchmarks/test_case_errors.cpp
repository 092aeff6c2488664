// SPDX-License-Identifier: BSD-3-Clause
// Errors of estimates, their figures, and the samples they are measured on.
#include <gtest/gtest.h>

#include <cmath>

#include "vdamf/learning/clusters/case_errors.h"
#include "vdamf/learning/clusters/case_summary.h"
#include "vdamf/learning/clusters/simulated_clusters.h"

namespace vdamf
{
namespace
{
// Seen from the origin: back and right.
LabelledCluster exampleSample()
{
    LabelledCluster sample;
    sample.truth = {14.0, 3.0, 0.6, 4.4, 1.8};
    sample.inView.add(Face::Back);
    sample.inView.add(Face::Right);
    return sample;
}

Estimate estimateOf(const OrientedBox& box)
{
    Measurement m;
    m.box = box;
    m.covariance.diagonal() << 0.01, 0.01, 1e-4, 0.04, 0.04;
    m.facesSeen.add(Face::Back);
    m.facesSeen.add(Face::Right);
    m.converged = true;
    return {box, m};
}

OrientedBox movedInBox(const OrientedBox& box, double x, double y)
{
    OrientedBox moved = box;
    const Eigen::Vector2d step = rotation(box.heading) * Eigen::Vector2d(x, y);
    moved.x += step.x();
    moved.y += step.y();
    return moved;
}

TEST(CaseErrors, TheTrueBoxHasNone)
{
    const LabelledCluster sample = exampleSample();
    const CaseErrors errors = errorsOf(estimateOf(sample.truth), sample);
    EXPECT_NEAR(errors.heading90, 0.0, 1e-9);
    EXPECT_NEAR(errors.corner, 0.0, 1e-9);
    EXPECT_NEAR(*errors.end, 0.0, 1e-9);
    EXPECT_NEAR(*errors.side, 0.0, 1e-9);
    EXPECT_NEAR(errors.iou, 1.0, 1e-9);
    EXPECT_NEAR(*errors.nees, 0.0, 1e-9);
    EXPECT_EQ(errors.neesDimension, 3);
    EXPECT_FALSE(errors.failed);
}

TEST(CaseErrors, FacesCountOutwardsAndAreNormalisedByTheirOwnVariance)
{
    const LabelledCluster sample = exampleSample();
    // The back 0.3 m too far out, the right side 0.1 m too far in.
    const OrientedBox moved = movedInBox(sample.truth, -0.3, 0.1);
    const CaseErrors errors = errorsOf(estimateOf(moved), sample);
    EXPECT_NEAR(*errors.end, 0.3, 1e-9);
    EXPECT_NEAR(*errors.side, -0.1, 1e-9);
    EXPECT_NEAR(errors.corner, std::hypot(0.3, 0.1), 1e-9);
    // A face's variance: that of the centre and a quarter of the size's.
    EXPECT_NEAR(*errors.nees, (0.09 + 0.01) / (0.01 + 0.01), 1e-9);
}

TEST(CaseErrors, AQuarterTurnIsACrossedBoxNotAHeadingError)
{
    const LabelledCluster sample = exampleSample();
    OrientedBox crossed = sample.truth;
    crossed.heading += 0.5 * kPi + 2.0 * kDegree;
    std::swap(crossed.length, crossed.width);
    const CaseErrors errors = errorsOf({crossed, std::nullopt}, sample);
    EXPECT_NEAR(errors.heading90, 2.0, 1e-9);
    EXPECT_NEAR(errors.heading180, 88.0, 1e-9);
    EXPECT_NEAR(*errors.length, 0.0, 1e-9);
    EXPECT_FALSE(errors.nees);
    EXPECT_NEAR(alignedTo(crossed, sample.truth.heading).length, sample.truth.length, 1e-12);
}

TEST(CaseErrors, AnUnseenEndDoesNotCountWhereverItIs)
{
    const LabelledCluster sample = exampleSample();
    OrientedBox shorter = movedInBox(sample.truth, -1.0, 0.0);
    shorter.length -= 2.0;
    const CaseErrors errors = errorsOf(estimateOf(shorter), sample);
    EXPECT_NEAR(*errors.end, 0.0, 1e-9);
    EXPECT_NEAR(*errors.nees, 0.0, 1e-9);
    EXPECT_NEAR(*errors.length, -2.0, 1e-9);
}

TEST(CaseErrors, WhatIsNotFiniteHasFailed)
{
    const LabelledCluster sample = exampleSample();
    OrientedBox broken = sample.truth;
    broken.x = std::nan("");
    const CaseErrors errors = errorsOf(estimateOf(broken), sample);
    EXPECT_TRUE(errors.failed);
    EXPECT_TRUE(std::isfinite(errors.heading90 + errors.corner + errors.iou));
}

TEST(SummaryOfCases, HasBiasMedianAndShares)
{
    std::vector<CaseErrors> cases(4);
    const double ends[] = {-0.1, 0.1, 0.3, 0.3};
    for (std::size_t i = 0; i < 4; ++i) cases[i].end = ends[i];
    cases[0].heading180 = 89.0;
    cases[1].nees = 3.0;
    cases[1].neesDimension = 3;
    cases[2].nees = 50.0;
    cases[2].neesDimension = 2;
    const CaseSummary summary = summaryOf(cases);
    EXPECT_NEAR(summary.end.bias, 0.2, 1e-12);
    EXPECT_NEAR(summary.end.median, 0.2, 1e-12);
    EXPECT_EQ(summary.side.count, 0U);
    EXPECT_TRUE(std::isnan(summary.side.median));
    EXPECT_NEAR(summary.crossed, 0.25, 1e-12);
    EXPECT_NEAR(summary.neesMean, 53.0 / 5.0, 1e-12);
    EXPECT_NEAR(summary.within99, 0.5, 1e-12);
    EXPECT_LT(summary.neesLow, 1.0);
    EXPECT_GT(summary.neesHigh, 1.0);
}

TEST(SimulatedConditions, AreWhatTheySay)
{
    for (const SimulatedKind& kind : simulatedKinds())
    {
        const LabelledClusters once = simulatedCondition(kind, 5, 7);
        const LabelledClusters again = simulatedCondition(kind, 5, 7);
        ASSERT_EQ(once.samples.size(), 5U) << kind.name;
        for (std::size_t i = 0; i < 5; ++i)
        {
            const LabelledCluster& sample = once.samples[i];
            EXPECT_GE(sample.cluster.size(), 10U) << kind.name;
            EXPECT_EQ(sample.cluster.x, again.samples[i].cluster.x) << kind.name;
            EXPECT_EQ(sample.start.heading, again.samples[i].start.heading) << kind.name;
            EXPECT_FALSE(kind.aspect == SimulatedKind::Aspect::End && sample.inView.seesSide());
            EXPECT_FALSE(kind.aspect == SimulatedKind::Aspect::Side && sample.inView.seesEnd());
        }
    }
}

TEST(SimulatedConditions, CleanHitsLieOnTheFacesInView)
{
    const LabelledClusters clean = simulatedCondition(simulatedKinds().front(), 20, 1);
    for (const LabelledCluster& sample : clean.samples)
    {
        for (std::size_t i = 0; i < sample.cluster.size(); ++i)
        {
            const Eigen::Vector2d p =
                toBoxFrame(sample.truth, {sample.cluster.x[i], sample.cluster.y[i]});
            const double toEnd = std::abs(std::abs(p.x()) - 0.5 * sample.truth.length);
            const double toSide = std::abs(std::abs(p.y()) - 0.5 * sample.truth.width);
            EXPECT_LT(std::min(toEnd, toSide), 0.16);  // five standard deviations
        }
    }
}
}  // namespace
}  // namespace vdamf
