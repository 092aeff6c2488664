// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/discrimination/canonical_frame.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
CanonicalHits toCanonicalFrame(const ObjectView& view, std::size_t maxHits)
{
    CanonicalHits hits;
    for (const Cluster* cluster : view.clusters) hits.count += cluster->size();
    // Odd: rings come by powers of two.
    const std::size_t step = ((hits.count + maxHits - 1) / maxHits) | 1U;

    const Eigen::Vector2d sensor = toBoxFrame(view.box, view.sensor);
    // The closest corner lies on the sensor's side of both axes of the box.
    const double alongSign = sensor.x() < 0.0 ? -1.0 : 1.0;
    const double acrossSign = sensor.y() < 0.0 ? -1.0 : 1.0;
    const double halfLength = 0.5 * view.box.length;
    const double halfWidth = 0.5 * view.box.width;
    hits.sensor = {halfLength - alongSign * sensor.x(), halfWidth - acrossSign * sensor.y()};

    const Direction forward = directionOf(view.box.heading);
    const auto c = static_cast<float>(forward.cos);
    const auto s = static_cast<float>(forward.sin);
    const auto along = static_cast<float>(alongSign);
    const auto across = static_cast<float>(acrossSign);
    const std::size_t most = hits.count / step + view.clusters.size();
    for (std::vector<float>* axis : {&hits.x, &hits.y, &hits.z}) axis->resize(most);
    std::size_t taken = 0;
    std::size_t next = 0;  // counts through all clusters, so that the choice is even
    for (const Cluster* cluster : view.clusters)
    {
        for (; next < cluster->size(); next += step)
        {
            const float dx = cluster->x[next] - static_cast<float>(view.box.x);
            const float dy = cluster->y[next] - static_cast<float>(view.box.y);
            const float z = cluster->height[next];
            hits.x[taken] = static_cast<float>(halfLength) - along * (c * dx + s * dy);
            hits.y[taken] = static_cast<float>(halfWidth) - across * (c * dy - s * dx);
            hits.z[taken] = z;
            taken += std::isfinite(dx + dy + z) ? 1 : 0;  // else the next one takes its place
        }
        next -= cluster->size();
    }
    for (std::vector<float>* axis : {&hits.x, &hits.y, &hits.z}) axis->resize(taken);
    return hits;
}

}  // namespace vdamf
