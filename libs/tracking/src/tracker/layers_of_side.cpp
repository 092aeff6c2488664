// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/layers_of_side.h"

#include <algorithm>
#include <cmath>

#include "tracker/face_layers.h"
#include "types/box_changes.h"

namespace vdamf
{
namespace
{
constexpr FaceBand kSideBand{0.25F, 0.35F, 0.4F};
constexpr double kMostTurnOfSide = 0.08;  // rad
constexpr double kVagueSide = 0.05;       // rad: of hits that may as well be on another face
constexpr double kShortSide = 2.0;        // m

// By which rows of one height each are turned against the measurement, as far as all hits together
// are turned against them: else the measurement errs by something else. rad
double turnToldBySide(const LayerSlope& slope)
{
    const double byRows = std::atan(slope.within);
    const double overAll = byRows - std::atan(slope.ofAll);
    if (byRows * overAll <= 0.0) return 0.0;
    return std::abs(byRows) < std::abs(overAll) ? byRows : overAll;
}
}  // namespace

Measurement withTurnOfSideLayers(const Sighting& sighting, const HitsAtOneTime& seen)
{
    Measurement m = sighting.measurement;
    const double error = std::sqrt(m.covariance(2, 2));
    if (!m.facesSeen.seesSide() || seen.hits->heights == 0 || error > kVagueSide ||
        sighting.side.metres < kShortSide)
        return m;
    const double sign = m.facesSeen.has(Face::Left) ? 1.0 : -1.0;
    const auto slope = slopeOf(layersOf(m.box, 1, sign, kSideBand, *seen.each));
    if (!slope || slope->sigma > error) return m;
    const double turn = -sign * turnToldBySide(*slope);
    if (std::abs(turn) > kMostTurnOfSide) return m;
    const double near = toBoxFrame(m.box, sighting.sensor).x() > 0.0 ? 1.0 : -1.0;
    const Eigen::Vector2d corner =
        m.box.centre() + rotation(m.box.heading) *
                             Eigen::Vector2d(0.5 * near * m.box.length, 0.5 * sign * m.box.width);
    m.box = turnedAbout(corner, turn, m.box);
    return m;
}

}  // namespace vdamf
