// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/clusters/label_hits.h"

#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kGrown = 0.3;  // m

bool isInside(const OrientedBox& box, float x, float y, double grown)
{
    const Eigen::Vector2d p = toBoxFrame(box, {x, y});
    return std::abs(p.x()) < 0.5 * box.length + grown && std::abs(p.y()) < 0.5 * box.width + grown;
}
}  // namespace

Cluster hitsInLabel(const LadarFrame& frame, const AboveGround& above, const OrientedBox& box)
{
    Cluster hits;
    for (std::size_t k = 0; k < above.index.size(); ++k)
    {
        const std::size_t i = above.index[k];
        if (!isInside(box, frame.points.x[i], frame.points.y[i], kGrown)) continue;
        hits.x.push_back(frame.points.x[i]);
        hits.y.push_back(frame.points.y[i]);
        hits.z.push_back(frame.points.z[i]);
        hits.height.push_back(above.height[k]);
    }
    return hits;
}

Cluster clusterOnLabel(const std::vector<Cluster>& clusters, const OrientedBox& box)
{
    Cluster best;
    std::size_t most = 0;
    for (const Cluster& cluster : clusters)
    {
        std::size_t inside = 0;
        for (std::size_t i = 0; i < cluster.size(); ++i)
            if (isInside(box, cluster.x[i], cluster.y[i], 0.0)) ++inside;
        if (inside <= most) continue;
        most = inside;
        best = cluster;
    }
    return best;
}

}  // namespace vdamf
