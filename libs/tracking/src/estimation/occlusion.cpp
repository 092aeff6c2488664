// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/occlusion.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kBeamStep = 0.004;  // rad between hits, about, of spinning LADARs
constexpr double kWidestStep = 0.7;  // m between hits of a row whose end can be told

// Of the rows along the faces seen: those that no face seen closes. `isHidden` by the line of sight
// past their end.
template <class Predicate>
FaceSet endsWhere(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                  Predicate&& isHidden)
{
    FaceSet ends;
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2 && seen.seesAlong(axis); ++end)
            if (!seen.has(kFaceAt[axis][end]) &&
                isHidden(placePastEnd(box, sensor, axis, end, kPastEnd) - sensor, axis))
                ends.add(kFaceAt[axis][end]);
    return ends;
}
}  // namespace

Eigen::Vector2d placePastEnd(const OrientedBox& box, const Eigen::Vector2d& sensor, int axis,
                             int end, double metres)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    Eigen::Vector2d past;  // in the box frame
    past(axis) = signOfEnd(end) * (half(axis) + metres);
    past(1 - axis) = std::copysign(half(1 - axis), view(1 - axis));
    return box.centre() + rotation(box.heading) * past;
}

FaceSet blockedEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                    const RangeProfile& profile)
{
    return endsWhere(box, seen, sensor,
                     [&](const Eigen::Vector2d& ray, int) {
                         return profile.at(std::atan2(ray.y(), ray.x())) < ray.norm() + kFreeRange;
                     });
}

FaceSet grazedEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                   double headingSigma)
{
    return endsWhere(box, seen, sensor,
                     [&](const Eigen::Vector2d& ray, int axis)
                     {
                         const Eigen::Vector2d inBox = rotation(-box.heading) * ray;
                         const double across =
                             std::abs(inBox(1 - axis)) - headingSigma * std::abs(inBox(axis));
                         return kBeamStep * ray.squaredNorm() > kWidestStep * across;
                     });
}

FaceSet shadowEdges(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                    const RangeProfile& profile)
{
    constexpr double kBefore = 0.25;                   // m, the face
    constexpr double kNearer = 0.6;                    // m: what is less so may be the face itself
    constexpr double kFromCorner[] = {0.0, 0.5, 1.0};  // m
    if (!seen.seesSide() || !seen.seesEnd()) return FaceSet();
    // From afar one sector holds the face and what stands beside it.
    const double sector =
        2.0 * kPi / static_cast<double>(std::max<std::size_t>(1, profile.nearest.size()));
    if (sector * (box.centre() - sensor).norm() > kBefore) return FaceSet();
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const Eigen::Vector2d towards(std::copysign(1.0, view.x()), std::copysign(1.0, view.y()));
    const auto isShadowed = [&](int axis, int end, double fromCorner)
    {
        const Eigen::Vector2d along = towards(1 - axis) * rotation(box.heading).col(1 - axis);
        const Eigen::Vector2d ray =
            placePastEnd(box, sensor, axis, end, kBefore) - fromCorner * along - sensor;
        return profile.at(std::atan2(ray.y(), ray.x())) < ray.norm() - kNearer;
    };
    for (const double fromCorner : kFromCorner)
    {
        FaceSet edges;
        for (int axis = 0; axis < 2; ++axis)
        {
            const int end = towards(axis) > 0.0 ? 1 : 0;
            if (isShadowed(axis, end, fromCorner)) edges.add(kFaceAt[axis][end]);
        }
        // Both where the shadow reaches over the corner.
        if (!edges.seesSide() || !edges.seesEnd()) return edges;
    }
    return FaceSet();
}

}  // namespace vdamf
