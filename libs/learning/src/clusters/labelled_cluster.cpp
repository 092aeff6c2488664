// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/learning/clusters/labelled_cluster.h"

#include <algorithm>
#include <cmath>

#include "vdamf/simulation/random_stream.h"

namespace vdamf
{
FaceSet facesInView(const Cluster& cluster, const OrientedBox& truth, const Eigen::Vector2d& sensor)
{
    constexpr double kGrazing = 10.0 * kPi / 180.0;
    constexpr double kNear = 0.4;  // m
    constexpr int kLeastHits = 5;
    const Eigen::Vector2d view = toBoxFrame(truth, sensor);
    const double half[2] = {0.5 * truth.length, 0.5 * truth.width};
    bool faces[2];
    for (int axis = 0; axis < 2; ++axis)
    {
        faces[axis] =
            std::atan2(std::abs(view(axis)) - half[axis], std::abs(view(1 - axis))) > kGrazing;
    }
    int hits[2] = {0, 0};
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
        const Eigen::Vector2d p = toBoxFrame(truth, {cluster.x[i], cluster.y[i]});
        bool near[2];
        for (int axis = 0; axis < 2; ++axis)
        {
            const double outwards = view(axis) > 0.0 ? p(axis) : -p(axis);
            near[axis] = std::abs(outwards - half[axis]) < kNear &&
                         std::abs(p(1 - axis)) < half[1 - axis] + kNear;
        }
        for (int axis = 0; axis < 2; ++axis)
        {
            const bool shared = near[1 - axis] && faces[1 - axis];
            if (near[axis] && !shared) ++hits[axis];
        }
    }
    FaceSet seen;
    if (faces[0] && hits[0] >= kLeastHits) seen.add(view.x() > 0.0 ? Face::Front : Face::Back);
    if (faces[1] && hits[1] >= kLeastHits) seen.add(view.y() > 0.0 ? Face::Left : Face::Right);
    return seen;
}

MeasureOptions toldOptions(const MeasureOptions& options, const LabelledCluster& sample)
{
    MeasureOptions own = options;
    if (own.rangeNoise > 0.0) own.rangeNoise = sample.rangeNoise;
    if (!sample.isBody) own.bodyDepth = 0.0;
    return own;
}

OrientedBox perturbed(const OrientedBox& truth, std::uint64_t seed, std::uint64_t index)
{
    constexpr double kMetres = 0.3;
    constexpr double kHeading = 8.0 * kPi / 180.0;
    RandomStream random(seed, index);
    OrientedBox start = truth;
    start.x += kMetres * random.gaussian();
    start.y += kMetres * random.gaussian();
    start.heading = wrapAngle(start.heading + kHeading * random.gaussian());
    start.length = std::max(1.0, start.length + kMetres * random.gaussian());
    start.width = std::max(1.0, start.width + kMetres * random.gaussian());
    return start;
}

}  // namespace vdamf
