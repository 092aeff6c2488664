// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/sweep_page.h"

#include "heat_map.h"
#include "html.h"
#include "key_charts.h"
#include "page_style.h"
#include "pareto_chart.h"
#include "result_tables.h"

namespace vdamf
{
namespace
{
std::string card(const std::string& value, const std::string& what, const std::string& style = "")
{
    return "<div class=\"card" + style + "\"><b>" + value + "</b><span>" + what + "</span></div>\n";
}

std::string counted(std::size_t count, const std::string& what)
{
    return card(std::to_string(count), what + (count == 1 ? "" : "s"));
}

std::string bestCard(const SweepResults& results)
{
    const std::optional<std::size_t> best = bestSetting(results);
    const std::string metric = escapedHtml(results.goal.metric);
    if (!best) return card("none", "no setting has " + metric + " in all recordings", " best");
    std::string what = std::string(results.goal.highest ? "highest" : "lowest") + " mean of " +
                       metric + ": setting " + std::to_string(*best + 1) + "<br>";
    for (std::size_t k = 0; k < results.keys.size(); ++k)
        what += "<code>" +
                escapedHtml(results.keys[k] + " = " + results.settings[*best].values[k]) +
                "</code><br>";
    return card(shownNumber(summaries(results)[*best].means[goalIndex(results)]), what, " best");
}

std::string overview(const SweepResults& results)
{
    std::size_t failures = 0;
    for (const SweepRow& row : results.rows) failures += row.failure.empty() ? 0 : 1;
    std::string cards = "<div class=\"cards\">\n" + bestCard(results) +
                        counted(results.settings.size(), "setting") +
                        counted(results.recordings.size(), "recording") +
                        counted(results.rows.size(), "run");
    if (failures > 0) cards += card(std::to_string(failures), "failed", " best");
    cards += "</div>\n";
    for (const std::string& name : silentRecordings(results))
        cards += "<p>" + escapedHtml(name) + " has no " + escapedHtml(results.goal.metric) +
                 " with any setting, and does not count.</p>\n";
    return cards;
}

std::string metricChoice(const SweepResults& results)
{
    std::string options;
    for (const std::string& metric : results.metrics)
        options += "<option" + std::string(metric == results.goal.metric ? " selected>" : ">") +
                   escapedHtml(metric) + "</option>";
    return "<label>Metric<select id=\"metric\">" + options +
           "<option value=\"*\">all</option></select></label>\n";
}

std::string forMetric(const SweepResults& results, std::size_t metric, const std::string& style,
                      const std::string& content)
{
    return "<div class=\"" + style + "\" data-metric=\"" + escapedHtml(results.metrics[metric]) +
           "\">" + content + "</div>\n";
}

std::string keyCharts(const SweepResults& results)
{
    std::string html = "<div class=\"plots\">\n";
    for (std::size_t m = 0; m < results.metrics.size(); ++m)
        for (std::size_t k = 0; k < results.keys.size(); ++k)
            html += forMetric(results, m, "plot", chartsSvg({keyChart(results, m, k)}));
    return html + "</div>\n";
}

// Nothing where no two keys make a grid.
std::string heatMaps(const SweepResults& results)
{
    std::string html;
    for (std::size_t m = 0; m < results.metrics.size(); ++m)
    {
        for (std::size_t up = 0; up < results.keys.size(); ++up)
        {
            for (std::size_t across = up + 1; across < results.keys.size(); ++across)
            {
                const std::string svg = heatMapSvg(results, m, across, up);
                if (!svg.empty()) html += forMetric(results, m, "map", svg);
            }
        }
    }
    if (html.empty()) return "";
    return "<h2>Two keys together</h2>\n<p>Means over the recordings and over all other keys.</p>\n"
           "<div class=\"plots\">\n" +
           html + "</div>\n";
}

std::string pareto(const SweepResults& results)
{
    const std::string svg = paretoSvg(results);
    if (svg.empty()) return "";
    return "<h2>Accuracy against time</h2>\n<p>Each point is a setting; the line joins those that "
           "no other one beats in both. Runs went on side by side: compare times within this page "
           "only. Click a point for its row.</p>\n" +
           svg;
}
}  // namespace

std::string sweepPage(const SweepResults& results, const std::string& title)
{
    const std::string name = escapedHtml(title);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
           name + " \u2013 sweep</title>\n<style>" + kPageStyle +
           "</style>\n</head>\n<body>\n<h1>" + name + "</h1>\n" + overview(results) +
           "<h2>One key at a time</h2>\n" +
           "<p>Points: recordings, each with its mean over all other keys, or runs where each "
           "setting has a value of its own. Line: mean of the recordings.</p>\n" +
           metricChoice(results) + keyCharts(results) + heatMaps(results) + pareto(results) +
           "<h2>Settings</h2>\n<p>Means over the recordings. A dash: a run failed, or its metric "
           "is not known. Click a heading to sort.</p>\n" +
           settingsTable(results) + "<details><summary>All runs</summary>\n" + runsTable(results) +
           "</details>\n<script>" + kPageScript + "</script>\n</body>\n</html>\n";
}

}  // namespace vdamf
