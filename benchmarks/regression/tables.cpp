// SPDX-License-Identifier: BSD-3-Clause
#include "regression/tables.h"

#include <algorithm>

#include "vdamf/files/csv.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kNameWidth = 20;

std::string rightAligned(const std::string& text, int width)
{
    const auto characters = static_cast<std::size_t>(width);
    return std::string(characters - std::min(characters, text.size()), ' ') + text;
}

std::string nameCell(const std::string& name)
{
    if (name.size() > kNameWidth) return name.substr(0, kNameWidth - 1) + "~";
    return name + std::string(kNameWidth - name.size(), ' ');
}

std::string terminalLine(const RegressionRow& row)
{
    std::string line = nameCell(row.scenario);
    for (std::size_t k = 0; k < metrics().size(); ++k)
        if (metrics()[k].width > 0)
            line += rightAligned(shown(metrics()[k], row.values[k]), metrics()[k].width);
    return line + "\n";
}

std::optional<double> median(std::vector<double> values)
{
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

RegressionRow medians(const std::vector<RegressionRow>& rows)
{
    RegressionRow middle{"median", {}};
    for (std::size_t k = 0; k < metrics().size(); ++k)
    {
        std::vector<double> known;
        for (const RegressionRow& row : rows)
            if (row.values[k]) known.push_back(*row.values[k]);
        middle.values.push_back(median(known));
    }
    return middle;
}

std::string markdownLine(const RegressionRow& row)
{
    std::string line = "| " + row.scenario + " |";
    for (std::size_t k = 0; k < metrics().size(); ++k)
        line += " " + shown(metrics()[k], row.values[k]) + " |";
    return line + "\n";
}
}  // namespace

std::string terminalTable(const std::vector<RegressionRow>& rows)
{
    std::string table = nameCell("");
    for (const Metric& metric : metrics()) table += rightAligned(metric.group, metric.width);
    table += "\n" + nameCell("");
    for (const Metric& metric : metrics()) table += rightAligned(metric.heading, metric.width);
    table += "\n";
    for (const RegressionRow& row : rows) table += terminalLine(row);
    return table + terminalLine(medians(rows));
}

std::string markdownTable(const std::vector<RegressionRow>& rows)
{
    std::string table = "| scenario |";
    std::string rule = "|---|";
    for (const Metric& metric : metrics())
    {
        table += std::string(" ") + metric.title + " |";
        rule += "---:|";
    }
    table += "\n" + rule + "\n";
    for (const RegressionRow& row : rows) table += markdownLine(row);
    return table + markdownLine(medians(rows));
}

std::string tableLegend()
{
    return "Medians but where RMS is said: position, corner (nearest to the sensor), heading "
           "(modulo "
           "180 deg), length, width, first match.\n"
           "speed (m/s) and yaw rate (deg/s): RMS; phan: 95th percentile of the speed of what "
           "stands still; NEES, NIS: 1 is right.\n"
           "ms/fra.: tracking alone, while other runs go on beside it. A track off the labels is a "
           "false alarm to HOTA, MOTA and IDF1;\n"
           "of vehicles: where it is taken for one (is_vehicle), or nothing tells.\n";
}

std::string toCsv(const std::vector<RegressionRow>& rows)
{
    std::string table = "scenario";
    for (const Metric& metric : metrics()) table += std::string(",") + metric.name;
    table += "\n";
    for (const RegressionRow& row : rows)
    {
        table += row.scenario;
        for (std::size_t k = 0; k < metrics().size(); ++k)
        {
            const int decimals = metrics()[k].decimals == 0 ? 0 : kCsvDecimals;
            table += "," + (row.values[k] ? toFixedText(*row.values[k], decimals) : "");
        }
        table += "\n";
    }
    return table;
}

std::vector<RegressionRow> readRegressionTable(const std::filesystem::path& path)
{
    std::vector<RegressionRow> rows;
    CsvReader reader(path, {"scenario"});
    while (reader.next())
    {
        RegressionRow row{reader.text("scenario"), {}};
        for (const Metric& metric : metrics())
        {
            const bool isThere = reader.hasColumn(metric.name);
            row.values.push_back(isThere ? reader.optionalNumber(metric.name) : std::nullopt);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace vdamf
