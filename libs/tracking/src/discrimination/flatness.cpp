// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/flatness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
struct SpatialMoments
{
    double count = 0.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();  // lower triangle

    Eigen::Matrix3d covariance() const
    {
        const Eigen::Vector3d mean = sum / count;
        Eigen::Matrix3d result = squares / count;
        result.triangularView<Eigen::Lower>() -= mean * mean.transpose();
        return result;
    }
};

/// Of the hits whose depth behind a face, one of the coordinates, is within reach.
SpatialMoments momentsOf(const CanonicalHits& hits, const std::vector<float>& depths, float reach)
{
    SpatialMoments moments;
    inWideLanes([
        reach, px = hits.x.data(), py = hits.y.data(), pz = hits.z.data(), pd = depths.data(),
        size = hits.size(), result = &moments
    ]() __attribute__((always_inline)) {
        Floats n{}, sx{}, sy{}, sz{}, xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x, y, z, depth;
            load(x, px + first, count);
            load(y, py + first, count);
            load(z, pz + first, count);
            load(depth, pd + first, count);
            const auto counts =
                (depth <= reach) & (depth >= -reach) & (kLaneNumbers < static_cast<float>(count));
            // From the middle of a car, so that squares keep their digits.
            const Floats none{};
            x = counts ? x - 2.0F : none;
            y = counts ? y - 1.0F : none;
            z = counts ? z - 1.0F : none;
            n += counts ? none + 1.0F : none;
            sx += x;
            sy += y;
            sz += z;
            xx += x * x;
            xy += x * y;
            xz += x * z;
            yy += y * y;
            yz += y * z;
            zz += z * z;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        result->count = sumOf(n);
        result->sum << sumOf(sx), sumOf(sy), sumOf(sz);
        result->squares << sumOf(xx), 0.0, 0.0, sumOf(xy), sumOf(yy), 0.0, sumOf(xz), sumOf(yz),
            sumOf(zz);
    });
    return moments;
}

FaceShape faceShapeOf(const CanonicalHits& hits, const std::vector<float>& depths)
{
    constexpr float kReach = 0.5F;   // m
    constexpr double kFewest = 6.0;  // hits
    const SpatialMoments moments = momentsOf(hits, depths, kReach);
    FaceShape shape;
    shape.share = moments.count / static_cast<double>(hits.size());
    if (moments.count < kFewest) return shape;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(moments.covariance());
    shape.scatter = std::sqrt(std::max(0.0, axes.eigenvalues()(0)));
    shape.tilt = std::abs(axes.eigenvectors()(2, 0));
    return shape;
}
}  // namespace

Flatness flatnessOf(const CanonicalHits& hits)
{
    Flatness flatness;
    flatness.side = faceShapeOf(hits, hits.y);
    flatness.end = faceShapeOf(hits, hits.x);
    const SpatialMoments all = momentsOf(hits, hits.x, std::numeric_limits<float>::max());
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(all.covariance(), Eigen::EigenvaluesOnly);
    const Eigen::Vector3d spans = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    flatness.least = spans(0);
    flatness.middle = spans(1);
    flatness.greatest = spans(2);
    return flatness;
}

}  // namespace vdamf
