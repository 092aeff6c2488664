// SPDX-License-Identifier: BSD-3-Clause
#include "fit_cluster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vdamf
{
namespace
{
constexpr std::size_t kLeastHits = 3;   // two are on a line of any direction
constexpr double kOnePlace = 1e-3;      // m; no sensor tells such hits apart
constexpr double kLargestExtent = 1e3;  // m; no vehicle, and single precision ends

// Smallest and largest value.
std::pair<double, double> range(const std::vector<double>& values)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
}

std::string whyNoFit(const TableCluster& cluster)
{
    if (cluster.lineNotFinite > 0)
    {
        return "a coordinate is not a finite number (line " +
               std::to_string(cluster.lineNotFinite) + ")";
    }
    if (cluster.x.size() < kLeastHits) return "fewer than 3 hits";
    const auto [lowX, highX] = range(cluster.x);
    const auto [lowY, highY] = range(cluster.y);
    const double extent = std::hypot(highX - lowX, highY - lowY);
    if (extent < kOnePlace) return "all hits in one place";
    if (!(extent < kLargestExtent)) return "hits spread over more than 1 km";
    return "";
}

Cluster relativeTo(const Eigen::Vector2d& origin, const TableCluster& cluster)
{
    Cluster local;
    for (std::size_t i = 0; i < cluster.x.size(); ++i)
    {
        const auto height = cluster.z.empty() ? 0.0F : static_cast<float>(cluster.z[i]);
        local.x.push_back(static_cast<float>(cluster.x[i] - origin.x()));
        local.y.push_back(static_cast<float>(cluster.y[i] - origin.y()));
        local.z.push_back(height);
        local.height.push_back(height);
    }
    return local;
}

// Height of the cluster; 0 where it is unknown.
double heightOf(const Cluster& cluster)
{
    return *std::max_element(cluster.height.begin(), cluster.height.end());
}

// The rectangle around the hits at a heading.
OrientedBox boundsAt(const Hits& hits, double heading, const FitOptions& limits)
{
    const Eigen::Matrix2d toBox = rotation(-heading);
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e30);
    Eigen::Vector2d high = -low;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const Eigen::Vector2d p = toBox * Eigen::Vector2d(hits.x[i], hits.y[i]);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Eigen::Vector2d centre = toBox.transpose() * (0.5 * (low + high));
    return {centre.x(), centre.y(), wrapAngle(heading),
            std::clamp(high.x() - low.x(), limits.minLength, limits.maxLength),
            std::clamp(high.y() - low.y(), limits.minWidth, limits.maxWidth)};
}

bool isFinite(const Measurement& m)
{
    const OrientedBox& b = m.box;
    return std::isfinite(b.x + b.y + b.heading + b.length + b.width + m.match) &&
           m.covariance.allFinite();
}
}  // namespace

ClusterFit fitCluster(const TableCluster& cluster, const MeasureOptions& options)
{
    ClusterFit fit;
    fit.reason = whyNoFit(cluster);
    if (!fit.reason.empty()) return fit;
    const Eigen::Vector2d origin(cluster.x.front(), cluster.y.front());
    const Eigen::Vector2d sensor = cluster.sensor - origin;
    const Cluster local = relativeTo(origin, cluster);
    const Hits hits = projectHits(local, options.mergeCell);
    const OrientedBox start = cluster.heading
                                  ? boundsAt(hits, *cluster.heading, options.fit)
                                  : startBox(hits, sensor, widestEnd(heightOf(local)), options.fit);
    Measurement m = measureTarget(hits, sensor, start, options);
    m.box.x += origin.x();
    m.box.y += origin.y();
    if (!isFinite(m))
    {
        fit.reason = "the fit is not finite";
        return fit;
    }
    fit.converged = m.converged;
    if (!m.converged)
        fit.reason = "no convergence in " + std::to_string(m.iterations) + " evaluations";
    fit.measurement = m;
    return fit;
}

}  // namespace vdamf
