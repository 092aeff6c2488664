// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/face_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr float kLayer = 0.2F;   // m
constexpr double kNoise = 0.02;  // m, of hits on a plane

// Of (along, behind) about their mean.
Eigen::Matrix2d aboutMean(const LayerSums& m)
{
    return m.bottomRightCorner<2, 2>() -
           m.bottomLeftCorner<2, 1>() * m.topRightCorner<1, 2>() / m(0, 0);
}
}  // namespace

Layers layersOf(const OrientedBox& box, int axis, double sign, const FaceBand& band,
                const Cluster& hits)
{
    const Eigen::Matrix2f axes = rotation(box.heading).cast<float>();
    const Eigen::Vector2f outwards = static_cast<float>(sign) * axes.col(axis);
    const Eigen::Vector2f forth = axes.col(1 - axis);
    const Eigen::Vector2f centre = box.centre().cast<float>();
    const auto half = static_cast<float>(0.5 * (axis == 0 ? box.length : box.width));
    const auto end = static_cast<float>(0.5 * (axis == 0 ? box.width : box.length));
    const float farthest =
        band.fromEnds < 0.0F ? std::numeric_limits<float>::infinity() : end - band.fromEnds;
    Layers layers;
    layers.fill(LayerSums::Zero());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2f place = Eigen::Vector2f(hits.x[i], hits.y[i]) - centre;
        const float behind = half - outwards.dot(place);
        const float along = forth.dot(place);
        if (behind < -band.inFront || behind > band.behind || std::abs(along) > farthest) continue;
        const float layer = std::max(0.0F, hits.height[i]) / kLayer;
        const Eigen::Vector3d v(1.0, along, behind);
        layers[std::min(static_cast<std::size_t>(layer), layers.size() - 1)] += v * v.transpose();
    }
    return layers;
}

std::optional<LayerSlope> slopeOf(const Layers& layers)
{
    LayerSums all = LayerSums::Zero();
    Eigen::Matrix2d within = Eigen::Matrix2d::Zero();
    double freedom = -1.0;
    for (const LayerSums& layer : layers)
    {
        all += layer;
        if (layer(0, 0) < 2.0) continue;
        within += aboutMean(layer);
        freedom += layer(0, 0) - 1.0;
    }
    if (freedom < 1.0 || within(0, 0) <= 0.0) return std::nullopt;
    const Eigen::Matrix2d whole = aboutMean(all);
    LayerSlope slope;
    slope.within = within(0, 1) / within(0, 0);
    slope.ofAll = whole(0, 1) / whole(0, 0);
    const double scatter = std::max(0.0, within(1, 1) - slope.within * within(0, 1)) / freedom;
    slope.sigma = std::sqrt((scatter + kNoise * kNoise) / within(0, 0));
    return slope;
}

}  // namespace vdamf
