// SPDX-License-Identifier: BSD-3-Clause
#include "regression/scene_settings.h"

#include <utility>

#include "vdamf/files/ini.h"

namespace vdamf
{
namespace
{
// One for each sensor, where it is one of a sensor's and sensors have names.
std::vector<std::string> perSensor(const std::string& setting, const IniDocument& scenario)
{
    const std::string sensor = "sensor";
    const std::string named = sensor + " ";
    std::vector<std::string> all;
    if (setting.rfind(sensor + ".", 0) == 0)
        for (const IniSection& section : scenario.sections())
            if (section.name.rfind(named, 0) == 0)
                all.push_back(section.name + setting.substr(sensor.size()));
    return all.empty() ? std::vector<std::string>{setting} : all;
}
}  // namespace

std::vector<RegressionScenario> withSceneSettings(const std::vector<RegressionScenario>& scenarios,
                                                  const std::vector<std::string>& settings)
{
    std::vector<RegressionScenario> all;
    for (RegressionScenario scenario : scenarios)
    {
        if (scenario.make.front() != "vdamf-simulate") continue;
        const IniDocument document = IniDocument::load(scenario.make[1]);
        for (const std::string& setting : settings)
            for (const std::string& each : perSensor(setting, document))
                scenario.make.insert(scenario.make.end(), {"--set", each});
        all.push_back(std::move(scenario));
    }
    return all;
}

}  // namespace vdamf
