// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/box_measurement.h"

#include <Eigen/Cholesky>

namespace vdamf
{
namespace
{
struct FixedPoint
{
    Eigen::Vector3d value;              // its place and the heading
    Eigen::Matrix<double, 3, 5> byBox;  // d value / d (x, y, heading, length, width)
};

// Of a box (x, y, heading, length, width).
FixedPoint fixedPointOf(const Vector5d& box, const Eigen::Vector2d& at)
{
    const Eigen::Matrix2d r = rotation(box(2));
    const Eigen::Vector2d offset = 0.5 * at.cwiseProduct(box.tail<2>());
    FixedPoint point{box.head<3>(), Eigen::Matrix<double, 3, 5>::Zero()};
    point.value.head<2>() += r * offset;
    point.byBox.leftCols<3>().setIdentity();
    point.byBox.block<2, 1>(0, 2) = r * Eigen::Vector2d(-offset.y(), offset.x());
    point.byBox.block<2, 2>(0, 3) = r * (0.5 * at).asDiagonal();
    return point;
}
}  // namespace

BoxMeasurement withKnown(const BoxMeasurement& measurement, Eigen::Index row, double value,
                         double variance)
{
    BoxMeasurement m = measurement;
    const Vector5d gain =
        measurement.covariance.col(row) / (measurement.covariance(row, row) + variance);
    m.box += gain * (value - measurement.box(row));
    m.covariance -= gain * measurement.covariance.row(row);
    return m;
}

double Innovation::nis() const
{
    return value.dot(covariance.ldlt().solve(value));
}

Innovation innovationOf(const VehicleState& state, const BoxMeasurement& measurement)
{
    Matrix5d p = Matrix5d::Zero();
    p.topLeftCorner<3, 3>() = state.covariance.topLeftCorner<3, 3>();
    p.block<3, 1>(0, 3) = state.covariance.block<3, 1>(0, kLength);
    p.block<1, 3>(3, 0) = state.covariance.block<1, 3>(kLength, 0);
    p(3, 3) = state.covariance(kLength, kLength);
    p(4, 4) = state.widthVariance;
    Vector5d box;
    box << state.mean.head<3>(), state.size();
    const FixedPoint foretold = fixedPointOf(box, measurement.fixedPoint);
    // Each by its own axes: what the measurement does not tell across its faces must not seem to be
    // unknown along them.
    const FixedPoint measured = fixedPointOf(measurement.box, measurement.fixedPoint);
    Eigen::Vector3d difference = measured.value - foretold.value;
    difference(2) = wrapAngle(difference(2));
    return {difference, foretold.byBox * p * foretold.byBox.transpose() +
                            measured.byBox * measurement.covariance * measured.byBox.transpose()};
}

}  // namespace vdamf
