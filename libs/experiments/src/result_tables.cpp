// SPDX-License-Identifier: BSD-3-Clause
#include "result_tables.h"

#include "html.h"
#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
// Long names may break behind their dots and underscores.
std::string head(const std::string& name, bool isText = false)
{
    std::string text;
    for (const char c : escapedHtml(name))
    {
        text += c;
        if (c == '.' || c == '_') text += "<wbr>";
    }
    return (isText ? "<th class=\"text\">" : "<th>") + text + "</th>";
}

std::string textCell(const std::string& text, const std::string& more = "")
{
    return "<td class=\"text" + more + "\">" + escapedHtml(text) + "</td>";
}

// Sorted by the number itself and not by what is shown of it.
std::string numberCell(std::optional<double> value)
{
    return "<td data-v=\"" + (value ? toText(*value) : "") + "\">" + shownNumber(value) + "</td>";
}

std::string valueCell(const std::string& value)
{
    const std::optional<double> number = parseNumber(value);
    if (!number) return textCell(value);
    return "<td data-v=\"" + toText(*number) + "\">" + escapedHtml(value) + "</td>";
}

std::string keyHeads(const SweepResults& results)
{
    std::string heads;
    for (std::size_t k = 0; k < results.keys.size(); ++k)
        heads += head(results.keys[k], !parseNumber(results.settings.front().values[k]));
    return heads;
}

std::string table(const std::string& heads, const std::string& rows)
{
    return "<div class=\"scroll\"><table><thead><tr>" + heads + "</tr></thead><tbody>\n" + rows +
           "</tbody></table></div>\n";
}
}  // namespace

std::string settingsTable(const SweepResults& results)
{
    std::string heads = head("setting") + keyHeads(results);
    for (const std::string& metric : results.metrics) heads += head(metric);
    heads += head("ms per frame") + head("failed runs");
    const std::vector<SettingSummary> all = summaries(results);
    const std::optional<std::size_t> best = bestSetting(results);
    std::string rows;
    for (std::size_t s = 0; s < all.size(); ++s)
    {
        rows += "<tr id=\"setting-" + std::to_string(s + 1) + "\"" +
                (best == s ? " class=\"best\">" : ">") + numberCell(static_cast<double>(s + 1));
        for (const std::string& value : results.settings[s].values) rows += valueCell(value);
        for (const auto& mean : all[s].means) rows += numberCell(mean);
        rows += numberCell(all[s].msPerFrame) + numberCell(static_cast<double>(all[s].failures)) +
                "</tr>\n";
    }
    return table(heads, rows);
}

std::string runsTable(const SweepResults& results)
{
    std::string heads = head("setting") + head("recording", true) + keyHeads(results);
    for (const std::string& metric : results.metrics) heads += head(metric);
    heads += head("ms per frame") + head("run", true);
    std::string rows;
    for (const SweepRow& row : results.rows)
    {
        const bool failed = !row.failure.empty();
        rows += "<tr>" + numberCell(static_cast<double>(row.setting + 1)) +
                textCell(results.recordings[row.recording]);
        for (const std::string& value : results.settings[row.setting].values)
            rows += valueCell(value);
        for (std::size_t k = 0; k < results.metrics.size(); ++k)
            rows += numberCell(failed ? std::nullopt : row.values[k]);
        rows +=
            numberCell(failed ? std::nullopt : std::optional<double>(row.times.trackingMsPerFrame));
        rows += failed ? textCell("failed: " + row.failure, " failed")
                       : textCell(row.run.substr(0, 12));
        rows += "</tr>\n";
    }
    return table(heads, rows);
}

}  // namespace vdamf
