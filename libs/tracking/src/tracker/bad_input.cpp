// SPDX-License-Identifier: BSD-3-Clause
#include "tracker/bad_input.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "types/time_range.h"

namespace vdamf
{
namespace
{
// Hits at times that are not finite are dropped later on.
bool haveSenseAsTimes(const std::vector<float>& times)
{
    constexpr float kLongestScan = 10.0F;  // s to either side of the frame's time
    const TimeRange range = timeRangeOf(times);
    return range.first > range.last || (range.first >= -kLongestScan && range.last <= kLongestScan);
}

bool isWhole(const PointCloud& points)
{
    const auto isFull = [&](const std::vector<float>& values, bool mayBeEmpty)
    { return values.size() == points.size() || (mayBeEmpty && values.empty()); };
    return isFull(points.y, false) && isFull(points.z, false) && isFull(points.intensity, true) &&
           isFull(points.time, true);
}
}  // namespace

void refuseBad(const LadarFrame& frame, const std::optional<double>& before)
{
    if (!std::isfinite(frame.time) || (before && frame.time <= *before))
        throw std::invalid_argument("frames must come in order of time");
    if (!frame.origin.allFinite() || !frame.sensor.allFinite())
        throw std::invalid_argument("origin and sensor of a frame must be finite");
    if (!isWhole(frame.points))
        throw std::invalid_argument("coordinates of the points of a frame must be equally many");
    if (!haveSenseAsTimes(frame.points.time))
        throw std::invalid_argument(
            "times of the points of a frame must be seconds, within 10 s of the frame's own");
}

const TrackerOptions& checked(const TrackerOptions& options)
{
    const std::vector<std::string> problems = options.problems();
    if (problems.empty()) return options;
    std::string text = "bad tracker options:";
    for (const std::string& p : problems) text += "\n  " + p;
    throw std::invalid_argument(text);
}

}  // namespace vdamf
