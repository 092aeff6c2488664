// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/near_faces.h"

#include <cmath>

namespace vdamf
{
NearFaces nearFaces(const Hits& hits, const OrientedBox& box, FaceSet seen,
                    const Eigen::Vector2d& sensor, const NearFaceOptions& o)
{
    const double c = std::cos(box.heading);
    const double s = std::sin(box.heading);
    const double signX = seen.has(Face::Front) ? 1.0 : -1.0;
    const double signY = seen.has(Face::Left) ? 1.0 : -1.0;
    const bool end = seen.seesEnd();
    const bool side = seen.seesSide();
    const Eigen::Vector2d view = toBoxFrame(box, sensor).normalized();
    NearFaces faces;
    faces[0].sign = faces[0].slope = signX;
    faces[1].sign = signY;
    faces[1].slope = -signY;
    faces[0].noise = o.rangeNoise * std::abs(view.x());
    faces[1].noise = o.rangeNoise * std::abs(view.y());
    const std::size_t blocks = hits.size() / FaceHits::Block::kHits + 1;
    if (end) faces[0].hits.blocks.reserve(blocks);
    if (side) faces[1].hits.blocks.reserve(blocks);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const double dx = hits.x[i] - box.x;
        const double dy = hits.y[i] - box.y;
        const double x = c * dx + s * dy;
        const double y = c * dy - s * dx;
        const double behindEnd = 0.5 * box.length - signX * x;
        const double behindSide = 0.5 * box.width - signY * y;
        // One decision for each hit: which face it is on is hard to foretell.
        const bool beside = (behindEnd > -o.gate) & (behindEnd < box.length + o.gate) &
                            (behindSide > -o.gate) & (behindSide < box.width + o.gate);
        const bool onEnd = end & (behindEnd < o.gate) & (!side | (behindSide > o.corner));
        const bool onSide = side & (behindSide < o.gate) & (!end | (behindEnd > o.corner));
        if (!(beside & (onEnd | onSide))) continue;
        const double weight = hits.weight[i];
        NearFace& face = faces[onEnd ? 0 : 1];
        face.hits.add(onEnd ? signX * x : signY * y, onEnd ? y : x, weight,
                      onEnd ? hits.varianceAlong(i, c, s) : hits.varianceAlong(i, -s, c));
        face.weight += weight;
    }
    for (NearFace& face : faces)
        if (face.weight < o.minHits) face.hits = FaceHits();
    return faces;
}

}  // namespace vdamf
