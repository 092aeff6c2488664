// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vdamf
{
namespace
{
constexpr float kInFront = 0.35F;    // m, of the face
constexpr float kBehind = 0.8F;      // m
constexpr float kLayer = 0.2F;       // m
constexpr std::size_t kLayers = 20;  // what is higher is in the last one
constexpr double kNoise = 0.02;      // m, of hits on a plane
constexpr double kLeastHits = 3.0;   // of a layer that tells where the face is
constexpr double kMostTurn = 0.6;    // rad

// Hits of about one height, by how far they lie to the left of the box's middle and behind its end.
struct Layer
{
    double hits = 0.0;
    double left = 0.0;
    double behind = 0.0;
    double leftSquares = 0.0;
    double behindSquares = 0.0;
    double products = 0.0;

    void add(double l, double b)
    {
        hits += 1.0;
        left += l;
        behind += b;
        leftSquares += l * l;
        behindSquares += b * b;
        products += l * b;
    }

    void add(const Layer& other)
    {
        hits += other.hits;
        left += other.left;
        behind += other.behind;
        leftSquares += other.leftSquares;
        behindSquares += other.behindSquares;
        products += other.products;
    }
};

using Layers = std::array<Layer, kLayers>;

Layers layersOf(const Measurement& m, double sign, const Cluster& hits)
{
    const Eigen::Matrix2f axes = rotation(m.box.heading).cast<float>();
    const Eigen::Vector2f outwards = static_cast<float>(sign) * axes.col(0);
    const Eigen::Vector2f left = axes.col(1);
    const Eigen::Vector2f centre = m.box.centre().cast<float>();
    const auto half = static_cast<float>(0.5 * m.box.length);
    Layers layers;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2f place = Eigen::Vector2f(hits.x[i], hits.y[i]) - centre;
        const float behind = half - outwards.dot(place);
        if (behind < -kInFront || behind > kBehind) continue;
        const float layer = std::max(0.0F, hits.height[i]) / kLayer;
        layers[std::min(static_cast<std::size_t>(layer), kLayers - 1)].add(left.dot(place), behind);
    }
    return layers;
}

// Sums about the mean.
struct Spread
{
    double freedom = 0.0;
    double leftSquares = 0.0;
    double behindSquares = 0.0;
    double products = 0.0;

    void add(const Layer& layer)
    {
        if (layer.hits < 2.0) return;
        freedom += layer.hits - 1.0;
        leftSquares += layer.leftSquares - layer.left * layer.left / layer.hits;
        behindSquares += layer.behindSquares - layer.behind * layer.behind / layer.hits;
        products += layer.products - layer.left * layer.behind / layer.hits;
    }
};

// How much farther behind the end hits are to the left, m/m.
struct Slope
{
    double within = 0.0;  // layers
    double sigma = 0.0;   // of that
    double ofAll = 0.0;
};

std::optional<Slope> slopeOf(const Layers& layers)
{
    Spread within;
    Layer all;
    for (const Layer& layer : layers)
    {
        within.add(layer);
        all.add(layer);
    }
    Spread whole;
    whole.add(all);
    const double freedom = within.freedom - 1.0;
    if (freedom < 1.0 || within.leftSquares <= 0.0) return std::nullopt;
    Slope slope;
    slope.within = within.products / within.leftSquares;
    slope.ofAll = whole.products / whole.leftSquares;
    const double scatter =
        std::max(0.0, within.behindSquares - slope.within * within.products) / freedom;
    slope.sigma = std::sqrt((scatter + kNoise * kNoise) / within.leftSquares);
    return slope;
}

// To the left, m: the middle of the layer that reaches farthest.
double middleOfOutermost(const Layers& layers, double slope)
{
    double least = kBehind;
    double middle = 0.0;
    for (const Layer& layer : layers)
    {
        if (layer.hits < kLeastHits) continue;
        const double behind = (layer.behind - slope * layer.left) / layer.hits;
        if (behind >= least) continue;
        least = behind;
        middle = layer.left / layer.hits;
    }
    return middle;
}
}  // namespace

Measurement withTurnOfLayers(const Sighting& sighting, const HitsAtOneTime& seen)
{
    Measurement m = sighting.measurement;
    const bool isPiece =
        m.facesSeen.seesEnd() && !m.facesSeen.seesSide() && m.hiddenEnds.seesAcross(1);
    if (!isPiece || seen.hits->heights == 0) return m;
    const double sign = m.facesSeen.has(Face::Front) ? 1.0 : -1.0;
    const Layers layers = layersOf(m, sign, *seen.each);
    const auto slope = slopeOf(layers);
    if (!slope || slope->sigma > std::sqrt(m.covariance(2, 2))) return m;
    const double turn = sign * (std::atan(slope->within) - std::atan(slope->ofAll));
    if (std::abs(turn) > kMostTurn) return m;
    // About where the end is seen, which stays.
    const Eigen::Matrix2d axes = rotation(m.box.heading);
    const Eigen::Vector2d pivot = m.box.centre() + 0.5 * sign * m.box.length * axes.col(0) +
                                  middleOfOutermost(layers, slope->within) * axes.col(1);
    const Eigen::Vector2d centre = pivot + rotation(turn) * (m.box.centre() - pivot);
    m.box.x = centre.x();
    m.box.y = centre.y();
    m.box.heading = wrapAngle(m.box.heading + turn);
    return m;
}

}  // namespace vdamf
