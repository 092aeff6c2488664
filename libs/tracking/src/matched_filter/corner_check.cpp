// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/corner_check.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kOnFace = 0.15;  // m from it
constexpr double kBeyondFace =
    0.5;                            // m beyond the other face; nearer hits may be the noise of that
constexpr double kRound = 0.8;      // m before it: corners are round
constexpr double kMinBeyond = 5.0;  // hits
constexpr double kMostBeyond = 0.1;  // share of a row's hits that clutter may put beyond
constexpr double kSpacings = 4.0;
constexpr double kMany = 10.0;       // hits of a row that tell how it begins
constexpr double kNearCorner = 1.0;  // m behind the other face where it must have begun ...
constexpr double kThinnest = 0.35;   // ... with so much of the density of the whole row

// The hits along one face, by how far they lie behind the other one.
struct BesideCorner
{
    double hits = 0.0;
    double beyond = 0.0;  // hits
    double near = 0.0;    // hits
    double cells = 0.0;
    double first = 1e30;  // m behind the other face
    double last = -1e30;

    void add(double behindOther, double weight)
    {
        hits += weight;
        if (behindOther < -kBeyondFace)
        {
            beyond += weight;
            return;
        }
        if (behindOther < kNearCorner) near += weight;
        cells += 1.0;
        first = std::min(first, behindOther);
        last = std::max(last, behindOther);
    }

    bool misses() const
    {
        if (beyond >= kMinBeyond && beyond > kMostBeyond * hits) return true;
        if (cells < 2.0) return false;
        if (hits >= kMany && near < kThinnest * hits * kNearCorner / std::max(kNearCorner, last))
            return true;
        const double spacing = (last - first) / (cells - 1.0);
        return first > kRound + kSpacings * spacing;
    }
};
}  // namespace

std::optional<Face> misplacedFace(const Hits& hits, const OrientedBox& box, FaceSet seen)
{
    if (!seen.seesEnd() || !seen.seesSide()) return std::nullopt;
    const Face end = seen.has(Face::Front) ? Face::Front : Face::Back;
    const Face side = seen.has(Face::Left) ? Face::Left : Face::Right;
    const auto [c, s] = directionOf(box.heading);
    const double signX = end == Face::Front ? 1.0 : -1.0;
    const double signY = side == Face::Left ? 1.0 : -1.0;
    BesideCorner onEnd;
    BesideCorner onSide;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        const double behindEnd = 0.5 * box.length - signX * (c * dx + s * dy);
        const double behindSide = 0.5 * box.width - signY * (c * dy - s * dx);
        if (std::abs(behindEnd) < kOnFace && behindSide < box.width)
            onEnd.add(behindSide, hits.weight[i]);
        if (std::abs(behindSide) < kOnFace && behindEnd < box.length)
            onSide.add(behindEnd, hits.weight[i]);
    }
    if (!onEnd.misses() && !onSide.misses()) return std::nullopt;
    return onEnd.hits < onSide.hits ? end : side;
}

}  // namespace vdamf
