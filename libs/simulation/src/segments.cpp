// SPDX-License-Identifier: BSD-3-Clause
// Motion segments as text in a scenario file.
#include "vdamf/simulation/segments.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "vdamf/files/numbers.h"
#include "vdamf/files/text_file.h"

namespace vdamf
{
namespace
{
constexpr std::string_view kBlanks = " \t";

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

std::optional<MotionSegment> parseSegment(std::string_view text)
{
    const std::vector<std::string_view> parts = words(text);
    if (parts.size() != 3) return std::nullopt;
    const std::optional<double> duration = parseNumber(parts[0]);
    const std::optional<double> acceleration = parseNumber(parts[1]);
    const std::optional<double> curvature = parseNumber(parts[2]);
    if (!duration || !acceleration || !curvature) return std::nullopt;
    const bool isInRange = *duration > 0.0 && *duration <= 3600.0 &&
                           std::abs(*acceleration) <= 20.0 && std::abs(*curvature) <= 1.0;
    if (!isInRange) return std::nullopt;
    return MotionSegment{*duration, *acceleration, *curvature};
}
}  // namespace

std::vector<MotionSegment> parseSegments(std::string_view text)
{
    std::vector<MotionSegment> segments;
    if (trimmed(text).empty()) return segments;
    std::size_t begin = 0;
    while (begin <= text.size())
    {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view part = text.substr(begin, end - begin);
        const std::optional<MotionSegment> segment = parseSegment(part);
        if (!segment)
        {
            throw std::runtime_error(
                "segment " + std::to_string(segments.size() + 1) + " is " +
                inQuotes(trimmed(part)) +
                ": expected duration_s (above 0, to 3600), acceleration_mps2 (-20 to 20) and "
                "curvature_1pm (-1 to 1) with blanks between, and commas between segments");
        }
        segments.push_back(*segment);
        begin = end + 1;
    }
    return segments;
}

}  // namespace vdamf
