// SPDX-License-Identifier: BSD-3-Clause
// The columns of the regression table: where each number comes from, how it is shown, and which
// way is better.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vdamf
{
enum class Better
{
    Lower,
    Higher,
    NearOne,  ///< ratios: 2 is as bad as 0.5
    Neither   ///< describes the scenario
};

struct Metric
{
    const char* name;     ///< in CSV files, with its unit; ratios are shares, not per cent
    const char* title;    ///< in words, with the unit in which it is printed
    const char* pointer;  ///< where it stands in vdamf-evaluate's JSON; empty: not there
    const char* group;    ///< upper line of the heading in printed tables
    const char* heading;  ///< lower line
    double scale = 1.0;   ///< from the CSV's unit to the printed one
    int width = 5;     ///< characters in tables on a terminal with the blank before; 0: not there
    int decimals = 2;  ///< at most
    Better better = Better::Lower;
    double noise = 0.0;  ///< relative change that means nothing
};

/// All columns, in their order.
const std::vector<Metric>& metrics();

/// Its place in metrics(); nothing if there is no such metric.
std::optional<std::size_t> metricIndex(std::string_view name);

/// Decimals in CSV files.
constexpr int kCsvDecimals = 5;

/// One value per metric; nothing: not known.
using MetricValues = std::vector<std::optional<double>>;

/// What one scenario came to.
struct RegressionRow
{
    std::string scenario;
    MetricValues values;
};

/// Where the JSON of what is taken for vehicles stands in that of all tracks.
inline constexpr const char* kVehiclesOnly = "vehicles_only";

/// From what vdamf-evaluate wrote and from the time that vdamf-track told, rounded as in CSV files,
/// so that a table and its file never differ. Throws std::runtime_error where a key is missing or
/// is no number.
MetricValues valuesOf(const nlohmann::json& evaluation, std::optional<double> millisecondsPerFrame);

/// The value in its printed unit with as many decimals as its column has room for; "-"
/// where it is not known.
std::string shown(const Metric& metric, std::optional<double> value);

}  // namespace vdamf
