// SPDX-License-Identifier: BSD-3-Clause
// How sure a track says that it is of its pose, over many vehicles that err as frames show.
#include "vdamf/tracking/estimation/told_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tracking/decompositions.h"

namespace vdamf
{
namespace
{
constexpr double kTowards = 0.4;  // rad

// Of a rear end: the fit does not say where across the row of hits may go on, nor the length.
BoxMeasurement rearEndAhead()
{
    BoxMeasurement m;
    m.box << 10.0, 2.0, kTowards, 4.4, 1.8;
    m.fixedPoint << -1.0, 0.0;
    const Eigen::Matrix2d r = rotation(kTowards);
    Vector5d byTurn;
    byTurn << 2.2 * r.col(1), 1.0, 0.0, 0.0;  // about the rear end
    Vector5d byLength;
    byLength << 0.5 * r.col(0), 0.0, 1.0, 0.0;
    m.covariance.topLeftCorner<2, 2>() =
        r * Eigen::Vector2d(2.5e-3, 1e-2).asDiagonal() * r.transpose();
    m.covariance += 7e-4 * byTurn * byTurn.transpose() + 100.0 * byLength * byLength.transpose();
    m.covariance(4, 4) += 0.01;
    return m;
}

VehicleState standing(const BoxMeasurement& m, double lengthSigma)
{
    VehicleState s;
    s.mean << m.box.head<3>(), 0.0, 0.0, 1.2, m.box(3);
    s.covariance.diagonal() << 1.0, 1.0, 0.1, 0.0, 0.0, 0.1, lengthSigma * lengthSigma;
    s.width = m.box(4);
    s.widthVariance = 1e-4;
    return s;
}

JitterShares sharesAfter(const BoxMeasurement& exact, double share, std::mt19937_64& generator)
{
    std::normal_distribution<double> gauss;
    VehicleState known = standing(exact, 1e-3);
    known.covariance.diagonal().head<3>().setConstant(1e-9);
    JitterShares shares;
    for (int k = 0; k < 100; ++k)
    {
        BoxMeasurement m = exact;
        const double turn = gauss(generator) * std::sqrt(share * 7e-4);
        m.box.head<2>() += rotation(kTowards) *
                           Eigen::Vector2d(gauss(generator) * std::sqrt(share * 2.5e-3),
                                           gauss(generator) * std::sqrt(share * 1e-2) + 2.2 * turn);
        m.box(2) += turn;
        shares = shares.after(known, m, 0.1);
    }
    return shares;
}

// Told of a filter that has averaged all but a tenth of the jitter that it reckons with.
Eigen::Matrix3d toldAfter(const BoxMeasurement& exact, const JitterShares& shares, double repeats)
{
    VehicleState s = standing(exact, 1e-3);
    s.covariance.topLeftCorner<3, 3>() =
        0.1 * withJitterAlone(exact, shares).covariance.topLeftCorner<3, 3>();
    return toldCovariance(s, toldErrors(exact, shares, repeats), VisibilityOptions{})
        .topLeftCorner<3, 3>();
}

TEST(ToldErrors, OfManyVehiclesAreAsLargeAsTheirErrors)
{
    std::mt19937_64 generator{11};
    std::normal_distribution<double> gauss;
    for (const double share : {0.12, 0.35, 0.9})
    {
        double sum = 0.0;
        constexpr int kVehicles = 300;
        for (int k = 0; k < kVehicles; ++k)
        {
            const BoxMeasurement exact = rearEndAhead();
            const JitterShares shares = sharesAfter(exact, share, generator);
            // What is left of the jitter, and what lasts: each in proportion to what is seen.
            const double places = std::min(1.0, 2.0 * share);
            const double turns = std::max(0.3, share);
            const Eigen::Vector2d place(
                gauss(generator) * std::sqrt(places * (0.1 * 2.5e-3 + 2.5e-3)),
                gauss(generator) * std::sqrt(places * (0.1 * 1e-2 + 2.5e-3)));
            const double turn = gauss(generator) * std::sqrt(turns * (0.1 * 7e-4 + 3.6e-5));
            Eigen::Vector3d error;
            error << rotation(kTowards) * (place + Eigen::Vector2d(0.0, 2.2 * turn)), turn;
            // Beside those, lengths err by 10 cm where they seem to be known.
            error.head<2>() += rotation(kTowards).col(0) * 0.05 * gauss(generator);
            sum += squaredMahalanobis(error, toldAfter(exact, shares, 0.0)) / 3.0;
        }
        EXPECT_NEAR(sum / kVehicles, 1.0, 0.3) << share;
    }
}

TEST(ToldErrors, OfHitsThatComeAgainIsTheWholeHeading)
{
    const BoxMeasurement exact = rearEndAhead();
    std::mt19937_64 generator{3};
    const JitterShares shares = sharesAfter(exact, 0.1, generator);
    EXPECT_LT(toldAfter(exact, shares, 0.0)(2, 2), 0.1 * exact.covariance(2, 2));
    const double told = toldAfter(exact, shares, 1.0)(2, 2);
    EXPECT_NEAR(told, std::pow(1.5 * kPi / 180.0, 2), 1e-4);
    const auto along = [](const Eigen::Matrix3d& lasting)
    {
        return Eigen::Vector2d(rotation(kTowards).col(0))
            .dot(lasting.topLeftCorner<2, 2>() * rotation(kTowards).col(0));
    };
    EXPECT_LT(along(toldErrors(exact, shares, 0.0).lasting), 0.4 * 2.5e-3);
    EXPECT_NEAR(along(toldErrors(exact, shares, 1.0).lasting), 2.5e-3, 1e-4);
    BoxMeasurement shapeless = exact;
    shapeless.covariance(2, 2) += 0.06;
    EXPECT_LT(toldErrors(shapeless, shares, 1.0).lasting(2, 2), 7e-4) << "hardly moves the filter";
}

TEST(ToldErrors, DoNotTouchWhatIsHidden)
{
    const BoxMeasurement exact = rearEndAhead();
    std::mt19937_64 generator{5};
    const ToldErrors errors = toldErrors(exact, sharesAfter(exact, 0.1, generator), 0.0);
    VehicleState s = standing(exact, 0.6);
    StateVector byLength = StateVector::Zero();
    byLength.head<2>() = 0.5 * rotation(kTowards).col(0);
    byLength(kLength) = 1.0;
    s.covariance = 0.36 * byLength * byLength.transpose();
    s.covariance.diagonal().head<3>() += Eigen::Vector3d(1e-4, 1e-4, 1e-4);
    const Eigen::Matrix4d told = toldCovariance(s, errors, VisibilityOptions{});
    const Eigen::Vector2d along = rotation(kTowards).col(0);
    EXPECT_NEAR(std::sqrt(along.dot(told.topLeftCorner<2, 2>() * along)), 0.3, 0.02);
    EXPECT_GE(smallestEigenvalue(told), 0.0);
}

TEST(ToldErrors, OfLongVehiclesGrowWithTheLength)
{
    const VisibilityOptions options;
    const auto lasting = [&](double length)
    {
        VehicleState s = standing(rearEndAhead(), 0.3);
        s.mean(kLength) = length;
        return std::sqrt(toldLengthVariance(s, ToldErrors{}, options) - 0.09);
    };
    EXPECT_NEAR(lasting(4.5), options.lastingSize, 1e-9);
    EXPECT_NEAR(lasting(25.0), 0.5, 1e-9);
    // Half of it is the centre's, along.
    VehicleState tram = standing(rearEndAhead(), 0.01);
    const Eigen::Matrix4d asACar = toldCovariance(tram, ToldErrors{}, options);
    tram.mean(kLength) = 25.0;
    const Eigen::Matrix4d more = toldCovariance(tram, ToldErrors{}, options) - asACar;
    const Eigen::Vector2d along = rotation(kTowards).col(0);
    const Eigen::Vector2d across = rotation(kTowards).col(1);
    EXPECT_NEAR(along.dot(more.topLeftCorner<2, 2>() * along), 0.25 * (0.25 - 0.01), 1e-6);
    EXPECT_NEAR(across.dot(more.topLeftCorner<2, 2>() * across), 0.0, 1e-6);
}

TEST(ToldErrors, OfAFarEndSeenAgainAreThoseOfOneFrame)
{
    const VisibilityOptions options;
    const double lasting = options.lastingSize * options.lastingSize;
    BoxMeasurement m = rearEndAhead();
    m.covariance(3, 3) -= 100.0 - 0.04;  // with a side in view
    const VehicleState s = standing(m, 0.05);
    const auto variance = [&](double repeats)
    { return toldLengthVariance(s, toldErrors(m, JitterShares(), repeats), options) - lasting; };
    EXPECT_NEAR(variance(0.0), 0.0025, 1e-9);
    EXPECT_NEAR(variance(1.0), m.covariance(3, 3), 1e-9);
    // Of an end alone no frame tells the length.
    const ToldErrors unseen = toldErrors(rearEndAhead(), JitterShares(), 1.0);
    EXPECT_NEAR(toldLengthVariance(s, unseen, options) - lasting, 0.0025, 1e-9);
    // It stays as it was while the next frames show no far end.
    const ToldErrors before = toldErrors(m, JitterShares(), 1.0);
    const ToldErrors after = toldErrors(rearEndAhead(), JitterShares(), 1.0, before);
    EXPECT_DOUBLE_EQ(after.repeatedLength, before.repeatedLength);
}

TEST(ToldErrors, OfANewTrackAreItsStates)
{
    const VehicleState s = standing(rearEndAhead(), 0.5);
    const Eigen::Matrix4d told = toldCovariance(s, ToldErrors{}, VisibilityOptions{});
    const Eigen::Matrix4d more = told - s.covariance.topLeftCorner<4, 4>();
    EXPECT_GE(smallestEigenvalue(more), -1e-12);
    EXPECT_LT(more.trace(), 0.01);
}

}  // namespace
}  // namespace vdamf
