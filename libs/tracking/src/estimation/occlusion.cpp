// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/occlusion.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kBeyond = 0.6;      // m past an end, where the ray goes that would see more
constexpr double kFreeRange = 0.4;   // m by which that ray goes on where nothing is in its way
constexpr double kBeamStep = 0.004;  // rad between hits, about, of spinning LADARs
constexpr double kWidestStep = 0.7;  // m between hits of a row whose end can be told

// Of the rows along the faces seen: those that no face seen closes.
template <class Visitor>
void forEachEnd(FaceSet seen, Visitor&& visit)
{
    for (int axis = 0; axis < 2; ++axis)
        for (int end = 0; end < 2 && seen.seesAlong(axis); ++end)
            if (!seen.has(kFaceAt[axis][end])) visit(axis, end);
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

FaceSet grazedEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor)
{
    FaceSet grazed;
    forEachEnd(
        seen,
        [&](int axis, int end)
        {
            const Eigen::Vector2d ray = placePastEnd(box, sensor, axis, end, kBeyond) - sensor;
            const double range = ray.norm();
            const double sine = std::abs(ray.dot(rotation(box.heading).col(1 - axis))) / range;
            if (kBeamStep * range > kWidestStep * sine) grazed.add(kFaceAt[axis][end]);
        });
    return grazed;
}

FaceSet hiddenEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                   const RangeProfile& profile)
{
    FaceSet hidden = grazedEnds(box, seen, sensor);
    forEachEnd(seen,
               [&](int axis, int end)
               {
                   const Eigen::Vector2d ray =
                       placePastEnd(box, sensor, axis, end, kBeyond) - sensor;
                   // What it hits may hide the rest of the face, or be the rest of it.
                   if (profile.at(std::atan2(ray.y(), ray.x())) < ray.norm() + kFreeRange)
                       hidden.add(kFaceAt[axis][end]);
               });
    return hidden;
}

FaceSet endsBelowView(const OrientedBox& box, const Eigen::Vector2d& sensor, double sensorHeight,
                      const RangeProfile& profile)
{
    constexpr double kBumper = 0.6;  // m, of which some has to be seen
    FaceSet below;
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double across = std::max(0.0, std::abs(view.y()) - 0.5 * box.width);
    for (int end = 0; end < 2; ++end)
    {
        const double place = 0.5 * signOfEnd(end) * box.length;
        const double range = std::hypot(view.x() - place, across);
        if (sensorHeight + profile.lowestSlope * range > kBumper) below.add(kFaceAt[0][end]);
    }
    return below;
}

}  // namespace vdamf
