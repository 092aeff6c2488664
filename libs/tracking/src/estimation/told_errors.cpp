// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/told_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "estimation/fixed_point.h"

namespace vdamf
{
namespace
{
// Shares of jitter, along, across and of the heading, from which on errors are as large as the
// filter takes them to be; below, their variance is smaller in proportion. By simulated vehicles of
// several shapes over seeds; recorded ones have shares of 0.4 to 0.7 along and across.
constexpr std::array<double, 3> kUsualShares{0.5, 0.5, 1.0};

// What lasts of the measurements' errors is at least what the options say.
Eigen::Vector4d lackingOf(const Eigen::Matrix3d& lasting, const VisibilityOptions& options)
{
    const auto lacking = [](double least, double known)
    { return std::max(0.0, least * least - known); };
    const double position =
        lacking(options.lastingPosition, 0.5 * lasting.topLeftCorner<2, 2>().trace());
    return {position, position, lacking(options.lastingHeading, lasting(2, 2)), 0.0};
}

// How far hits that come again may turn a box, rad: as an end alone does. What tells less of the
// heading hardly moves the filter.
constexpr double kMostTurned = 1.5 * kPi / 180.0;

constexpr double kMostOfLength = 1.0;  // m^2: what is vaguer tells no length
}  // namespace

ToldErrors toldErrors(const BoxMeasurement& measurement, const JitterShares& shares, double repeats,
                      const ToldErrors& before)
{
    const Matrix5d whole = covarianceAtFixedPoint(measurement);
    const Matrix5d filters = covarianceAtFixedPoint(withJitterAlone(measurement, shares));
    ToldErrors errors;
    errors.fixedPoint = measurement.fixedPoint;
    Eigen::Vector3d lasting;
    for (Eigen::Index k = 0; k < 3; ++k)
    {
        const double seen =
            std::min(1.0, shares.values()(k) / kUsualShares[static_cast<std::size_t>(k)]);
        // Hits that come again show nothing of the errors that they share.
        const double share = seen + repeats * (1.0 - seen);
        errors.ofFilters(k) = std::min(1.0, share * whole(k, k) / filters(k, k));
        lasting(k) = share * std::min(1.0, mostLasting(k) / whole(k, k));
    }
    // And they turn the box alike.
    const double turned = std::min(1.0, kMostTurned * kMostTurned / whole(2, 2));
    lasting(2) += repeats * std::max(0.0, turned - lasting(2));
    const bool tellsLength = whole(3, 3) < kMostOfLength;
    errors.repeatedLength = repeats * (tellsLength ? whole(3, 3) : before.repeatedLength);
    errors.lasting = scaled(measurement, whole, lasting.cwiseSqrt(), 0.0).topLeftCorner<3, 3>();
    return errors;
}

double toldLengthVariance(const VehicleState& state, const ToldErrors& errors,
                          const VisibilityOptions& options)
{
    constexpr double kTaper = 0.02;  // of the length
    const double lasting = std::max(options.lastingSize, kTaper * state.mean(kLength));
    return std::max(state.covariance(kLength, kLength), errors.repeatedLength) + lasting * lasting;
}

Eigen::Matrix4d toldCovariance(const VehicleState& state, const ToldErrors& errors,
                               const VisibilityOptions& options)
{
    Vector5d box;
    box << state.mean.head<3>(), state.size();
    Vector5d factors = Vector5d::Ones();
    factors.head<3>() = errors.ofFilters.cwiseSqrt();
    const Matrix5d less = fromFixedPoint(box, errors.fixedPoint) * factors.asDiagonal() *
                          toFixedPoint(box, errors.fixedPoint);
    StateMatrix change = StateMatrix::Identity();
    change.topLeftCorner<3, 3>() = less.topLeftCorner<3, 3>();
    change.block<3, 1>(0, kLength) = less.block<3, 1>(0, 3);
    Eigen::Matrix4d covariance =
        (change * state.covariance * change.transpose()).topLeftCorner<4, 4>();
    // The centre errs by half of what the length does, and of what the width does where it is held
    // at a side.
    const Eigen::Matrix2d axes = rotation(state.mean(kHeading));
    const double ofLength =
        toldLengthVariance(state, errors, options) - state.covariance(kLength, kLength);
    const Eigen::Vector2d bySize(0.25 * ofLength,
                                 0.25 * std::pow(errors.fixedPoint.y(), 2) * state.widthVariance);
    covariance.topLeftCorner<2, 2>() += axes * bySize.asDiagonal() * axes.transpose();
    covariance.topLeftCorner<3, 3>() += errors.lasting;
    covariance.diagonal() += lackingOf(errors.lasting, options);
    return covariance;
}

}  // namespace vdamf
