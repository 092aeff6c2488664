// SPDX-License-Identifier: BSD-3-Clause
// One frame of a scenario with its truth.
#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
const char* truthClass(ObjectClass objectClass)
{
    switch (objectClass)
    {
        case ObjectClass::Car:
            return "Car";
        case ObjectClass::Van:
            return "Van";
        case ObjectClass::Truck:
            return "Truck";
        default:
            return "Other";
    }
}

TruthRow truthOf(const Scenario& scenario, const SceneObject& object, double sceneTime)
{
    const MotionState origin = scenario.scene.platform.at(0.0);
    TruthRow row;
    row.time = scenario.run.startTime + sceneTime;
    row.objectId = object.name;
    row.objectClass = truthClass(object.objectClass);
    row.box = boxAt(object, sceneTime);
    row.box.x -= origin.x;
    row.box.y -= origin.y;
    row.height = object.size.height;
    row.speed = object.trajectory.at(sceneTime).speed;
    return row;
}
}  // namespace

SimulatedFrame simulateFrame(const Scenario& scenario, int frame)
{
    const double sceneTime = scenario.frameTime(frame);
    RandomStream random(static_cast<std::uint64_t>(scenario.run.seed),
                        static_cast<std::uint64_t>(frame));
    SimulatedFrame result;
    result.time = scenario.run.startTime + sceneTime;
    result.firings = castRevolution(scenario.scene, scenario.mount, sceneTime, random);
    const std::vector<SceneObject>& objects = scenario.scene.objects;
    const std::vector<int> hits = countHits(result.firings, objects.size());
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        if (!isVehicle(objects[i].objectClass)) continue;
        result.truth.push_back(truthOf(scenario, objects[i], sceneTime));
        result.truth.back().points = hits[i];
    }
    return result;
}

}  // namespace vdamf
