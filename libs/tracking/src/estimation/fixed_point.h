// SPDX-License-Identifier: BSD-3-Clause
// Errors of a box (x, y, heading, length, width) as those of its fixed point along and across it,
// of its heading and of its sizes, and back: m and rad.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/estimation/box_measurement.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// From the centre to the fixed point, along and across the box, m.
inline Eigen::Vector2d offsetOfFixedPoint(const Vector5d& box, const Eigen::Vector2d& fixedPoint)
{
    return 0.5 * fixedPoint.cwiseProduct(box.tail<2>());
}

/// d (fixed point along and across, heading, length, width) / d (x, y, heading, length, width).
inline Matrix5d toFixedPoint(const Vector5d& box, const Eigen::Vector2d& fixedPoint)
{
    const Eigen::Vector2d offset = offsetOfFixedPoint(box, fixedPoint);
    Matrix5d j = Matrix5d::Identity();
    j.topLeftCorner<2, 2>() = rotation(-box(2));
    j.block<2, 1>(0, 2) = Eigen::Vector2d(-offset.y(), offset.x());
    j.block<2, 2>(0, 3) = (0.5 * fixedPoint).asDiagonal();
    return j;
}

/// The other way round.
inline Matrix5d fromFixedPoint(const Vector5d& box, const Eigen::Vector2d& fixedPoint)
{
    const Matrix5d there = toFixedPoint(box, fixedPoint);
    const Eigen::Matrix2d r = rotation(box(2));
    Matrix5d j = Matrix5d::Identity();
    j.topLeftCorner<2, 2>() = r;
    j.topRightCorner<2, 3>() = -r * there.topRightCorner<2, 3>();
    return j;
}

inline Matrix5d covarianceAtFixedPoint(const BoxMeasurement& m)
{
    const Matrix5d there = toFixedPoint(m.box, m.fixedPoint);
    return there * m.covariance * there.transpose();
}

/// A covariance of the box with the errors of the fixed point and the heading times `pose`, those
/// of sizes times `size`.
inline Matrix5d scaled(const BoxMeasurement& m, const Matrix5d& atFixedPoint,
                       const Eigen::Vector3d& pose, double size)
{
    Vector5d factors;
    factors << pose, size, size;
    const Matrix5d back = fromFixedPoint(m.box, m.fixedPoint) * factors.asDiagonal();
    return back * atFixedPoint * back.transpose();
}

}  // namespace vdamf
