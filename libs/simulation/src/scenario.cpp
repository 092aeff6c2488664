// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/scenario.h"

#include <cmath>

#include "scene_builder.h"

namespace vdamf
{
namespace
{
LadarMount mountOf(const RunOptions& run, const SensorOptions& sensor)
{
    LadarMount mount;
    mount.ladar = ladarOf(sensor.model);
    if (sensor.rangeNoise >= 0.0) mount.ladar.rangeNoise = sensor.rangeNoise;
    if (sensor.maxRange >= 0.0) mount.ladar.maxRange = sensor.maxRange;
    mount.position = {sensor.x, sensor.y, sensor.z};
    mount.heading = sensor.heading;
    mount.rate = run.rate;
    mount.fieldOfView = sensor.fieldOfView;
    mount.instantaneous = sensor.instantaneous;
    mount.halfLossStrength = sensor.halfLossStrength;
    mount.glassLoss = sensor.glassLoss;
    return mount;
}
}  // namespace

int Scenario::frames() const
{
    // A frame that begins a rounding error before the end would be one too many.
    return static_cast<int>(std::ceil(run.duration * run.rate - 1e-6));
}

Scenario readScenario(const IniDocument& document)
{
    Scenario scenario;
    PlatformOptions platform;
    IniReader reader(document);
    reader.read("scenario", scenario.run);
    reader.read("sensor", scenario.sensor);
    reader.read("platform", platform);
    const std::vector<NamedObject> objects = readObjects(document, reader);
    reader.finish();

    scenario.scene = buildScene(document, platform, objects);
    scenario.mount = mountOf(scenario.run, scenario.sensor);
    return scenario;
}

}  // namespace vdamf
