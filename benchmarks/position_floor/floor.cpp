// SPDX-License-Identifier: BSD-3-Clause
#include "position_floor/floor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <vector>

namespace vdamf
{
namespace
{
constexpr double kNear = 0.3;  // m: bumpers are bowed, and rows of hits lie apart
constexpr int kHits = 20;
constexpr double kRange = 60.0;  // m

// Half of what the far face is off where the near one alone is known.
double offsetAlong(double low, double high, double size, double usual)
{
    const bool isLowKnown = low < -0.5 * size + kNear;
    const bool isHighKnown = high > 0.5 * size - kNear;
    if (isLowKnown == isHighKnown) return 0.0;
    return 0.5 * (size - std::max(usual, high - low));
}

// The sensor's axes and place in the scene while it fires.
Eigen::Isometry3d sensorAt(const Scenario& scenario, double time)
{
    const LadarMount& mount = scenario.sensors.front().mount;
    const GroundPose platform = platformPoseAt(scenario.scene, time);
    Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
    sensor.linear() = platform.attitude() * attitudeOf(mount.heading, mount.pitch, mount.roll);
    sensor.translation() = platform.position + platform.attitude() * mount.position;
    return sensor;
}

// What has hit each object of the scene, in its own frame.
class HitsSoFar
{
public:
    explicit HitsSoFar(const Scenario& scenario)
        : scenario_(scenario), bounds_(scenario.scene.objects.size())
    {
    }

    void add(const SimulatedScan& scan)
    {
        const LadarMount& mount = scenario_.sensors.front().mount;
        const double begin = scan.time - scenario_.run.startTime;
        const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
        for (const LadarFiring& firing : scan.firings)
            add(firing, sweep, mount.instantaneous ? begin : firing.time);
    }

    const Eigen::AlignedBox2d& of(std::size_t object) const { return bounds_[object]; }

private:
    void add(const LadarFiring& firing, const Sweep& sweep, double time)
    {
        const LadarMount& mount = scenario_.sensors.front().mount;
        const Eigen::Isometry3d sensor = sensorAt(scenario_, time);
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const LadarReturn& one = firing.returns[laser];
            if (one.object < 0) continue;
            const auto index = static_cast<std::size_t>(one.object);
            const double azimuth =
                firing.azimuth + mount.ladar.laserDelays[laser] / sweep.period * sweep.azimuthStep;
            const double elevation = mount.ladar.elevations[laser];
            const Eigen::Vector3d place =
                sensor * (one.range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                                      -std::cos(elevation) * std::sin(azimuth),
                                                      std::sin(elevation)));
            bounds_[index].extend(
                toBoxFrame(boxAt(scenario_.scene.objects[index], time), place.head<2>()));
        }
    }

    const Scenario& scenario_;
    std::vector<Eigen::AlignedBox2d> bounds_;
};

bool isCounted(const TruthRow& row)
{
    return row.points >= kHits && row.sensor &&
           std::hypot(row.box.x - row.sensor->x, row.box.y - row.sensor->y) <= kRange;
}

double rms(double squares, std::size_t count)
{
    return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count));
}
}  // namespace

double leastSquaredOffset(const Eigen::AlignedBox2d& hits, const BodySize& size,
                          const BodySize& usual)
{
    return Eigen::Vector2d(offsetAlong(hits.min().x(), hits.max().x(), size.length, usual.length),
                           offsetAlong(hits.min().y(), hits.max().y(), size.width, usual.width))
        .squaredNorm();
}

SeenBoxes seenBoxes(const Scenario& scenario)
{
    const std::vector<SceneObject>& objects = scenario.scene.objects;
    std::unordered_map<std::string, std::size_t> indexOf;
    for (std::size_t i = 0; i < objects.size(); ++i) indexOf[objects[i].name] = i;
    HitsSoFar hits(scenario);
    SeenBoxes seen;
    for (int k = 0; k < scenario.frames(); ++k)
    {
        const SimulatedFrame frame = simulateFrame(scenario, k);
        for (const SimulatedScan& scan : frame.scans)
            if (scan.sensor == 0) hits.add(scan);
        for (const TruthRow& row : frame.truth)
        {
            const std::size_t object = indexOf.at(row.objectId);
            if (isVehicle(objects[object].objectClass) && isCounted(row))
                seen.boxes.push_back({object, hits.of(object)});
        }
    }
    for (std::size_t i = 0; i < objects.size(); ++i) seen.inAll.push_back(hits.of(i));
    return seen;
}

PositionFloor positionFloor(const SeenBoxes& seen, const Scenario& scenario, const Scenario& usual)
{
    const auto squareOf = [&](std::size_t object, const Eigen::AlignedBox2d& hits)
    {
        return leastSquaredOffset(hits, scenario.scene.objects[object].size,
                                  usual.scene.objects[object].size);
    };
    double online = 0.0;
    double hindsight = 0.0;
    for (const SeenBox& box : seen.boxes)
    {
        online += squareOf(box.object, box.hits);
        hindsight += squareOf(box.object, seen.inAll[box.object]);
    }
    return {seen.boxes.size(), rms(online, seen.boxes.size()), rms(hindsight, seen.boxes.size())};
}

Scenario withHeaviesAlike(Scenario usual)
{
    const double length =
        0.5 * (typicalSize(ObjectClass::Truck).length + typicalSize(ObjectClass::Bus).length);
    for (SceneObject& object : usual.scene.objects)
        if (object.objectClass == ObjectClass::Truck || object.objectClass == ObjectClass::Bus)
            object.size.length = length;
    return usual;
}

}  // namespace vdamf
