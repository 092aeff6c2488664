// SPDX-License-Identifier: BSD-3-Clause
#include "vdamf/simulation/scenario.h"

#include <cmath>
#include <utility>

#include "scene_builder.h"
#include "sensor_sections.h"
#include "vdamf/files/numbers.h"
#include "vdamf/simulation/paint.h"

namespace vdamf
{
int Scenario::frames() const
{
    // A frame that begins a rounding error before the end would be one too many.
    return static_cast<int>(std::ceil(run.duration * frameRate() - 1e-6));
}

Scenario readScenario(const IniDocument& document)
{
    Scenario scenario;
    PlatformOptions platform;
    TerrainOptions terrain;
    IniReader reader(document);
    reader.read("scenario", scenario.run);
    scenario.sensors = readSensors(document, reader, scenario.run);
    reader.read("platform", platform);
    reader.read("terrain", terrain);
    reader.read("ins", scenario.ins);
    reader.require(scenario.ins.gapLength < scenario.ins.gapEvery,
                   "ins.gap_length_s = " + toText(scenario.ins.gapLength) +
                       " must be below ins.gap_every_s = " + toText(scenario.ins.gapEvery) +
                       ", which is counted from gap to gap",
                   {{"ins", "gap_length_s"}, {"ins", "gap_every_s"}});
    reader.read("output", scenario.recording);
    reader.require(
        scenario.recording.sensoryFrames || scenario.recording.poseSource != PoseSource::Actions,
        "output.pose_source: actions need output.sensory_frames = true",
        {{"output", "pose_source"}, {"output", "sensory_frames"}});
    const ObjectSections objects = readObjects(document, reader);
    reader.finish();

    BuiltScene built = buildScene(document, platform, objects, scenario.run.duration);
    scenario.scene = std::move(built.scene);
    scenario.warnings = std::move(built.warnings);
    scenario.scene.terrain = Terrain(terrain);
    for (SceneObject& object : scenario.scene.objects) object.paint = paintOf(object.name);
    return scenario;
}

}  // namespace vdamf
