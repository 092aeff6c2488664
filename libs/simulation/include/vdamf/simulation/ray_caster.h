// SPDX-License-Identifier: BSD-3-Clause
// One scan of a LADAR through a scene: the nearest surface of every ray.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vdamf/simulation/random_stream.h"
#include "vdamf/simulation/scene.h"
#include "vdamf/simulation/spinning_ladar.h"

namespace vdamf
{
/// A LADAR on a platform.
struct LadarMount
{
    SpinningLadar ladar;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the vehicle frame, m
    double heading = 0.0;            ///< of azimuth 0, counter-clockwise from the vehicle's x, rad
    double pitch = 0.0;              ///< positive: looks down, rad
    double roll = 0.0;               ///< positive: the right side is lower, rad
    double rate = 10.0;              ///< scans, 1/s
    double fieldOfView = 2.0 * kPi;  ///< around azimuth 0; no returns outside, rad
    bool instantaneous = false;      ///< the world stands still during a scan
    /// Received share of light (reflectivity, share towards the sensor, (10 m / range)^2) at which
    /// half of the returns are lost; 0: none are. The share is cos(incidence) of paint, glass and
    /// metal, and at least 0.6 of rough materials.
    double halfLossStrength = 0.002;
    double glassLoss = 0.9;  ///< probability that a ray onto glass does not return
};

struct LadarReturn
{
    static constexpr int kNone = -2;
    static constexpr int kGround = -1;

    double range = 0.0;      ///< m, 0: no return
    double intensity = 0.0;  ///< 0..1
    int object = kNone;      ///< index in the scene, kGround or kNone
};

struct LadarFiring
{
    double time = 0.0;                 ///< begin, scene time, s
    double azimuth = 0.0;              ///< at the begin, clockwise from forward, rad
    std::vector<LadarReturn> returns;  ///< by laser
};

/// Casts the scan that begins at a scene time, with the firings of sweepOf(). Platform and objects
/// stand where they are at each firing's begin (within one firing of 55 us a car at 30 m/s moves
/// 2 mm); each laser has its own azimuth within the firing. In the sensor's frame (x at azimuth 0,
/// y left, z up) a return lies in direction
///     (cos e cos a, -cos e sin a, sin e),  a = azimuth + laserDelay / period * azimuthStep.
std::vector<LadarFiring> castScan(const Scene& scene, const LadarMount& mount, double time,
                                  RandomStream& random);

/// Returns per object of the scene.
std::vector<int> countHits(const std::vector<LadarFiring>& scan, std::size_t objects);

}  // namespace vdamf
