// SPDX-License-Identifier: BSD-3-Clause
// What stands where around the sensor: the nearest hit by bearing.
#pragma once

#include <cstddef>
#include <vector>

namespace vdamf
{
/// Range in the plane of the nearest hit above ground in each of equal sectors, from bearing -pi
/// counter-clockwise; infinite where there is none, zero where the sensor does not look.
struct RangeProfile
{
    std::vector<float> nearest;  ///< m, narrow gaps closed
    /// Of hits, gaps and all, that are seen at or above each of some slopes (rise over run from the
    /// sensor), from the lowest one, one slope after the other; empty where heights are not known.
    std::vector<float> nearestAbove;  ///< m

    /// In the sector of a bearing (rad, any turn); infinite for an empty profile.
    double at(double bearing) const;
    /// Of what a ray of that slope (rise over run) meets, or passes below; of all hits where
    /// heights are not known.
    double at(double bearing, double slope) const;

    static constexpr double kLowestLayer = -0.1;  ///< rise over run
    static constexpr double kLayer = 0.01;        ///< from one to the next
    static constexpr std::size_t kLayers = 40;
};

}  // namespace vdamf
