// SPDX-License-Identifier: BSD-3-Clause
// A rigid motion of everything in the plane.
#pragma once

#include <Eigen/Core>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// A turn about the origin, then a shift.
struct PlaneMotion
{
    double turn = 0.0;                                ///< rad
    Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< m

    Eigen::Vector2d of(const Eigen::Vector2d& point) const
    {
        return rotation(turn) * point + shift;
    }
    OrientedBox of(const OrientedBox& box) const
    {
        const Eigen::Vector2d centre = of(box.centre());
        return {centre.x(), centre.y(), wrapAngle(box.heading + turn), box.length, box.width};
    }
    bool isNone() const { return turn == 0.0 && shift.isZero(0.0); }
    PlaneMotion inverse() const { return {-turn, -(rotation(-turn) * shift)}; }
    /// The same motion told about another origin, at `point` in these axes (m).
    PlaneMotion about(const Eigen::Vector2d& point) const { return {turn, of(point) - point}; }
};

/// First `b`, then `a`.
inline PlaneMotion operator*(const PlaneMotion& a, const PlaneMotion& b)
{
    return {a.turn + b.turn, a.of(b.shift)};
}

}  // namespace vdamf
