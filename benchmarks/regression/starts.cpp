// SPDX-License-Identifier: BSD-3-Clause
#include "regression/starts.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "regression/groups.h"

namespace vdamf
{
namespace
{
constexpr std::array<TitledMetric, 7> kColumns{{{"HOTA", "vehicles_hota"},
                                                {"MOTA", "vehicles_mota"},
                                                {"IDF1", "vehicles_idf1"},
                                                {"recall", "recall"},
                                                {"pos m", "position_rms_m"},
                                                {"head deg", "heading_rms_deg"},
                                                {"speed m/s", "speed_rms_mps"}}};

double deviationOf(const std::vector<double>& values)
{
    if (values.size() < 2) return 0.0;
    const double mean = meanOf(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::string begin(const std::string& name, std::size_t runs)
{
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%-22.22s%4zu", name.c_str(), runs);
    return text.data();
}

std::string spreadLine(const RegressionGroup& group)
{
    std::string line = begin(group.first, group.second.size());
    for (const TitledMetric& column : kColumns)
    {
        const std::vector<double> values = knownValues(group.second, column.metric);
        line += values.empty()
                    ? "              -"
                    : cell("%8.3f", meanOf(values)) + cell(" %5.3f ", deviationOf(values));
    }
    return line + "\n";
}

std::vector<double> changesOf(const RegressionGroup& group,
                              const std::vector<RegressionRow>& before, const char* metric)
{
    const std::size_t column = *metricIndex(metric);
    std::vector<double> changes;
    for (const RegressionRow& row : group.second)
    {
        const RegressionRow* earlier = findRow(before, row.scenario);
        if (earlier == nullptr) continue;
        const auto& was = earlier->values[column];
        const auto& is = row.values[column];
        if (was && is) changes.push_back(*is - *was);
    }
    return changes;
}

std::string changeCell(const std::vector<double>& changes)
{
    constexpr double kSurely = 2.0;
    if (changes.empty()) return "              -";
    const double mean = meanOf(changes);
    const double error = deviationOf(changes) / std::sqrt(static_cast<double>(changes.size()));
    const bool isSure = changes.size() > 1 && std::abs(mean) > kSurely * error;
    return cell("%+8.3f", mean) + cell(" %5.3f", error) + (isSure ? "*" : " ");
}

std::string changeLine(const RegressionGroup& group, const std::vector<RegressionRow>& before)
{
    std::size_t known = 0;
    for (const RegressionRow& row : group.second)
        known += findRow(before, row.scenario) != nullptr ? 1U : 0U;
    std::string line = begin("  change", known);
    for (const TitledMetric& column : kColumns)
        line += changeCell(changesOf(group, before, column.metric));
    return line + "\n";
}
}  // namespace

std::vector<RegressionScenario> withStarts(const std::vector<RegressionScenario>& scenarios,
                                           int count)
{
    const std::string end = ":" + std::to_string(std::numeric_limits<int>::max());
    std::vector<RegressionScenario> all;
    for (const RegressionScenario& scenario : scenarios)
        for (int start = 0; start < count; ++start)
        {
            RegressionScenario one = scenario;
            one.name += "/start_" + std::to_string(start);
            one.track.insert(one.track.end(), {"--frames", std::to_string(start) + end});
            one.score.emplace_back("--tracked-span");
            all.push_back(std::move(one));
        }
    return all;
}

std::string startsTable(const std::vector<RegressionRow>& rows,
                        const std::vector<RegressionRow>& before)
{
    std::string table = "Mean over the starts and standard deviation";
    if (!before.empty()) table += "; mean change and its standard error, * surely one";
    table += "\n" + std::string(26, ' ');
    for (const TitledMetric& column : kColumns)
    {
        std::array<char, 32> title{};
        std::snprintf(title.data(), title.size(), "%15s", column.title);
        table += title.data();
    }
    table += "\n";
    for (const RegressionGroup& group : byScenario(rows))
    {
        table += spreadLine(group);
        if (!before.empty()) table += changeLine(group, before);
    }
    return table;
}

}  // namespace vdamf
