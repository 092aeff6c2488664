// SPDX-License-Identifier: BSD-3-Clause
#include "heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "html.h"
#include "key_axis.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr double kLeastFieldWidth = 74.0;
constexpr double kLetterWidth = 7.0;
constexpr double kFieldHeight = 34.0;
constexpr double kMapLeft = 130.0;
constexpr double kMapTop = 30.0;
constexpr double kMapBottom = 52.0;
constexpr double kMapRight = 12.0;
constexpr std::size_t kMostFields = 24;

// Matplotlib's viridis at five places: even in lightness, also for the colour-blind.
constexpr std::array<std::array<double, 3>, 5> kViridis = {
    {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};

std::string colourAt(double share)
{
    const double place = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
    const double rest = place - static_cast<double>(low);
    std::string colour = "rgb(";
    for (std::size_t c = 0; c < 3; ++c)
    {
        const double level = kViridis[low][c] + rest * (kViridis[low + 1][c] - kViridis[low][c]);
        colour += (c > 0 ? "," : "") + std::to_string(std::lround(level));
    }
    return colour + ")";
}

struct Field
{
    double sum = 0.0;
    int count = 0;
    double mean() const { return sum / count; }
};

struct HeatMap
{
    KeyAxis across;
    KeyAxis up;
    std::vector<Field> fields;  ///< row by row
    double least = 0.0;
    double most = 0.0;
    double fieldWidth = kLeastFieldWidth;  ///< room for the longest value below it

    double left(std::size_t x) const { return kMapLeft + fieldWidth * static_cast<double>(x); }
    const Field& at(std::size_t x, std::size_t y) const
    {
        return fields[y * across.values.size() + x];
    }
};

void findRange(HeatMap& map)
{
    bool isFirst = true;
    for (const Field& field : map.fields)
    {
        if (field.count == 0) continue;
        map.least = isFirst ? field.mean() : std::min(map.least, field.mean());
        map.most = isFirst ? field.mean() : std::max(map.most, field.mean());
        isFirst = false;
    }
}

std::string text(double x, double y, const std::string& content, const std::string& attributes)
{
    return "<text x=\"" + toFixedText(x, 1) + "\" y=\"" + toFixedText(y, 1) + "\" " + attributes +
           ">" + escapedHtml(content) + "</text>\n";
}

double top(const HeatMap& map, std::size_t y)
{
    return kMapTop + kFieldHeight * static_cast<double>(map.up.values.size() - 1 - y);
}

std::string fieldSvg(const HeatMap& map, std::size_t x, std::size_t y)
{
    const Field& field = map.at(x, y);
    if (field.count == 0) return "";
    const double range = map.most - map.least;
    const double share = range > 0.0 ? (field.mean() - map.least) / range : 0.5;
    const double left = map.left(x);
    const std::string value = shownNumber(field.mean());
    return "<rect x=\"" + toFixedText(left, 1) + "\" y=\"" + toFixedText(top(map, y), 1) +
           "\" width=\"" + toFixedText(map.fieldWidth - 1.0, 1) + "\" height=\"" +
           toFixedText(kFieldHeight - 1.0, 1) + "\" fill=\"" + colourAt(share) + "\"><title>" +
           escapedHtml(map.across.axis.label + " = " + map.across.values[x] + ", " +
                       map.up.axis.label + " = " + map.up.values[y] + ": " + value) +
           "</title></rect>\n" +
           text(left + 0.5 * map.fieldWidth, top(map, y) + 0.5 * kFieldHeight + 4.0, value,
                std::string("class=\"") + (share > 0.6 ? "on-light" : "on-dark") +
                    "\" text-anchor=\"middle\"");
}

std::string labelsSvg(const HeatMap& map, double width, double height)
{
    std::string svg;
    for (std::size_t x = 0; x < map.across.values.size(); ++x)
        svg += text(map.left(x) + 0.5 * map.fieldWidth, height - kMapBottom + 18.0,
                    map.across.values[x], "text-anchor=\"middle\"");
    for (std::size_t y = 0; y < map.up.values.size(); ++y)
        svg += text(kMapLeft - 8.0, top(map, y) + 0.5 * kFieldHeight + 4.0, map.up.values[y],
                    "text-anchor=\"end\"");
    svg += text(0.5 * (kMapLeft + width - kMapRight), height - 12.0, map.across.axis.label,
                "text-anchor=\"middle\"");
    const std::string middle = toFixedText(0.5 * (kMapTop + height - kMapBottom), 1);
    return svg + text(14.0, 0.5 * (kMapTop + height - kMapBottom), map.up.axis.label,
                      "text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle + ")\"");
}

HeatMap heatMap(const SweepResults& results, std::size_t metric, std::size_t across, std::size_t up)
{
    HeatMap map{keyAxis(results, across), keyAxis(results, up), {}};
    map.across.axis.label = results.keys[across];
    map.up.axis.label = results.keys[up];
    for (const std::string& value : map.across.values)
        map.fieldWidth =
            std::max(map.fieldWidth, kLetterWidth * static_cast<double>(value.size() + 2));
    map.fields.resize(map.across.values.size() * map.up.values.size());
    for (const SweepRow& row : results.rows)
    {
        if (!row.failure.empty() || !row.values[metric]) continue;
        Field& field = map.fields[map.up.ofSetting[row.setting] * map.across.values.size() +
                                  map.across.ofSetting[row.setting]];
        field.sum += *row.values[metric];
        ++field.count;
    }
    findRange(map);
    return map;
}
}  // namespace

std::string heatMapSvg(const SweepResults& results, std::size_t metric, std::size_t across,
                       std::size_t up)
{
    const HeatMap map = heatMap(results, metric, across, up);
    const std::size_t columns = map.across.values.size();
    const std::size_t rows = map.up.values.size();
    const auto filled = std::count_if(map.fields.begin(), map.fields.end(),
                                      [](const Field& field) { return field.count > 0; });
    const bool isGrid = 2 * static_cast<std::size_t>(filled) > map.fields.size();
    if (columns > kMostFields || rows > kMostFields || !isGrid) return "";
    const double width = map.left(columns) + kMapRight;
    const double height = kMapTop + kFieldHeight * static_cast<double>(rows) + kMapBottom;
    const std::string size = toFixedText(width, 0) + " " + toFixedText(height, 0);
    std::string svg = "<svg viewBox=\"0 0 " + size + "\" width=\"" + toFixedText(width, 0) +
                      "\" role=\"img\">\n" +
                      text(kMapLeft, 18.0, results.metrics[metric], "font-weight=\"bold\"");
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < columns; ++x) svg += fieldSvg(map, x, y);
    return svg + labelsSvg(map, width, height) + "</svg>\n";
}

}  // namespace vdamf
