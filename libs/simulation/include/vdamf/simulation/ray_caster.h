// SPDX-License-Identifier: BSD-3-Clause
// One revolution of a spinning LADAR through a scene: the nearest surface of every ray.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "vdamf/simulation/random_stream.h"
#include "vdamf/simulation/scene.h"
#include "vdamf/simulation/spinning_ladar.h"

namespace vdamf
{
/// A LADAR on a platform, upright.
struct LadarMount
{
    SpinningLadar ladar;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the vehicle frame, m
    double heading = 0.0;            ///< of azimuth 0, counter-clockwise from the vehicle's x, rad
    double rate = 10.0;              ///< revolutions, 1/s
    double fieldOfView = 2.0 * kPi;  ///< around azimuth 0; no returns outside, rad
    bool instantaneous = false;      ///< the world stands still during a revolution
    /// Received share of light (reflectivity cos(incidence) (10 m / range)^2) at which half of
    /// the returns are lost; 0: none are.
    double halfLossStrength = 0.001;
    double glassLoss = 0.8;  ///< probability that a ray onto glass does not return
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
    double azimuth = 0.0;              ///< at the begin, clockwise from forward, 0..2 pi, rad
    std::vector<LadarReturn> returns;  ///< by laser
};

/// Casts the revolution that begins at a scene time with azimuth 0. Platform and objects stand
/// where they are at each firing's begin (within one firing of 55 us a car at 30 m/s moves 2 mm);
/// each laser has its own azimuth within the firing. In the sensor's frame (x at azimuth 0, y
/// left, z up) a return lies in direction
///     (cos e cos a, -cos e sin a, sin e),  a = azimuth + laserDelay * 2 pi / (period * firings).
std::vector<LadarFiring> castRevolution(const Scene& scene, const LadarMount& mount, double time,
                                        RandomStream& random);

/// Returns per object of the scene.
std::vector<int> countHits(const std::vector<LadarFiring>& revolution, std::size_t objects);

}  // namespace vdamf
