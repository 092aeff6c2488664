// SPDX-License-Identifier: BSD-3-Clause
#include "key_axis.h"

#include <algorithm>

#include "vdamf/files/numbers.h"

namespace vdamf
{
namespace
{
constexpr double kRatioOfLogAxis = 8.0;

std::vector<std::string> differentValues(const SweepResults& results, std::size_t key)
{
    std::vector<std::string> values;
    for (const SweepSetting& setting : results.settings)
        if (std::find(values.begin(), values.end(), setting.values[key]) == values.end())
            values.push_back(setting.values[key]);
    return values;
}

bool areNumbers(const std::vector<std::string>& values)
{
    return std::all_of(values.begin(), values.end(),
                       [](const std::string& value) { return parseNumber(value).has_value(); });
}

void placeNumbers(KeyAxis& axis)
{
    std::sort(axis.values.begin(), axis.values.end(),
              [](const std::string& a, const std::string& b)
              { return *parseNumber(a) < *parseNumber(b); });
    for (const std::string& value : axis.values) axis.places.push_back(*parseNumber(value));
    const double least = axis.places.front();
    if (least > 0.0 && axis.places.back() >= kRatioOfLogAxis * least)
        axis.axis.scale = AxisScale::Log10;
}

// Words have no places of their own; the label says which is which.
void placeWords(KeyAxis& axis)
{
    axis.areWords = true;
    std::string words;
    for (std::size_t i = 0; i < axis.values.size(); ++i)
    {
        axis.places.push_back(static_cast<double>(i + 1));
        words += (i > 0 ? ", " : "") + std::to_string(i + 1) + " " + axis.values[i];
    }
    axis.axis.label += " (" + words + ")";
    axis.axis.min = 0.5;
    axis.axis.max = static_cast<double>(axis.values.size()) + 0.5;
}
}  // namespace

KeyAxis keyAxis(const SweepResults& results, std::size_t key)
{
    KeyAxis axis;
    axis.axis.label = results.keys[key];
    axis.values = differentValues(results, key);
    if (areNumbers(axis.values))
        placeNumbers(axis);
    else
        placeWords(axis);
    for (const SweepSetting& setting : results.settings)
    {
        const auto found = std::find(axis.values.begin(), axis.values.end(), setting.values[key]);
        axis.ofSetting.push_back(static_cast<std::size_t>(found - axis.values.begin()));
    }
    return axis;
}

}  // namespace vdamf
