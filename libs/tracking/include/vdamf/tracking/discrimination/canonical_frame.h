// SPDX-License-Identifier: BSD-3-Clause
// Section 5: all objects aligned in one canonical coordinate system.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "vdamf/tracking/types/cluster.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
/// One object as one frame shows it. Box, sensor and clusters have the same origin and axes.
struct ObjectView
{
    OrientedBox box;                                   ///< measured, m and rad
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< m
    std::vector<const Cluster*> clusters;              ///< not owned
    double match = 0.0;                                ///< response per hit, 1/m
    std::size_t frameHits = 0;                         ///< of the whole frame, ground and all
    bool planar = false;  ///< all hits lie in one plane: heights say nothing
};

/// Hits in the canonical frame: the box's corner closest to the sensor is the origin, x runs along
/// the side and y along the end, both into the box, z up from the local ground. Vehicles are taken
/// for symmetric, so that hits of mirrored and of turned ones lie alike.
struct CanonicalHits
{
    std::vector<float> x;   ///< m
    std::vector<float> y;   ///< m
    std::vector<float> z;   ///< m
    std::size_t count = 0;  ///< of the object's hits, of which the arrays hold every n-th
    Eigen::Vector2d sensor = Eigen::Vector2d::Zero();  ///< m

    std::size_t size() const { return x.size(); }
};

/// At most about `maxHits` hits, evenly chosen of all rings; hits that are not finite are dropped.
CanonicalHits toCanonicalFrame(const ObjectView& view, std::size_t maxHits = 512);

}  // namespace vdamf
