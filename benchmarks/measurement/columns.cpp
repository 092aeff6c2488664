// SPDX-License-Identifier: BSD-3-Clause
#include "measurement/columns.h"

#include <algorithm>
#include <cmath>

#include "vdamf/files/numbers.h"

namespace vdamf
{
const std::vector<Column>& columns()
{
    using S = const CaseSummary&;
    // clang-format off
    static const std::vector<Column> all = {
        {"heading90_median_deg", "hdg", 6, 2, [](S s) { return s.heading90.median; }},
        {"heading90_p90_deg", "p90", 6, 2, [](S s) { return s.heading90.p90; }},
        {"heading180_median_deg", "", 0, 3, [](S s) { return s.heading180.median; }},
        {"heading180_p90_deg", "", 0, 3, [](S s) { return s.heading180.p90; }},
        {"crossed_percent", "cross%", 7, 0, [](S s) { return 100.0 * s.crossed; }},
        {"corner_median_m", "corner", 7, 3, [](S s) { return s.corner.median; }},
        {"corner_p90_m", "p90", 6, 2, [](S s) { return s.corner.p90; }},
        {"end_bias_m", "end+-", 7, 3, [](S s) { return s.end.bias; }},
        {"end_median_m", "|end|", 6, 3, [](S s) { return s.end.median; }},
        {"end_p90_m", "p90", 6, 2, [](S s) { return s.end.p90; }},
        {"end_count", "", 0, 0, [](S s) { return static_cast<double>(s.end.count); }},
        {"side_bias_m", "side+-", 7, 3, [](S s) { return s.side.bias; }},
        {"side_median_m", "|side|", 7, 3, [](S s) { return s.side.median; }},
        {"side_p90_m", "p90", 6, 2, [](S s) { return s.side.p90; }},
        {"side_count", "", 0, 0, [](S s) { return static_cast<double>(s.side.count); }},
        {"length_bias_m", "len+-", 6, 2, [](S s) { return s.length.bias; }},
        {"length_median_m", "|len|", 6, 2, [](S s) { return s.length.median; }},
        {"length_p90_m", "", 0, 3, [](S s) { return s.length.p90; }},
        {"width_bias_m", "wid+-", 6, 2, [](S s) { return s.width.bias; }},
        {"width_median_m", "|wid|", 6, 2, [](S s) { return s.width.median; }},
        {"width_p90_m", "", 0, 3, [](S s) { return s.width.p90; }},
        {"both_faces_count", "", 0, 0, [](S s) { return static_cast<double>(s.length.count); }},
        {"iou_median", "IoU", 5, 2, [](S s) { return s.iouMedian; }},
        {"iou_p10", "p10", 5, 2, [](S s) { return s.iouP10; }},
        {"nees_mean", "NEES", 8, 2, [](S s) { return s.neesMean; }},
        {"nees_band_low", "low", 5, 2, [](S s) { return s.neesLow; }},
        {"nees_band_high", "high", 5, 2, [](S s) { return s.neesHigh; }},
        {"nees_scale", "scale", 7, 2, [](S s) { return s.neesScale; }},
        {"nees_count", "", 0, 0, [](S s) { return static_cast<double>(s.neesCount); }},
        {"within68_percent", "68%", 4, 0, [](S s) { return 100.0 * s.within68; }},
        {"within95_percent", "95%", 4, 0, [](S s) { return 100.0 * s.within95; }},
        {"within99_percent", "99%", 4, 0, [](S s) { return 100.0 * s.within99; }},
        {"iterations_median", "iter", 5, 0, [](S s) { return s.iterations; }},
        {"failed_percent", "fail%", 6, 1, [](S s) { return 100.0 * s.failed; }},
        {"time_us", "us", 7, 0, [](S s) { return s.microseconds; }},
    };
    // clang-format on
    return all;
}

std::string cell(double value, int decimals, int width)
{
    // What does not fit tells no more than its size.
    constexpr double kMany = 9999.0;
    std::string text;
    if (std::isfinite(value))
        text = std::abs(value) > kMany ? (value > 0.0 ? ">9999" : "<-9999")
                                       : toFixedText(value, decimals);
    const auto characters = static_cast<std::size_t>(width);
    return std::string(characters - std::min(characters, text.size()), ' ') + text;
}

}  // namespace vdamf
