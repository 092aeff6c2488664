// SPDX-License-Identifier: BSD-3-Clause
#include "regression/groups.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace vdamf
{
std::vector<RegressionGroup> byScenario(const std::vector<RegressionRow>& rows)
{
    std::vector<RegressionGroup> groups;
    for (const RegressionRow& row : rows)
    {
        const std::string name = row.scenario.substr(0, row.scenario.find('/'));
        if (groups.empty() || groups.back().first != name) groups.push_back({name, {}});
        groups.back().second.push_back(row);
    }
    return groups;
}

const RegressionRow* findRow(const std::vector<RegressionRow>& rows, const std::string& scenario)
{
    for (const RegressionRow& row : rows)
        if (row.scenario == scenario) return &row;
    return nullptr;
}

std::vector<double> knownValues(const std::vector<RegressionRow>& rows, const char* metric)
{
    std::vector<double> values;
    for (const RegressionRow& row : rows)
        if (const auto value = row.values[*metricIndex(metric)]) values.push_back(*value);
    return values;
}

double meanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rmsOf(const std::vector<double>& values)
{
    const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

std::string cell(const char* format, double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

}  // namespace vdamf
