// SPDX-License-Identifier: BSD-3-Clause
#include "regression/comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "regression/groups.h"

namespace vdamf
{
namespace
{
constexpr std::size_t kLineWidth = 125;

// How bad a value is: less is better.
double badness(Better better, double value)
{
    if (better == Better::Lower) return value;
    if (better == Better::Higher) return -value;
    return value > 0.0 ? std::abs(std::log(value)) : std::numeric_limits<double>::infinity();
}

bool isChange(const Metric& metric, const std::optional<double>& before,
              const std::optional<double>& after)
{
    if (shown(metric, before) == shown(metric, after)) return false;
    return !before || !after || std::abs(*after - *before) > metric.noise * std::abs(*before);
}

Trend trendOf(const Metric& metric, const std::optional<double>& before,
              const std::optional<double>& after)
{
    if (!before || !after || metric.better == Better::Neither) return Trend::Changed;
    const double change = badness(metric.better, *after) - badness(metric.better, *before);
    return change < 0.0 ? Trend::Better : Trend::Worse;
}

std::vector<Change> changesOf(const RegressionRow& before, const RegressionRow& after)
{
    std::vector<Change> changes;
    for (std::size_t k = 0; k < metrics().size(); ++k)
    {
        const Metric& metric = metrics()[k];
        const std::optional<double>& was = before.values[k];
        const std::optional<double>& is = after.values[k];
        if (isChange(metric, was, is))
            changes.push_back({after.scenario, k, was, is, trendOf(metric, was, is)});
    }
    return changes;
}

// "title  one, two, three": in as many lines as it takes, the others indented.
std::string wrapped(const std::string& title, const std::vector<std::string>& items)
{
    std::string text;
    std::string line = title;
    for (std::size_t i = 0; i < items.size(); ++i)
    {
        const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
        if (line.size() + 1 + item.size() > kLineWidth)
        {
            text += line + "\n";
            line = std::string(title.size(), ' ');
        }
        line += " " + item;
    }
    return text + line + "\n";
}

std::string column(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size()), ' ');
    return text;
}

std::string linesOf(const Comparison& comparison, const std::string& scenario)
{
    constexpr std::size_t kNameWidth = 24;
    constexpr std::size_t kTrendWidth = 8;
    std::string lines;
    for (const auto& [trend, word] :
         {std::pair{Trend::Better, "better"}, {Trend::Worse, "WORSE"}, {Trend::Changed, "changed"}})
    {
        std::vector<std::string> items;
        for (const Change& change : comparison.changes)
        {
            const Metric& metric = metrics()[change.metric];
            if (change.scenario == scenario && change.trend == trend)
                items.push_back(std::string(metric.title) + " " + shown(metric, change.before) +
                                " -> " + shown(metric, change.after));
        }
        if (items.empty()) continue;
        const std::string name = column(lines.empty() ? scenario : "", kNameWidth);
        lines += wrapped(name + column(word, kTrendWidth), items);
    }
    return lines;
}

std::string tally(const Comparison& comparison)
{
    std::vector<std::string> items;
    for (std::size_t k = 0; k < metrics().size(); ++k)
    {
        const auto count = [&](Trend trend)
        {
            return std::count_if(comparison.changes.begin(), comparison.changes.end(),
                                 [&](const Change& change)
                                 { return change.metric == k && change.trend == trend; });
        };
        if (count(Trend::Better) + count(Trend::Worse) == 0) continue;
        items.push_back(std::string(metrics()[k].title) + " " +
                        std::to_string(count(Trend::Better)) + "/" +
                        std::to_string(count(Trend::Worse)));
    }
    return items.empty() ? "" : wrapped("scenarios better/worse:", items);
}
}  // namespace

Comparison compared(const std::vector<RegressionRow>& before,
                    const std::vector<RegressionRow>& after)
{
    Comparison comparison;
    for (const RegressionRow& row : after)
    {
        const RegressionRow* old = findRow(before, row.scenario);
        if (old == nullptr)
        {
            comparison.onlyAfter.push_back(row.scenario);
            continue;
        }
        const std::vector<Change> changes = changesOf(*old, row);
        if (changes.empty()) comparison.unchanged.push_back(row.scenario);
        comparison.changes.insert(comparison.changes.end(), changes.begin(), changes.end());
    }
    for (const RegressionRow& row : before)
        if (findRow(after, row.scenario) == nullptr) comparison.onlyBefore.push_back(row.scenario);
    return comparison;
}

std::string inWords(const Comparison& comparison)
{
    std::string text;
    std::string last;
    for (const Change& change : comparison.changes)
    {
        if (change.scenario != last) text += linesOf(comparison, change.scenario);
        last = change.scenario;
    }
    if (!comparison.unchanged.empty()) text += wrapped("unchanged:", comparison.unchanged);
    if (!comparison.onlyBefore.empty())
        text += wrapped("in the old table only:", comparison.onlyBefore);
    if (!comparison.onlyAfter.empty())
        text += wrapped("not in the old table:", comparison.onlyAfter);
    return text + tally(comparison);
}

}  // namespace vdamf
