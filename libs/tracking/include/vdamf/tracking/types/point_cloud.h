// SPDX-License-Identifier: BSD-3-Clause
// A scan as plain arrays, and the frame that the tracker works on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace vdamf
{
/// Points as structure of arrays. The three coordinates have equal length; `intensity` and `time`
/// are either empty or of that length too.
struct PointCloud
{
    std::vector<float> x;          ///< m
    std::vector<float> y;          ///< m
    std::vector<float> z;          ///< m
    std::vector<float> intensity;  ///< 0..1, may be empty
    std::vector<float> time;  ///< s relative to the scan's time stamp, within 10 s, may be empty

    std::size_t size() const { return x.size(); }
    bool empty() const { return x.empty(); }
};

/// One scan of the surroundings in world axes (x east, y north, z up): what the paper's Fig. 2
/// calls LADAR data in fixed world coordinates.
///
/// Points are kept relative to `origin`, a world position near the sensor, so that single
/// precision stays below a millimetre however far from the world's origin the platform drives.
struct LadarFrame
{
    double time = 0.0;                                 ///< instant the points refer to, s (UNIX)
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the points, in the world, m
    Eigen::Vector3d sensor = Eigen::Vector3d::Zero();  ///< of the LADAR, in the world, m
    PointCloud points;                                 ///< world axes, relative to `origin`
    /// All hits lie in one level plane above the ground, like those of a line scanner: none is on
    /// the ground, and their heights over it are not known.
    bool planar = false;
};

}  // namespace vdamf
