// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/tracking/estimation/occlusion.h"

#include <algorithm>
#include <cmath>

namespace vdamf
{
namespace
{
constexpr double kBeyond = 0.6;      // m past an end, where the ray goes that would see more
constexpr double kFree = 0.4;        // m by which that ray goes on where nothing is in its way
constexpr double kBeamStep = 0.004;  // rad between hits, about, of spinning LADARs
constexpr double kWidestStep = 0.7;  // m between hits of a row whose end can be told

constexpr Face kEnd[2][2] = {{Face::Back, Face::Front}, {Face::Right, Face::Left}};
}  // namespace

FaceSet hiddenEnds(const OrientedBox& box, FaceSet seen, const Eigen::Vector2d& sensor,
                   const RangeProfile& profile)
{
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const Eigen::Vector2d half(0.5 * box.length, 0.5 * box.width);
    const Eigen::Matrix2d r = rotation(box.heading);
    const bool runs[2] = {seen.seesSide(), seen.seesEnd()};  // a seen face runs along the axis
    FaceSet hidden;
    for (int axis = 0; axis < 2; ++axis)
    {
        if (!runs[axis]) continue;
        for (int side = 0; side < 2; ++side)
        {
            if (seen.has(kEnd[axis][side])) continue;
            Eigen::Vector2d past;  // in the box frame
            past(axis) = (side == 0 ? -1.0 : 1.0) * (half(axis) + kBeyond);
            past(1 - axis) = std::copysign(half(1 - axis), view(1 - axis));
            const Eigen::Vector2d ray = past - view;
            const Eigen::Vector2d inWorld = r * ray;
            const double range = ray.norm();
            const double grazing = std::abs(ray(1 - axis)) / range;  // sine
            // What it hits may hide the rest of the face, or be the rest of it.
            const double reached = profile.at(std::atan2(inWorld.y(), inWorld.x()));
            if (reached < range + kFree || kBeamStep * range > kWidestStep * grazing)
                hidden.add(kEnd[axis][side]);
        }
    }
    return hidden;
}

FaceSet endsBelowView(const OrientedBox& box, const Eigen::Vector2d& sensor, double sensorHeight,
                      const RangeProfile& profile)
{
    constexpr double kBumper = 0.6;  // m, of which some has to be seen
    FaceSet below;
    const Eigen::Vector2d view = toBoxFrame(box, sensor);
    const double across = std::max(0.0, std::abs(view.y()) - 0.5 * box.width);
    for (int side = 0; side < 2; ++side)
    {
        const double end = (side == 0 ? -0.5 : 0.5) * box.length;
        const double range = std::hypot(view.x() - end, across);
        if (sensorHeight + profile.lowestSlope * range > kBumper) below.add(kEnd[0][side]);
    }
    return below;
}

}  // namespace vdamf
