// SPDX-License-Identifier: BSD-3-Clause
// Which labels are of something that stands.
#include <algorithm>
#include <cmath>

#include "vdamf/simulation/labelled_motion.h"

namespace vdamf
{
namespace
{
constexpr double kShortest = 2.0;       ///< s
constexpr double kRadius = 0.2;         ///< m
constexpr double kRadiusOfAll = 0.9;    ///< m; labels of a parked car wander as it is passed
constexpr double kDriftSpeed = 0.1;     ///< m/s
constexpr double kDriftDistance = 0.1;  ///< m, allowed on top for the noise of labels

using Iterator = std::vector<LabelledPose>::const_iterator;

LabelledPose meanOf(Iterator begin, Iterator end)
{
    LabelledPose mean;
    for (Iterator i = begin; i != end; ++i)
    {
        mean.x += i->x;
        mean.y += i->y;
        mean.heading += i->heading;
    }
    const auto count = static_cast<double>(end - begin);
    return {begin->time, mean.x / count, mean.y / count, mean.heading / count};
}

double medianOf(Iterator begin, Iterator end, double LabelledPose::*member)
{
    std::vector<double> values;
    for (Iterator i = begin; i != end; ++i) values.push_back((*i).*member);
    const auto middle = values.begin() + (end - begin) / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Medians: single labels may be far off.
Standstill standstill(Iterator begin, Iterator end)
{
    const LabelledPose pose{begin->time, medianOf(begin, end, &LabelledPose::x),
                            medianOf(begin, end, &LabelledPose::y),
                            medianOf(begin, end, &LabelledPose::heading)};
    return {begin->time, (end - 1)->time, pose};
}

bool isWithin(Iterator begin, Iterator end, double radius)
{
    const LabelledPose mean = meanOf(begin, end);
    return std::all_of(begin, end,
                       [&](const LabelledPose& pose)
                       { return std::hypot(pose.x - mean.x, pose.y - mean.y) <= radius; });
}

/// From the mean of the first half to that of the second.
bool drifts(Iterator begin, Iterator end)
{
    if (end - begin < 2) return false;
    const Iterator middle = begin + (end - begin) / 2;
    const LabelledPose first = meanOf(begin, middle);
    const LabelledPose second = meanOf(middle, end);
    const double duration = (end - 1)->time - begin->time;
    const double allowed = 0.5 * (kDriftSpeed * duration + kDriftDistance);
    return std::hypot(second.x - first.x, second.y - first.y) > allowed;
}
}  // namespace

std::vector<Standstill> standstills(const std::vector<LabelledPose>& poses)
{
    if (poses.empty()) return {};
    if (isWithin(poses.begin(), poses.end(), kRadiusOfAll) && !drifts(poses.begin(), poses.end()))
    {
        return {standstill(poses.begin(), poses.end())};
    }
    std::vector<Standstill> found;
    for (Iterator begin = poses.begin(); begin != poses.end();)
    {
        Iterator end = begin + 1;
        while (end != poses.end() && isWithin(begin, end + 1, kRadius)) ++end;
        const bool isLong = (end - 1)->time - begin->time >= kShortest;
        if (!isLong || drifts(begin, end))
        {
            ++begin;
            continue;
        }
        found.push_back(standstill(begin, end));
        begin = end;
    }
    return found;
}

}  // namespace vdamf
