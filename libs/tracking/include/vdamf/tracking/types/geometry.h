// SPDX-License-Identifier: BSD-3-Clause
// Plane geometry shared by all stages: angles, rotations, oriented boxes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "vdamf/tracking/types/direction.h"

namespace vdamf
{
inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180.0;  ///< rad

/// The same angle in (-pi, pi].
inline double wrapAngle(double angle)
{
    if (angle > -kPi && angle <= kPi) return angle;
    const double wrapped = std::remainder(angle, 2.0 * kPi);
    return wrapped <= -kPi ? kPi : wrapped;
}

/// R(angle), counter-clockwise.
inline Eigen::Matrix2d rotation(double angle)
{
    const Direction d = directionOf(angle);
    return (Eigen::Matrix2d() << d.cos, -d.sin, d.sin, d.cos).finished();
}

/// A rectangle in the horizontal plane; the frame is named by whoever holds it.
struct OrientedBox
{
    double x = 0.0;        ///< centre, m
    double y = 0.0;        ///< centre, m
    double heading = 0.0;  ///< of the front, counter-clockwise from +x, rad
    double length = 0.0;   ///< along the heading, m
    double width = 0.0;    ///< across it, m

    Eigen::Vector2d centre() const { return {x, y}; }
    bool operator==(const OrientedBox& other) const
    {
        return x == other.x && y == other.y && heading == other.heading && length == other.length &&
               width == other.width;
    }
    bool operator!=(const OrientedBox& other) const { return !(*this == other); }
};

/// A point of the plane in box coordinates: x to the front, y to the left, from the centre.
inline Eigen::Vector2d toBoxFrame(const OrientedBox& box, const Eigen::Vector2d& point)
{
    return rotation(-box.heading) * (point - box.centre());
}

/// Corners counter-clockwise from front left: front left, rear left, rear right, front right.
inline std::array<Eigen::Vector2d, 4> corners(const OrientedBox& box)
{
    const Eigen::Matrix2d r = rotation(box.heading);
    const double l = 0.5 * box.length;
    const double w = 0.5 * box.width;
    return {box.centre() + r * Eigen::Vector2d(l, w), box.centre() + r * Eigen::Vector2d(-l, w),
            box.centre() + r * Eigen::Vector2d(-l, -w), box.centre() + r * Eigen::Vector2d(l, -w)};
}

}  // namespace vdamf
