// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/near_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "matched_filter/body_profile.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr double kBelt = 1.05;  // of cars, m above the ground: windows recede from there on

// Where some of the hits lie in the axes of the box, and on which of the faces.
struct Located
{
    static constexpr std::size_t kMost = 256;
    static constexpr std::int64_t kNowhere = -1;
    std::array<double, kMost> x, y;
    std::array<std::int64_t, kMost> face;

    void locate(const Hits& hits, std::size_t begin, std::size_t size, const OrientedBox& box,
                FaceSet seen, const NearFaceOptions& o)
    {
        const Direction forward = directionOf(box.heading);
        inWideLanes([
            =, px = hits.x.data() + begin, py = hits.y.data() + begin, c = forward.cos,
            s = forward.sin, signX = seen.has(Face::Front) ? 1.0 : -1.0,
            signY = seen.has(Face::Left) ? 1.0 : -1.0, toX = x.data(), toY = y.data(),
            toFace = face.data(),
            // A face that is not seen has no hits and takes none from the other one.
            endGate = seen.seesEnd() ? o.gate : -kFar, sideGate = seen.seesSide() ? o.gate : -kFar,
            endCorner = seen.seesSide() ? o.corner : -kFar,
            sideCorner = seen.seesEnd() ? o.corner : -kFar
        ]() __attribute__((always_inline)) {
            VDAMF_INDEPENDENT_LANES
            for (std::size_t i = 0; i < size; ++i)
            {
                const double dx = px[i] - box.x;
                const double dy = py[i] - box.y;
                const double alongX = c * dx + s * dy;
                const double alongY = c * dy - s * dx;
                const double behindEnd = 0.5 * box.length - signX * alongX;
                const double behindSide = 0.5 * box.width - signY * alongY;
                const bool beside = (behindEnd > -o.gate) & (behindEnd < box.length + o.gate) &
                                    (behindSide > -o.gate) & (behindSide < box.width + o.gate);
                const bool onEnd = (behindEnd < endGate) & (behindSide > endCorner);
                const bool onSide = (behindSide < sideGate) & (behindEnd > sideCorner);
                toX[i] = alongX;
                toY[i] = alongY;
                toFace[i] = (beside & (onEnd | onSide)) ? (onEnd ? 0 : 1) : kNowhere;
            }
        });
    }

private:
    static constexpr double kFar = 1e9;  // m
};
}  // namespace

NearFaces nearFaces(const Hits& hits, const OrientedBox& box, FaceSet seen,
                    const Eigen::Vector2d& sensor, const NearFaceOptions& o)
{
    const auto [c, s] = directionOf(box.heading);
    const double signX = seen.has(Face::Front) ? 1.0 : -1.0;
    const double signY = seen.has(Face::Left) ? 1.0 : -1.0;
    const Eigen::Vector2d view = toBoxFrame(box, sensor).normalized();
    NearFaces faces;
    NearFace& end = faces[kEndFace];
    NearFace& side = faces[kSideFace];
    NearFace& upper = faces[kUpperSide];
    end.sign = end.slope = signX;
    side.sign = signY;
    side.slope = -signY;
    end.noise = o.rangeNoise * std::abs(view.x());
    side.noise = o.rangeNoise * std::abs(view.y());
    upper = side;
    const bool hasBelt = isCarWithHeights(hits);
    const std::size_t blocks = hits.size() / FaceHits::Block::kHits + 1;
    if (seen.seesEnd()) end.hits.blocks.reserve(blocks);
    if (seen.seesSide()) side.hits.blocks.reserve(blocks);
    Located located;
    for (std::size_t begin = 0; begin < hits.size(); begin += Located::kMost)
    {
        const std::size_t size = std::min(Located::kMost, hits.size() - begin);
        located.locate(hits, begin, size, box, seen, o);
        for (std::size_t i = 0; i < size; ++i)
        {
            if (located.face[i] == Located::kNowhere) continue;
            const bool onEnd = located.face[i] == 0;
            const double weight = hits.weight[begin + i];
            const double height = hasBelt && !onEnd ? hits.height[begin + i] : 0.0;
            if (height > kCarRoof) continue;
            NearFace& face = onEnd ? end : (height > kBelt ? upper : side);
            face.hits.add(
                onEnd ? signX * located.x[i] : signY * located.y[i],
                onEnd ? located.y[i] : located.x[i], weight,
                onEnd ? hits.varianceAlong(begin + i, c, s) : hits.varianceAlong(begin + i, -s, c));
            face.weight += weight;
        }
    }
    if (std::min(side.weight, upper.weight) < o.minHits)
    {
        side.hits.add(upper.hits);
        side.weight += upper.weight;
        upper.hits = FaceHits();
    }
    for (NearFace& face : faces)
        if (face.weight < o.minHits) face.hits = FaceHits();
    return faces;
}

}  // namespace vdamf
