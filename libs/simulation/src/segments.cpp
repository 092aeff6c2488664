// SPDX-License-Identifier: BSD-3-Clause
// Motion as text in a scenario file.
#include "vdamf/simulation/segments.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"
#include "vdamf/simulation/manoeuvres.h"
#include "vdamf/tracking/types/geometry.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kBlanks = " \t";

const char* const kExpected =
    "expected duration_s (above 0, to 3600), acceleration_mps2 (-20 to 20), curvature_1pm (-1 to "
    "1) and maybe the curvature at the end, or one of: keep DURATION_S, speed_to SPEED_MPS "
    "ACCELERATION_MPS2, stop ACCELERATION_MPS2, turn ANGLE_DEG RADIUS_M, lane_change OFFSET_M "
    "DURATION_S; with blanks between, and commas between segments";

std::vector<std::string_view> words(std::string_view text)
{
    std::vector<std::string_view> found;
    std::size_t begin = text.find_first_not_of(kBlanks);
    while (begin != std::string_view::npos)
    {
        const std::size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
        found.push_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(kBlanks, end);
    }
    return found;
}

/// All words from `first` on as numbers.
std::vector<double> numbers(const std::vector<std::string_view>& parts, std::size_t first)
{
    std::vector<double> values;
    for (std::size_t i = first; i < parts.size(); ++i)
    {
        const std::optional<double> value = parseNumber(parts[i]);
        if (!value) throw std::runtime_error(kExpected);
        values.push_back(*value);
    }
    return values;
}

MotionSegment plainSegment(const std::vector<double>& v)
{
    const bool isInRange = (v.size() == 3 || v.size() == 4) && v[0] > 0.0 && v[0] <= 3600.0 &&
                           std::abs(v[1]) <= 20.0 && std::abs(v[2]) <= 1.0 &&
                           std::abs(v.back()) <= (v.size() == 4 ? 1.0 : 20.0);
    if (!isInRange) throw std::runtime_error(kExpected);
    MotionSegment segment{v[0], v[1], v[2], {}};
    if (v.size() == 4) segment.endCurvature = v[3];
    return segment;
}

std::vector<MotionSegment> parseItem(std::string_view text, double speed)
{
    const std::vector<std::string_view> parts = words(text);
    if (parts.empty()) throw std::runtime_error(kExpected);
    if (parseNumber(parts[0])) return {plainSegment(numbers(parts, 0))};
    const std::vector<double> v = numbers(parts, 1);
    const std::string_view name = parts[0];
    if (name == "keep" && v.size() == 1) return keep(v[0]);
    if (name == "speed_to" && v.size() == 2) return speedTo(speed, v[0], v[1]);
    if (name == "stop" && v.size() == 1) return speedTo(speed, 0.0, v[0]);
    if (name == "turn" && v.size() == 2) return turn(speed, v[0] * kPi / 180.0, v[1]);
    if (name == "lane_change" && v.size() == 2) return laneChange(speed, v[0], v[1]);
    throw std::runtime_error(kExpected);
}
}  // namespace

std::vector<MotionSegment> parseSegments(std::string_view text, double speed)
{
    std::vector<MotionSegment> segments;
    if (trimmed(text).empty()) return segments;
    std::size_t begin = 0;
    for (int item = 1; begin <= text.size(); ++item)
    {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, end - begin);
        try
        {
            for (const MotionSegment& segment : parseItem(part, speed))
            {
                segments.push_back(segment);
                speed += segment.acceleration * segment.duration;
            }
        }
        catch (const std::runtime_error& error)
        {
            throw std::runtime_error("segment " + std::to_string(item) + " is " +
                                     inQuotes(trimmed(part)) + ": " + error.what());
        }
        if (std::abs(speed) < 1e-9) speed = 0.0;
        begin = end + 1;
    }
    return segments;
}

}  // namespace vdamf
