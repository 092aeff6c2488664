// SPDX-License-Identifier: BSD-3-Clause
// A picture of one frame from above: hits, boxes with their front and identity, trails, sensor.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "vdamf/tracking/types/point_cloud.h"
#include "vdamf/tracking/types/track.h"

namespace vdamf
{
struct BirdsEyeOptions
{
    double metresAcross = 100.0;  ///< of the picture's width
    double metresUp = 56.0;       ///< of its height
    int pixelsAcross = 1200;
    double trailSeconds = 4.0;
};

/// Follows a run and draws its latest frame as SVG. North is up. What the discriminator takes for
/// clutter has a thin grey box alone.
class BirdsEye
{
public:
    explicit BirdsEye(const BirdsEyeOptions& options = {}) : options_(options) {}

    void add(const LadarFrame& frame, const FrameResult& result);

    /// The latest frame; an empty picture before the first one.
    std::string svg() const;

private:
    struct TrailPoint
    {
        double time;
        Eigen::Vector2d position;
    };

    std::string pointsSvg() const;
    std::string tracksSvg() const;
    std::string outlineSvg(const OrientedBox& box) const;
    Eigen::Vector2d pixel(const Eigen::Vector2d& world) const;
    bool visible(const Eigen::Vector2d& world, double margin) const;

    BirdsEyeOptions options_;
    LadarFrame frame_;
    FrameResult result_;
    std::map<std::uint64_t, std::deque<TrailPoint>> trails_;
    std::deque<TrailPoint> sensorTrail_;
};

}  // namespace vdamf
