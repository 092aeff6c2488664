// SPDX-License-Identifier: BSD-3-Clause
#include "regression/metric.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr double kPercent = 100.0;
constexpr double kCentimetres = 100.0;
constexpr int kInFilesOnly = 0;        // width
constexpr double kNoiseOfTimes = 0.5;  // programs run side by side

// clang-format off
const std::vector<Metric> kMetrics = {
    {"frames", "frames", "/scored/frames", "fra-", "mes", 1.0, 5, 0, Better::Neither},
    {"objects", "objects", "/scored/objects", "", "obj", 1.0, 4, 0, Better::Neither},
    {"hota", "HOTA %", "/hota/hota", "", "", kPercent, kInFilesOnly, 2, Better::Higher},
    {"mota", "MOTA %", "/clear_mot/mota", "", "", kPercent, kInFilesOnly, 1, Better::Higher},
    {"idf1", "IDF1 %", "/identity/idf1", "", "", kPercent, kInFilesOnly, 2, Better::Higher},
    {"vehicles_hota", "HOTA of vehicles %", "/vehicles_only/hota/hota", "HOTA", "%", kPercent, 5, 2,
     Better::Higher},
    {"vehicles_mota", "MOTA of vehicles %", "/vehicles_only/clear_mot/mota", "MOTA", "%", kPercent,
     6, 1, Better::Higher},
    {"vehicles_idf1", "IDF1 of vehicles %", "/vehicles_only/identity/idf1", "IDF1", "%", kPercent, 5,
     2, Better::Higher},
    {"recall", "recall %", "/clear_mot/recall", "rec.", "%", kPercent, 5, 2, Better::Higher},
    {"identity_switches", "identity switches", "/clear_mot/identity_switches", "ID", "sw", 1.0,
     4, 0},
    {"flips", "flips of what moves", "/flips_of_moving_objects", "", "flip", 1.0, 5, 0},
    {"front_share", "front right %", "/errors/front_share", "", "", kPercent, kInFilesOnly, 1,
     Better::Higher},
    {"position_median_m", "position cm", "/errors/position_m/median", "pos", "cm", kCentimetres},
    {"position_rms_m", "position RMS cm", "/errors/position_m/rms", "cm", "RMS", kCentimetres},
    {"corner_median_m", "corner cm", "/errors/corner_m/median", "corn", "cm", kCentimetres},
    {"heading_median_deg", "heading deg", "/errors/heading_mod_180_deg/median", "head", "deg"},
    {"heading_rms_deg", "heading RMS deg", "/errors/heading_mod_180_deg/rms", "deg", "RMS"},
    {"speed_rms_mps", "speed RMS m/s", "/errors/speed_mps/rms", "speed", "RMS", 1.0, 6},
    {"yaw_rate_rms_degps", "yaw rate RMS deg/s", "/errors/yaw_rate_degps/rms", "yaw", "rate"},
    {"length_median_m", "length cm", "/errors/length_m/median", "len", "cm", kCentimetres},
    {"width_median_m", "width cm", "/errors/width_m/median", "wid", "cm", kCentimetres},
    {"phantom_speed_p95_mps", "phantom speed m/s", "/phantom_speed_mps/p95", "phan", "m/s"},
    {"standing_scatter_rms_m", "scatter of what stands cm", "/standing_scatter_m/rms", "", "",
     kCentimetres, kInFilesOnly},
    {"nees_speed_mean", "NEES speed", "/consistency/nees_speed/mean", "", "", 1.0, kInFilesOnly, 2,
     Better::NearOne},
    {"nees_size_mean", "NEES size", "/consistency/nees_size/mean", "", "", 1.0, kInFilesOnly, 2,
     Better::NearOne},
    {"nees_pose_mean", "NEES pose", "/consistency/nees_pose/mean", "NEES", "pose", 1.0, 5, 2,
     Better::NearOne},
    {"nis_mean", "NIS", "/consistency/nis_of_tracks_on_objects/mean", "NIS", "", 1.0, 5, 2,
     Better::NearOne},
    {"time_to_first_median_s", "first match s", "/coverage/time_to_first_s/median", "1st", "s"},
    {"time_per_frame_ms", "ms/frame", "", "ms/", "fra.", 1.0, 5, 1, Better::Lower, kNoiseOfTimes}};
// clang-format on

std::optional<double> numberAt(const nlohmann::json& evaluation, const char* pointer)
{
    const nlohmann::json::json_pointer place(pointer);
    if (!evaluation.contains(place))
        throw std::runtime_error(std::string("vdamf-evaluate's JSON has no ") + pointer);
    const nlohmann::json& value = evaluation.at(place);
    if (value.is_null()) return std::nullopt;
    if (!value.is_number())
        throw std::runtime_error(std::string("vdamf-evaluate's JSON: ") + pointer +
                                 " is no number");
    return value.get<double>();
}
}  // namespace

const std::vector<Metric>& metrics()
{
    return kMetrics;
}

std::optional<std::size_t> metricIndex(std::string_view name)
{
    for (std::size_t k = 0; k < kMetrics.size(); ++k)
        if (name == kMetrics[k].name) return k;
    return std::nullopt;
}

MetricValues valuesOf(const nlohmann::json& evaluation, std::optional<double> millisecondsPerFrame)
{
    MetricValues values;
    for (const Metric& metric : kMetrics)
    {
        const bool isEvaluated = *metric.pointer != '\0';
        const std::optional<double> value =
            isEvaluated ? numberAt(evaluation, metric.pointer) : millisecondsPerFrame;
        values.push_back(value ? parseNumber(toFixedText(*value, kCsvDecimals)) : std::nullopt);
    }
    return values;
}

std::string shown(const Metric& metric, std::optional<double> value)
{
    if (!value) return "-";
    constexpr int kWidthInFiles = 6;
    const int width = metric.width > 0 ? metric.width : kWidthInFiles;
    const auto room = static_cast<std::size_t>(width - 1);
    for (int decimals = metric.decimals; decimals > 0; --decimals)
    {
        const std::string text = toFixedText(*value * metric.scale, decimals);
        if (text.size() <= room) return text;
    }
    return toFixedText(*value * metric.scale, 0);
}

}  // namespace vdamf
