// SPDX-License-Identifier: BSD-3-Clause
// How a box (x, y, heading, length, width) changes as one of its faces moves, or as it turns.
#pragma once

#include "vdamf/tracking/types/faces.h"
#include "vdamf/tracking/types/measurement.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// d box / d place of the face at an end of an axis, along that axis; the opposite face stays.
/// `axes`: the box's rotation.
inline Vector5d byFace(const Eigen::Matrix2d& axes, int axis, int end)
{
    Vector5d change = Vector5d::Zero();
    change.head<2>() = 0.5 * axes.col(axis);
    change(3 + axis) = signOfEnd(end);
    return change;
}

/// How far the face at an end of an axis lies outside of that of another box, along the other's
/// axis, m.
inline double outsideOf(const OrientedBox& other, const OrientedBox& box, int axis, int end)
{
    const Eigen::Vector2d normal = signOfEnd(end) * rotation(other.heading).col(axis);
    const double growth = axis == 0 ? box.length - other.length : box.width - other.width;
    return normal.dot(box.centre() - other.centre()) + 0.5 * growth;
}

/// A box turned about a point, m.
inline OrientedBox turnedAbout(const Eigen::Vector2d& point, double turn, OrientedBox box)
{
    const Eigen::Vector2d centre = point + rotation(turn) * (box.centre() - point);
    box.x = centre.x();
    box.y = centre.y();
    box.heading = wrapAngle(box.heading + turn);
    return box;
}

/// d box / d turn about a point; `lever` leads from there to the centre, m.
inline Vector5d byTurn(const Eigen::Vector2d& lever)
{
    Vector5d change = Vector5d::Zero();
    change.head<3>() << -lever.y(), lever.x(), 1.0;
    return change;
}

/// The measurement turned about a point (m) by that standard deviation (rad) more.
inline Measurement withTurn(Measurement m, double sigma, const Eigen::Vector2d& point)
{
    const Vector5d turn = byTurn(m.box.centre() - point);
    m.covariance += sigma * sigma * turn * turn.transpose();
    return m;
}

}  // namespace vdamf
