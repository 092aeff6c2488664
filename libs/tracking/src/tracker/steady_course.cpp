// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/steady_course.h"

#include <algorithm>
#include <cmath>

#include "types/box_extent.h"

namespace vdamf
{
namespace
{
constexpr double kCourseSpeed = 0.5;  // m/s
constexpr double kLeastShare = 0.5;   // of the mean speed, in each half of a steady course

// How far a box has moved along a direction (m): as far as that one of its two faces there that has
// moved less. The centre of a box that grows as more of it is seen moves as well, but only one face
// does.
double movedAlong(double direction, const OrientedBox& from, const OrientedBox& to)
{
    const Eigen::Vector2d axis = rotation(direction).col(0);
    const double centre = axis.dot(to.centre() - from.centre());
    const double growth = halfAlong(to, direction) - halfAlong(from, direction);
    return std::copysign(std::max(0.0, std::abs(centre) - std::abs(growth)), centre);
}

Course courseBetween(const PathPoint& from, const PathPoint& to)
{
    Eigen::Vector2d move = Eigen::Vector2d::Zero();
    for (int axis = 0; axis < 2; ++axis)
    {
        // With neither face in view, what hides them may be what moves.
        if (!from.located.seesAcross(axis) || !to.located.seesAcross(axis)) continue;
        move(axis) = movedAlong(to.box.heading + 0.5 * kPi * axis, from.box, to.box);
    }
    return {to.box.heading + std::atan2(move.y(), move.x()), move.norm(), to.time - from.time};
}
}  // namespace

std::optional<Course> steadyCourse(const Track& track)
{
    constexpr double kLeastTime = 1.0;  // s
    constexpr double kFar = 5.0;        // m
    if (track.path.size() < 3) return std::nullopt;
    const PathPoint& last = track.path.back();
    std::size_t first = track.path.size();
    Course all;
    const auto tells = [&] {
        return all.distance >= kFar ||
               (all.distance >= kCourseDistance && all.duration >= kLeastTime);
    };
    while (first > 0 && !tells())
    {
        const PathPoint& from = track.path[--first];
        // No course is longer than the way between the centres.
        const double far = last.time - from.time < kLeastTime && first > 0 ? kFar : kCourseDistance;
        const bool mayTell = (last.box.centre() - from.box.centre()).squaredNorm() >= far * far;
        all = mayTell ? courseBetween(from, last) : Course();
    }
    if (all.distance < kCourseDistance || all.distance < kCourseSpeed * all.duration)
        return std::nullopt;
    const PathPoint& middle = track.path[(first + track.path.size()) / 2];
    for (const Course& half :
         {courseBetween(track.path[first], middle), courseBetween(middle, last)})
    {
        const double along = half.speedAlong(all.direction) * all.duration / all.distance;
        if (along < kLeastShare) return std::nullopt;
    }
    return all;
}

}  // namespace vdamf
