// SPDX-License-Identifier: BSD-3-Clause
// One size for all of a track's frames.
#include "hindsight/one_size.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tracking/hindsight/example_history.h"

namespace vdamf
{
namespace
{
TEST(OneSize, IsTheOneKnownBestAndWhatWasMeasuredStays)
{
    // Its rear and left side are seen; how long it is only in the end.
    TrackHistory history = standingCar(10);
    for (std::size_t k = 0; k < 5; ++k)
    {
        TrackReport& report = history[k].report;
        report.box.length = 4.0;
        report.box.width = 1.7;
        report.lengthVariance = 0.4;
        report.covariance(0, 0) = 0.12;
    }
    const TrackHistory told = withOneSize(history);
    for (std::size_t k = 0; k < history.size(); ++k)
    {
        EXPECT_EQ(told[k].report.box.length, 4.4) << k;
        EXPECT_EQ(told[k].report.box.width, 1.8);
        EXPECT_EQ(told[k].report.lengthVariance, 0.01);
        EXPECT_LT((heldPlace(told[k].report) - heldPlace(history[k].report)).norm(), 1e-12);
    }
    EXPECT_LT(told[0].report.covariance(0, 0), history[0].report.covariance(0, 0));
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(told[0].report.covariance);
    EXPECT_GT(eigen.eigenvalues()(0), 0.0);
}

TEST(OneSize, OthersHitsForAWhileTellNothing)
{
    TrackHistory history = standingCar(20);
    for (std::size_t k = 14; k < 20; ++k) history[k].report.box.length = 9.0;
    for (const TrackMoment& moment : withOneSize(history)) EXPECT_EQ(moment.report.box.length, 4.4);
}

TEST(OneSize, GrowsToTheLastWordOfThoseThatAgree)
{
    TrackHistory history = standingCar(20);
    for (std::size_t k = 0; k < 20; ++k)
        history[k].report.box.length = 4.3 + 0.005 * static_cast<double>(k);
    EXPECT_EQ(withOneSize(history)[0].report.box.length, history[19].report.box.length);
}

TEST(OneSize, IsNotTakenFromWhereNothingTellsIt)
{
    TrackHistory history = standingCar(4);
    history[1].report.status = TrackStatus::Tentative;
    history[2].wasAcross = true;
    history[3].report.points = 0;
    for (std::size_t k = 1; k < 4; ++k)
    {
        history[k].report.box.length = 7.0;
        history[k].report.lengthVariance = 0.001;
    }
    for (const TrackMoment& moment : withOneSize(history)) EXPECT_EQ(moment.report.box.length, 4.4);
    history[0].report.points = 0;
    EXPECT_EQ(withOneSize(history)[3].report.box.length, 7.0) << "none: as it is";
    history[0].report.points = 30;
    history[0].report.isOfHits = true;
    EXPECT_EQ(withOneSize(history)[3].report.box.length, 7.0) << "that of its hits is none";
}
}  // namespace
}  // namespace vdamf
