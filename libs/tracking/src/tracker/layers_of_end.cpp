// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tracker/discriminate.h"
#include "types/box_changes.h"

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

// Sums over hits of the products of (1, m to the left of the box's middle, m behind its end).
using LayerSums = Eigen::Matrix3d;

// Of the hits of about one height each.
using Layers = std::array<LayerSums, kLayers>;

// Of (left, behind) about their mean.
Eigen::Matrix2d aboutMean(const LayerSums& m)
{
    return m.bottomRightCorner<2, 2>() -
           m.bottomLeftCorner<2, 1>() * m.topRightCorner<1, 2>() / m(0, 0);
}

Layers layersOf(const Measurement& m, double sign, const Cluster& hits)
{
    const Eigen::Matrix2f axes = rotation(m.box.heading).cast<float>();
    const Eigen::Vector2f outwards = static_cast<float>(sign) * axes.col(0);
    const Eigen::Vector2f left = axes.col(1);
    const Eigen::Vector2f centre = m.box.centre().cast<float>();
    const auto half = static_cast<float>(0.5 * m.box.length);
    Layers layers;
    layers.fill(LayerSums::Zero());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2f place = Eigen::Vector2f(hits.x[i], hits.y[i]) - centre;
        const float behind = half - outwards.dot(place);
        if (behind < -kInFront || behind > kBehind) continue;
        const float layer = std::max(0.0F, hits.height[i]) / kLayer;
        const Eigen::Vector3d v(1.0, left.dot(place), behind);
        layers[std::min(static_cast<std::size_t>(layer), kLayers - 1)] += v * v.transpose();
    }
    return layers;
}

// How much farther behind the end hits are to the left, m/m.
struct Slope
{
    double within = 0.0;  // layers
    double sigma = 0.0;   // of that
    double ofAll = 0.0;
};

std::optional<Slope> slopeOf(const Layers& layers)
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
    Slope slope;
    slope.within = within(0, 1) / within(0, 0);
    slope.ofAll = whole(0, 1) / whole(0, 0);
    const double scatter = std::max(0.0, within(1, 1) - slope.within * within(0, 1)) / freedom;
    slope.sigma = std::sqrt((scatter + kNoise * kNoise) / within(0, 0));
    return slope;
}

// Trucks' ends are flat, and of all their rows a measurement may follow one. The ends of others are
// bowed, so that their rows are turned where a piece of them is seen.
bool isFlat(double height)
{
    return height >= kLowestTruck;
}

// By which rows of one height each are turned against what the measurement followed, rad.
double turnTold(const Slope& slope, double height)
{
    const double byRows = std::atan(slope.within);
    const double overAll = byRows - std::atan(slope.ofAll);
    return isFlat(height) && std::abs(byRows) < std::abs(overAll) ? byRows : overAll;
}

// Which error of the measurement such a turn shows by itself, rad.
double errorTold(double turn, double height)
{
    constexpr double kSigmas = 3.0;
    return isFlat(height) ? std::abs(turn) / kSigmas : 0.0;
}

// To the left, m: the middle of the layer that reaches farthest.
double middleOfOutermost(const Layers& layers, double slope)
{
    double least = kBehind;
    double middle = 0.0;
    for (const LayerSums& layer : layers)
    {
        if (layer(0, 0) < kLeastHits) continue;
        const double behind = (layer(0, 2) - slope * layer(0, 1)) / layer(0, 0);
        if (behind >= least) continue;
        least = behind;
        middle = layer(0, 1) / layer(0, 0);
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
    if (!slope) return m;
    const double turn = sign * turnTold(*slope, sighting.height);
    const double error = std::max(std::sqrt(m.covariance(2, 2)), errorTold(turn, sighting.height));
    if (std::abs(turn) > kMostTurn || slope->sigma > error) return m;
    // About where the end is seen, which stays.
    const Eigen::Matrix2d axes = rotation(m.box.heading);
    const Eigen::Vector2d pivot = m.box.centre() + 0.5 * sign * m.box.length * axes.col(0) +
                                  middleOfOutermost(layers, slope->within) * axes.col(1);
    m.box = turnedAbout(pivot, turn, m.box);
    return m;
}

}  // namespace vdamf
