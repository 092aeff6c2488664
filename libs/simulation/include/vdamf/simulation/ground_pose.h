// SPDX-License-Identifier: BSD-3-Clause
// How things stand on the ground: height, pitch and roll from the places where they touch it.
#pragma once

#include <Eigen/Core>

#include "vdamf/simulation/terrain.h"

namespace vdamf
{
/// A pose in the scene. The attitude is Rz(heading) Ry(pitch) Rx(roll), as in CPose3D of MRPT: a
/// positive pitch lowers the front, a positive roll lowers the right side.
struct GroundPose
{
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
    double heading = 0.0;                                ///< rad
    double pitch = 0.0;                                  ///< rad
    double roll = 0.0;                                   ///< rad

    Eigen::Matrix3d attitude() const;
};

/// Where something touches the ground, in its own frame: four points at x = front and -rear,
/// y = +-half. All 0: it stands upright on one point.
struct Contacts
{
    double front = 0.0;  ///< m
    double rear = 0.0;   ///< m
    double half = 0.0;   ///< m
};

/// Stiff, without springs: the plane through the four contacts, in the mean of least squares.
GroundPose standOn(const Terrain& terrain, const Eigen::Vector2d& place, double heading,
                   const Contacts& contacts);

/// Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d attitudeOf(double yaw, double pitch, double roll);

}  // namespace vdamf
