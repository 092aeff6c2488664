// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/experiments/settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

namespace vdamf
{
double countOfSettings(const std::vector<SweptKey>& keys)
{
    double count = 1.0;
    for (const SweptKey& key : keys)
        count *= key.interval ? std::numeric_limits<double>::infinity()
                              : static_cast<double>(key.values.size());
    return count;
}

std::vector<SweepSetting> gridSettings(const std::vector<SweptKey>& keys)
{
    std::vector<SweepSetting> settings = {{}};
    for (const SweptKey& key : keys)
    {
        if (key.interval)
            throw std::runtime_error(key.name +
                                     ": a grid needs values: give the range a step, "
                                     "'from : step : to' or 'log from : to : count'");
        std::vector<SweepSetting> longer;
        for (const SweepSetting& setting : settings)
        {
            for (const std::string& value : key.values)
            {
                longer.push_back(setting);
                longer.back().values.push_back(value);
            }
        }
        settings = std::move(longer);
    }
    return settings;
}

std::vector<SweepSetting> randomSettings(const std::vector<SweptKey>& keys, std::size_t count,
                                         std::uint64_t seed)
{
    if (static_cast<double>(count) > countOfSettings(keys))
        throw std::runtime_error("count = " + std::to_string(count) + ": the keys have only " +
                                 std::to_string(static_cast<long long>(countOfSettings(keys))) +
                                 " settings; lower it or use plan = grid");
    // Drawn without std::uniform_real_distribution, whose numbers differ between libraries.
    std::mt19937_64 engine(seed);
    const auto place = [&engine] { return std::ldexp(static_cast<double>(engine() >> 11U), -53); };
    std::vector<SweepSetting> settings;
    std::set<std::vector<std::string>> drawn;
    // An interval may be so narrow that its numbers run out.
    for (std::size_t tries = 0; settings.size() < count; ++tries)
    {
        if (tries > 1000 * (count + 100))
            throw std::runtime_error("count = " + std::to_string(count) +
                                     ": the keys' intervals are too narrow for as many settings");
        std::vector<double> point;
        for (std::size_t k = 0; k < keys.size(); ++k) point.push_back(place());
        const SweepSetting setting = settingAt(keys, point);
        if (drawn.insert(setting.values).second) settings.push_back(setting);
    }
    return settings;
}

SweepSetting settingAt(const std::vector<SweptKey>& keys, const std::vector<double>& point)
{
    SweepSetting setting;
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
        if (keys[k].interval)
        {
            setting.values.push_back(valueAt(*keys[k].interval, point[k]));
            continue;
        }
        const auto count = static_cast<double>(keys[k].values.size());
        const double index = std::clamp(std::floor(point[k] * count), 0.0, count - 1.0);
        setting.values.push_back(keys[k].values[static_cast<std::size_t>(index)]);
    }
    return setting;
}

}  // namespace vdamf
