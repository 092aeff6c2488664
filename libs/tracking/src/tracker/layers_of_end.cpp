// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_end.h"

#include <algorithm>
#include <cmath>

#include "tracker/discriminate.h"
#include "tracker/face_layers.h"
#include "types/box_changes.h"

namespace vdamf
{
namespace
{
constexpr FaceBand kEndBand{0.35F, 0.8F, -1.0F};
constexpr double kLeastOfLayer = 3.0;  // of a layer that tells where the face is
constexpr double kMostTurn = 0.6;      // rad

// Trucks' ends are flat, and of all their rows a measurement may follow one. The ends of others are
// bowed, so that their rows are turned where a piece of them is seen.
bool isFlat(double height)
{
    return height >= kLowestTruck;
}

// By which rows of one height each are turned against what the measurement followed, rad.
double turnTold(const LayerSlope& slope, double height)
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
    double least = kEndBand.behind;
    double middle = 0.0;
    for (const LayerSums& layer : layers)
    {
        if (layer(0, 0) < kLeastOfLayer) continue;
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
    const Layers layers = layersOf(m.box, 0, sign, kEndBand, *seen.each);
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
