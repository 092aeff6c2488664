// SPDX-License-Identifier: BSD-3-Clause
// Errors of measured boxes, told apart into jitter and what lasts.
#include "vdamf/tracking/estimation/jitter.h"

#include <gtest/gtest.h>

#include <random>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
// Of a rear end: its place and the heading are told, the length is not.
BoxMeasurement rearEnd()
{
    BoxMeasurement m;
    m.box << 10.0, 2.0, 0.4, 4.4, 1.8;
    m.fixedPoint << -1.0, 0.0;
    const Eigen::Matrix2d r = rotation(0.4);
    Vector5d byLength = Vector5d::Zero();
    byLength.head<2>() = 0.5 * r.col(0);
    byLength(3) = 1.0;
    Vector5d pose;
    pose << 0.01, 0.01, 4e-4, 0.0, 0.01;
    m.covariance = pose.asDiagonal();
    m.covariance += 100.0 * byLength * byLength.transpose();
    return m;
}

VehicleState foretold(const BoxMeasurement& m)
{
    VehicleState s;
    s.mean << m.box(0), m.box(1), m.box(2), 8.0, 0.0, 1.2, m.box(3);
    s.covariance.diagonal() << 1e-6, 1e-6, 1e-8, 0.01, 1e-4, 0.1, 1e-6;
    s.width = m.box(4);
    s.widthVariance = 1e-6;
    return s;
}

TEST(Jitter, SharesFollowWhatChangesFromFrameToFrame)
{
    const BoxMeasurement exact = rearEnd();
    std::mt19937_64 generator{7};
    std::normal_distribution<double> gauss;
    JitterShares shares;
    for (int k = 0; k < 200; ++k)
    {
        BoxMeasurement m = exact;
        m.box.head<2>() += 0.05 * gauss(generator) * rotation(0.4).col(0);  // of a sigma of 0.1
        m.box(2) += 0.018 * gauss(generator);                               // of 0.02
        shares = shares.after(foretold(exact), m, 0.1);
    }
    EXPECT_NEAR(shares.values()(0), 0.25, 0.15);
    EXPECT_LT(shares.values()(1), 0.3);  // by the heading's
    EXPECT_NEAR(shares.values()(2), 0.8, 0.4);
}

TEST(Jitter, AVagueForecastTellsNothingOfIt)
{
    VehicleState vague = foretold(rearEnd());
    vague.covariance.diagonal().head<2>().setConstant(100.0);
    vague.covariance(kHeading, kHeading) = 10.0;
    const Eigen::Vector3d shares = JitterShares().after(vague, rearEnd(), 0.1).values();
    EXPECT_GT(shares.minCoeff(), 0.99);
}

TEST(Jitter, IsWhatTheFixedPointShows)
{
    const BoxMeasurement whole = rearEnd();
    JitterShares shares;
    for (int k = 0; k < 200; ++k) shares = shares.after(foretold(whole), whole, 0.1);
    const BoxMeasurement jitter = withJitterAlone(whole, shares);
    EXPECT_NEAR(jitter.covariance(3, 3), whole.covariance(3, 3), 1e-6);
    const VehicleState exact = foretold(whole);
    const Eigen::Matrix3d before = innovationOf(exact, whole).covariance;
    const Eigen::Matrix3d after = innovationOf(exact, jitter).covariance;
    EXPECT_LT(after(0, 0), 0.8 * before(0, 0));
    EXPECT_LT(after(2, 2), 0.95 * before(2, 2));
    // The rest is what lasts.
    const Eigen::Matrix3d rest = lastingError(whole, shares);
    EXPECT_GT(smallestEigenvalue(rest), 0.0);
    EXPECT_NEAR(rest(2, 2) + jitter.covariance(2, 2), whole.covariance(2, 2), 1e-9);
    EXPECT_LT(rest(0, 0), 0.05) << "the length is no part of it";
}

TEST(Jitter, AllOfItIsTheMeasurementItself)
{
    const BoxMeasurement whole = rearEnd();
    EXPECT_LT((withJitterAlone(whole, JitterShares()).covariance - whole.covariance).norm(), 1e-9);
    EXPECT_LT(lastingError(whole, JitterShares()).norm(), 1e-9);
}

}  // namespace
}  // namespace vdamf
