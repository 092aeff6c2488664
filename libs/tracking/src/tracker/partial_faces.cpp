// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/partial_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "types/box_changes.h"

namespace vdamf
{
namespace
{
constexpr double kDepth = 0.1;        // m, by which a piece of a body departs from a plane
constexpr double kLeastRow = 0.3;     // m
constexpr double kBumper = 0.65;      // m above ground
constexpr double kSlope = 1.0;        // m behind the end per m above the bumper
constexpr double kTruckHeight = 2.2;  // m
constexpr std::size_t kFew = 3;       // hits that show how low a face is seen

// Whether the row along an axis ends where something hides the rest.
bool isPiece(const Measurement& m, Face one, Face other)
{
    return m.hiddenEnds.has(one) || m.hiddenEnds.has(other);
}

// The height above which all hits along the end seen lie, but for the lowest ones, m.
double lowestOfEnd(const Measurement& m, const SegmentedFrame& frame,
                   const std::vector<std::size_t>& clusters)
{
    constexpr float kInFront = 0.25F;  // m, of the face
    constexpr float kBehind = 0.45F;   // m
    const double sign = m.facesSeen.has(Face::Front) ? 1.0 : -1.0;
    const Eigen::Vector2f outwards = (sign * rotation(m.box.heading).col(0)).cast<float>();
    const Eigen::Vector2f centre = m.box.centre().cast<float>();
    const float half = static_cast<float>(0.5 * m.box.length);
    std::array<float, kFew> lowest;
    lowest.fill(std::numeric_limits<float>::infinity());
    for (const std::size_t k : clusters)
    {
        const Cluster& c = frame.clusters[k];
        for (std::size_t i = 0; i < c.size(); ++i)
        {
            if (c.height[i] >= lowest.back()) continue;
            const float behind =
                half - outwards.x() * (c.x[i] - centre.x()) - outwards.y() * (c.y[i] - centre.y());
            if (behind < -kInFront || behind > kBehind) continue;
            lowest.back() = c.height[i];
            std::sort(lowest.begin(), lowest.end());
        }
    }
    return static_cast<double>(lowest.back());
}
}  // namespace

Measurement withTurnOfPieces(const Sighting& sighting)
{
    Measurement m = sighting.measurement;
    double row = 0.0;
    for (const bool side : {false, true})
    {
        if (!(side ? m.facesSeen.seesSide() : m.facesSeen.seesEnd())) continue;
        if (!(side ? isPiece(m, Face::Front, Face::Back) : isPiece(m, Face::Left, Face::Right)))
            return m;
        row = std::max(row, side ? sighting.side.metres : sighting.end.metres);
    }
    if (row <= 0.0) return m;
    const double sigma = std::atan(kDepth / std::max(row, kLeastRow));
    // About the hits.
    const Vector5d turn = byTurn(m.box.centre() - sighting.around.centre());
    m.covariance += sigma * sigma * turn * turn.transpose();
    return m;
}

Measurement withRecessOfEnd(const Measurement& measurement, const SegmentedFrame& frame,
                            const std::vector<std::size_t>& clusters, double height)
{
    if (frame.planar || !measurement.facesSeen.seesEnd() || height > kTruckHeight)
        return measurement;
    const double above = lowestOfEnd(measurement, frame, clusters) - kBumper;
    if (!(above > 0.0) || !std::isfinite(above)) return measurement;
    Measurement m = measurement;
    const double sigma = kSlope * above;
    const Vector5d change =
        byFace(rotation(m.box.heading), 0, m.facesSeen.has(Face::Front) ? 1 : 0);
    m.covariance += sigma * sigma * change * change.transpose();
    return m;
}

}  // namespace vdamf
