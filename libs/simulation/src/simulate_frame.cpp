// SPDX-License-Identifier: BSD-3-Clause
// One frame of a scenario with its truth.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "vdamf/simulation/scenario.h"

namespace vdamf
{
namespace
{
/// Scans of one sensor that begin in the frame.
std::vector<SimulatedScan> scansOf(const Scenario& scenario, std::size_t index, int frame)
{
    constexpr double kRounding = 1e-6;  // scans
    const SimulatedSensor& sensor = scenario.sensors[index];
    const auto scanAtOrAfter = [&](double time)
    {
        const double scans = (time - sensor.options.delay) * sensor.mount.rate;
        return std::max(0, static_cast<int>(std::ceil(scans - kRounding)));
    };
    const double end = std::min(scenario.frameTime(frame + 1), scenario.run.duration);
    const int first = index == 0 ? frame : scanAtOrAfter(scenario.frameTime(frame));
    const int last = index == 0 ? frame + 1 : scanAtOrAfter(end);
    std::vector<SimulatedScan> scans;
    for (int i = first; i < last; ++i)
    {
        RandomStream random(static_cast<std::uint64_t>(scenario.run.seed),
                            streamIndex(index, static_cast<std::uint64_t>(i)));
        const double time = sensor.scanTime(i);
        scans.push_back({index, scenario.run.startTime + time,
                         castScan(scenario.scene, sensor.mount, time, random)});
    }
    return scans;
}

PlanePose sensorInWorld(const Scenario& scenario, const Eigen::Vector3d& origin, double sceneTime)
{
    const GroundPose platform = platformPoseAt(scenario.scene, sceneTime);
    const Eigen::Vector3d place =
        platform.position + platform.attitude() * scenario.sensors.front().mount.position - origin;
    return {place.x(), place.y(), wrapAngle(platform.heading)};
}

TruthRow truthOf(const Scenario& scenario, const SceneObject& object, const Eigen::Vector3d& origin,
                 double sceneTime)
{
    TruthRow row;
    row.time = scenario.run.startTime + sceneTime;
    row.objectId = object.name;
    row.objectClass = truthClass(object.objectClass).value_or("Other");
    row.box = boxAt(object, sceneTime);
    row.box.x -= origin.x();
    row.box.y -= origin.y();
    row.z = objectPoseAt(scenario.scene, object, sceneTime).position.z() - origin.z();
    row.height = object.size.height;
    row.speed = object.trajectory.at(sceneTime).speed;
    row.sensor = sensorInWorld(scenario, origin, sceneTime);
    return row;
}
}  // namespace

SimulatedFrame simulateFrame(const Scenario& scenario, int frame)
{
    const double sceneTime = scenario.frameTime(frame);
    const std::vector<SceneObject>& objects = scenario.scene.objects;
    SimulatedFrame result;
    result.time = scenario.run.startTime + sceneTime;
    std::vector<int> hits(objects.size(), 0);
    for (std::size_t sensor = 0; sensor < scenario.sensors.size(); ++sensor)
    {
        for (SimulatedScan& scan : scansOf(scenario, sensor, frame))
        {
            const std::vector<int> more = countHits(scan.firings, objects.size());
            std::transform(hits.begin(), hits.end(), more.begin(), hits.begin(), std::plus<>());
            result.scans.push_back(std::move(scan));
        }
    }
    std::stable_sort(result.scans.begin(), result.scans.end(),
                     [](const SimulatedScan& a, const SimulatedScan& b)
                     { return a.time < b.time; });
    const Eigen::Vector3d origin = platformPoseAt(scenario.scene, 0.0).position;
    for (std::size_t i = 0; i < objects.size(); ++i)
    {
        if (!truthClass(objects[i].objectClass) || !existsAt(objects[i], sceneTime)) continue;
        result.truth.push_back(truthOf(scenario, objects[i], origin, sceneTime));
        result.truth.back().points = hits[i];
    }
    return result;
}

}  // namespace vdamf
