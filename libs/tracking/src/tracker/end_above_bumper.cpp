// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/end_above_bumper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "tracker/inside_of.h"
#include "tracker/partial_faces.h"
#include "types/box_changes.h"
#include "vdamf/tracking/estimation/visibility.h"

namespace vdamf
{
namespace
{
constexpr double kBumper = 0.65;         // m above ground
constexpr std::size_t kFewOfLowest = 3;  // hits that show how low an end is seen

// The height above which all hits along the end seen lie, but for the lowest ones, m. Where the row
// of them is long, those at the corner with a side seen tell nothing, as they may be its.
double lowestOfEnd(const Measurement& m, double row, const Cluster& hits)
{
    constexpr double kLongRow = 0.9;   // m
    constexpr float kInFront = 0.25F;  // m, of the face
    constexpr float kBehind = 0.45F;   // m
    constexpr float kCorner = 0.3F;    // m
    constexpr float kFar = 100.0F;     // m: nowhere on a vehicle
    const double sign = m.facesSeen.has(Face::Front) ? 1.0 : -1.0;
    const Eigen::Matrix2f axes = rotation(m.box.heading).cast<float>();
    const Eigen::Vector2f outwards = static_cast<float>(sign) * axes.col(0);
    const Eigen::Vector2f left = axes.col(1);
    const Eigen::Vector2f centre = m.box.centre().cast<float>();
    const float half = static_cast<float>(0.5 * m.box.length);
    const float beside = static_cast<float>(0.5 * m.box.width) - kCorner;
    const bool isLong = row > kLongRow;
    const float leftmost = isLong && m.facesSeen.has(Face::Left) ? beside : kFar;
    const float rightmost = isLong && m.facesSeen.has(Face::Right) ? -beside : -kFar;
    std::array<float, kFewOfLowest> lowest;
    lowest.fill(std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (hits.height[i] >= lowest.back()) continue;
        const Eigen::Vector2f place = Eigen::Vector2f(hits.x[i], hits.y[i]) - centre;
        const float behind = half - outwards.dot(place);
        const float across = left.dot(place);
        if (behind < -kInFront || behind > kBehind) continue;
        if (across > leftmost || across < rightmost) continue;
        lowest.back() = hits.height[i];
        std::sort(lowest.begin(), lowest.end());
    }
    return static_cast<double>(lowest.back());
}

int endSeen(const Measurement& m)
{
    return m.facesSeen.has(Face::Front) ? 1 : 0;
}

Measurement withEndSigma(Measurement m, double sigma)
{
    const Vector5d change = byFace(rotation(m.box.heading), 0, endSeen(m));
    m.covariance += sigma * sigma * change * change.transpose();
    return m;
}
}  // namespace

double endAboveBumper(const Sighting& sighting, const HitsAtOneTime& seen)
{
    const Measurement& m = sighting.measurement;
    const bool heightsKnown = seen.hits->heights != 0;
    if (!heightsKnown || !m.facesSeen.seesEnd() || sighting.height > kTruckHeight) return 0.0;
    const double above = lowestOfEnd(m, sighting.end.metres, *seen.each) - kBumper;
    return std::isfinite(above) ? std::max(0.0, above) : 0.0;
}

Measurement withRecessOfEnd(const Sighting& sighting)
{
    constexpr double kRecess = 1.0;      // m behind the end per m above the bumper,
    constexpr double kRecessBend = 4.0;  // and the more, the higher: bonnets are flat, 1/m
    constexpr double kRoof = 0.5;        // m above the bumper, from which on no end begins
    Measurement m = sighting.measurement;
    const double above = sighting.endAboveBumper;
    if (above == 0.0) return m;
    if (above > kRoof && m.facesSeen.seesSide())
    {
        const Face end = kFaceAt[0][endSeen(m)];
        m.facesSeen.remove(end);
        m.hiddenEnds.add(end);
        return m;
    }
    const double bend = sighting.height < kLowVehicle ? kRecessBend : 0.0;
    return withEndSigma(m, above * (kRecess + bend * above));
}

Measurement withEndAsForetold(const Measurement& measurement, const Sighting& sighting,
                              const VehicleState& foretold)
{
    constexpr double kAtBumper = 0.3;  // m behind the end, at most,
    constexpr double kRise = 5.0;      // and that per m above the bumper
    constexpr double kMost = 1.2;      // m: all of a bonnet
    const double above = sighting.endAboveBumper;
    if (above == 0.0 || !measurement.facesSeen.seesEnd() ||
        liesAcross(measurement, foretold.mean(kHeading)))
        return measurement;
    const double inside =
        insideOf(foretold, measurement.box, 0, endSeen(measurement), sighting.around.centre())
            .metres;
    const double most = std::min(kMost, kAtBumper + kRise * above);
    return withEndSigma(measurement, std::clamp(inside, 0.0, most));
}

}  // namespace vdamf
