// SPDX-License-Identifier: BSD-3-Clause
#include "figures/view.h"

#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
FigureView viewOf(const LadarFrame& frame, const OrientedBox& box, double groundZ,
                  const std::string& caption)
{
    constexpr double kMargin = 0.4;  // m
    constexpr double kGround = 0.2;  // m, what lies below is road
    constexpr double kHighest = 4.0;
    FigureView view;
    view.caption = caption;
    view.sensor = frame.sensor.head<2>() - box.centre();
    Cluster cluster;
    for (std::size_t i = 0; i < frame.points.size(); ++i)
    {
        const Eigen::Vector3d world =
            frame.origin +
            Eigen::Vector3f(frame.points.x[i], frame.points.y[i], frame.points.z[i]).cast<double>();
        const double height = world.z() - groundZ;
        const Eigen::Vector2d at = toBoxFrame(box, world.head<2>()).cwiseAbs();
        if (height < kGround || height > kHighest || at.x() > 0.5 * box.length + kMargin ||
            at.y() > 0.5 * box.width + kMargin)
            continue;
        const Eigen::Vector2d offset = world.head<2>() - box.centre();
        view.hits.emplace_back(offset.x(), offset.y(), height);
        cluster.x.push_back(static_cast<float>(offset.x()));
        cluster.y.push_back(static_cast<float>(offset.y()));
        cluster.z.push_back(static_cast<float>(height));
        cluster.height.push_back(static_cast<float>(height));
    }
    if (cluster.size() < 5) return view;
    const MeasureOptions options;
    const Hits hits = projectHits(cluster, options.mergeCell);
    const OrientedBox start = startBox(hits, view.sensor, widestEnd(kHighest), options.fit);
    view.measured = measureTarget(hits, view.sensor, start, options);
    return view;
}

FigureView viewOf(const LadarFrame& frame, const TruthRow& object, const std::string& caption)
{
    return viewOf(frame, object.box, object.z, caption);
}

}  // namespace vdamf
