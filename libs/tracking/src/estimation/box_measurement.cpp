// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/box_measurement.h"

#include "estimation/fixed_point.h"
#include "types/cholesky.h"

namespace vdamf
{
namespace
{
// Of a box (x, y, heading, length, width) with its covariance, where on it the point is being
// known: by its own axes, for what a measurement does not tell across its faces must not seem to be
// unknown along them.
PlacedPoint placedPoint(const Vector5d& box, const Matrix5d& covariance, const Eigen::Vector2d& at)
{
    const Eigen::Matrix2d r = rotation(box(2));
    const Eigen::Vector2d offset = offsetOfFixedPoint(box, at);
    // Rows x and y of d point / d (heading, length, width); by the place itself it is the identity.
    Eigen::Matrix<double, 2, 3> byRest;
    byRest.col(0) = r * Eigen::Vector2d(-offset.y(), offset.x());
    byRest.rightCols<2>() = r * (0.5 * at).asDiagonal();
    const Eigen::Matrix<double, 2, 3> withRest =
        covariance.topRightCorner<2, 3>() + byRest * covariance.bottomRightCorner<3, 3>();
    PlacedPoint point{box.head<3>(), {}};
    point.value.head<2>() += r * offset;
    const Eigen::Matrix2d cross = byRest * covariance.bottomLeftCorner<3, 2>();
    point.covariance.topLeftCorner<2, 2>() =
        covariance.topLeftCorner<2, 2>() + cross + withRest * byRest.transpose();
    point.covariance.topRightCorner<2, 1>() = withRest.col(0);
    point.covariance.bottomLeftCorner<1, 2>() = withRest.col(0).transpose();
    point.covariance(2, 2) = covariance(2, 2);
    return point;
}
}  // namespace

BoxMeasurement withKnown(const BoxMeasurement& measurement, Eigen::Index row, double value,
                         double variance)
{
    const Matrix5d at = covarianceAtFixedPoint(measurement);
    const Vector5d gain = at.col(row) / (at(row, row) + variance);
    const Vector5d change = gain * (value - measurement.box(row));
    BoxMeasurement m = measurement;
    m.box.tail<3>() += change.tail<3>();
    const Eigen::Vector2d before = offsetOfFixedPoint(measurement.box, m.fixedPoint);
    const Eigen::Vector2d after = offsetOfFixedPoint(m.box, m.fixedPoint);
    m.box.head<2>() +=
        rotation(measurement.box(2)) * (before + change.head<2>()) - rotation(m.box(2)) * after;
    m.box(2) = wrapAngle(m.box(2));
    const Matrix5d back = fromFixedPoint(m.box, m.fixedPoint);
    m.covariance = back * (at - gain * at.row(row)) * back.transpose();
    return m;
}

double Innovation::nis() const
{
    return Cholesky<3>(covariance).squaredNorm(value);
}

PlacedPoint foretoldPoint(const VehicleState& state, const Eigen::Vector2d& fixedPoint)
{
    Matrix5d p = Matrix5d::Zero();
    p.topLeftCorner<3, 3>() = state.covariance.topLeftCorner<3, 3>();
    p.block<3, 1>(0, 3) = state.covariance.block<3, 1>(0, kLength);
    p.block<1, 3>(3, 0) = state.covariance.block<1, 3>(kLength, 0);
    p(3, 3) = state.covariance(kLength, kLength);
    p(4, 4) = state.widthVariance;
    Vector5d box;
    box << state.mean.head<3>(), state.size();
    return placedPoint(box, p, fixedPoint);
}

PlacedPoint measuredPoint(const BoxMeasurement& measurement)
{
    return placedPoint(measurement.box, measurement.covariance, measurement.fixedPoint);
}

Innovation innovationOf(const PlacedPoint& foretold, const PlacedPoint& measured)
{
    Eigen::Vector3d difference = measured.value - foretold.value;
    difference(2) = wrapAngle(difference(2));
    return {difference, foretold.covariance + measured.covariance};
}

Innovation innovationOf(const VehicleState& state, const BoxMeasurement& measurement)
{
    return innovationOf(foretoldPoint(state, measurement.fixedPoint), measuredPoint(measurement));
}

}  // namespace vdamf
