// SPDX-License-Identifier: BSD-3-Clause
// Fig. 2, "remove ground": which hits stand above the local ground, and how high.
#pragma once

#include <cstdint>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
struct GroundOptions
{
    double minRange = 1.0;         ///< horizontal, from the sensor; nearer hits: the platform, m
    double maxRange = 80.0;        ///< horizontal, from the sensor, m
    double minHeight = 0.22;       ///< over the local ground; lower hits are ground, m
    double maxHeight = 3.0;        ///< over the local ground; higher hits are overhead, m
    double minSensorHeight = 0.3;  ///< least height of the LADAR over the ground, m
    double maxSensorHeight = 4.5;  ///< greatest height of the LADAR over the ground, m
    /// Of the LADAR over the ground, for frames that show no ground (line scanners), m.
    double assumedSensorHeight = 1.7;

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field)
    {
        field(self.minRange, "min_range_m", 0.0, 20.0,
              "nearer hits are the platform itself (horizontal, from the sensor)");
        field(self.maxRange, "max_range_m", 20.0, 300.0,
              "farther hits are dropped (horizontal, from the sensor)");
        field(self.minHeight, "min_height_m", 0.05, 1.0,
              "hits lower than this over the local ground are ground");
        field(self.maxHeight, "max_height_m", 1.0, 10.0,
              "hits higher than this over the local ground are bridges, branches or signs");
        field(self.minSensorHeight, "min_sensor_height_m", 0.1, 3.0,
              "least height of the sensor over the ground below it, which is searched for");
        field(self.maxSensorHeight, "max_sensor_height_m", 3.0, 20.0,
              "greatest height of the sensor over the ground below it");
        field(self.assumedSensorHeight, "assumed_sensor_height_m", 0.1, 20.0,
              "height of the sensor where a frame shows no ground (line scanners)");
    }
};

/// Hits above the ground, with their height over the ground below them.
struct AboveGround
{
    std::vector<std::uint32_t> index;  ///< of the hit in the frame's points, rising
    std::vector<float> height;         ///< above local ground, m; same length
};

/// Hits of the frame between minHeight and maxHeight above the local ground.
///
/// The height of the sensor over the ground and the slope of the road (to about 15 %) are found
/// in each frame; from the ground near the sensor the surface is followed outwards, past objects
/// that hide it, so a hit below the ground (a mirror image) or above it (a bridge) does not bend
/// it. Where a frame shows no ground or is planar, all hits in range are kept, with heights over a
/// level ground assumedSensorHeight below the sensor. Hits with a coordinate or a time that is
/// not finite are dropped.
AboveGround removeGround(const LadarFrame& frame, const GroundOptions& options);

}  // namespace vdamf
