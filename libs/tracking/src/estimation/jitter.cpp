// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/jitter.h"

#include <algorithm>
#include <cmath>

#include "estimation/fixed_point.h"

namespace vdamf
{
namespace
{
constexpr double kJitterMemory = 1.5;  // s
// Of the variance: errors that last for some frames look like no error at all.
constexpr double kLeastOfPlace = 0.1;
constexpr double kLeastOfHeading = 0.3;
constexpr double kSurprise = 4.0;  // of one measurement, over its variance, at most

Eigen::Vector3d shareOfJitter(const Matrix5d& atFixedPoint, const JitterShares& shares)
{
    Eigen::Vector3d share = shares.values();
    for (Eigen::Index k = 0; k < 3; ++k)
    {
        share(k) = std::max(share(k), 1.0 - mostLasting(k) / atFixedPoint(k, k));
    }
    return share;
}

// Fixed point along and across and heading of an innovation.
Innovation inBody(const Innovation& innovation, double heading)
{
    Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
    r.topLeftCorner<2, 2>() = rotation(-heading);
    return {r * innovation.value, r * innovation.covariance * r.transpose()};
}
}  // namespace

double mostLasting(Eigen::Index row)
{
    constexpr double kPlace = 0.05;     // m
    constexpr double kHeading = 0.006;  // rad
    return row == 2 ? kHeading * kHeading : kPlace * kPlace;
}

JitterShares JitterShares::after(const VehicleState& predicted, const BoxMeasurement& measurement,
                                 double dt) const
{
    const double heading = measurement.box(2);
    const PlacedPoint measured = measuredPoint(measurement);
    const Innovation innovation =
        innovationOf(foretoldPoint(predicted, measurement.fixedPoint), measured);
    const Innovation whole = inBody(innovation, heading);
    const Innovation fit = inBody({innovation.value, measured.covariance}, heading);
    JitterShares next = *this;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
        const double least = k == 2 ? kLeastOfHeading : kLeastOfPlace;
        const double variance = fit.covariance(k, k);
        const double seen = fit.value(k) * fit.value(k) / variance;
        // Of what is seen, the prediction's error is to be expected.
        const double expected = whole.covariance(k, k) / variance - 1.0;
        const double share = std::min(seen, kSurprise) - expected;
        // A vague prediction tells little of the measurement.
        const double weight = (1.0 - std::exp(-dt / kJitterMemory)) / std::pow(1.0 + expected, 2);
        next.shares_(k) = std::clamp(shares_(k) + weight * (share - shares_(k)), least, 1.0);
    }
    return next;
}

BoxMeasurement withJitterAlone(const BoxMeasurement& measurement, const JitterShares& shares)
{
    const Matrix5d whole = covarianceAtFixedPoint(measurement);
    BoxMeasurement m = measurement;
    m.covariance = scaled(measurement, whole, shareOfJitter(whole, shares).cwiseSqrt(), 1.0);
    return m;
}

Eigen::Matrix3d lastingError(const BoxMeasurement& measurement, const JitterShares& shares)
{
    const Matrix5d whole = covarianceAtFixedPoint(measurement);
    const Eigen::Vector3d rest = Eigen::Vector3d::Ones() - shareOfJitter(whole, shares);
    return scaled(measurement, whole, rest.cwiseSqrt(), 0.0).topLeftCorner<3, 3>();
}

}  // namespace vdamf
