// SPDX-License-Identifier: BSD-3-Clause
// Simulated traffic as frames for tests of the whole tracker: scenes as in datasets/scenarios, with
// exact poses of the platform and of every firing.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "vdamf/simulation/scenario.h"
#include "vdamf/tracking/tracker/tracker.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// A scene from the text of a scenario file.
inline Scenario scenarioOf(const std::string& text, int seed = 1)
{
    IniDocument document = IniDocument::parse(text, "scene of a test");
    document.set("scenario.seed=" + std::to_string(seed));
    return readScenario(document);
}

/// The hits of a frame as they lie in the scene. Scene frame, times after the frame's.
inline LadarFrame ladarFrameOf(const Scenario& scenario, const SimulatedFrame& simulated)
{
    const SimulatedScan& scan = simulated.scans.front();
    const LadarMount& mount = scenario.sensors[scan.sensor].mount;
    const double sceneTime = simulated.time - scenario.run.startTime;
    const Sweep sweep = sweepOf(mount.ladar, mount.rate, mount.fieldOfView);
    const auto sensorAt = [&](double time)
    {
        const GroundPose pose = platformPoseAt(scenario.scene, time);
        return Eigen::Vector3d(pose.position + pose.attitude() * mount.position);
    };
    LadarFrame frame;
    frame.time = simulated.time;
    frame.sensor = sensorAt(sceneTime);
    frame.origin = frame.sensor.array().round();
    for (const LadarFiring& firing : scan.firings)
    {
        const GroundPose pose = platformPoseAt(scenario.scene, firing.time);
        const Eigen::Matrix3d axes =
            pose.attitude() * attitudeOf(mount.heading, mount.pitch, mount.roll);
        const Eigen::Vector3d from = sensorAt(firing.time) - frame.origin;
        for (std::size_t laser = 0; laser < firing.returns.size(); ++laser)
        {
            const double range = firing.returns[laser].range;
            if (range <= 0.0) continue;
            const double delay = mount.ladar.laserDelays[laser];
            const double azimuth = firing.azimuth + delay / sweep.period * sweep.azimuthStep;
            const double elevation = mount.ladar.elevations[laser];
            const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                      -std::cos(elevation) * std::sin(azimuth),
                                      std::sin(elevation));
            const Eigen::Vector3f p = (from + range * (axes * ray)).cast<float>();
            frame.points.x.push_back(p.x());
            frame.points.y.push_back(p.y());
            frame.points.z.push_back(p.z());
            frame.points.time.push_back(static_cast<float>(firing.time - sceneTime + delay));
        }
    }
    return frame;
}

/// An object of the scene in one frame, and what is published of it.
struct Seen
{
    double time = 0.0;  ///< of the scene, s
    TruthRow truth;
    std::vector<TrackReport> tracks;  ///< with the centre inside of its box, nearest first
};

/// The frames of each object by name: what a tracker with default options publishes.
inline std::map<std::string, std::vector<Seen>> trackedObjects(const Scenario& scenario,
                                                               const TrackerOptions& options = {})
{
    Tracker tracker{options};
    std::map<std::string, std::vector<Seen>> seen;
    for (int k = 0; k < scenario.frames(); ++k)
    {
        const SimulatedFrame simulated = simulateFrame(scenario, k);
        const FrameResult result = tracker.process(ladarFrameOf(scenario, simulated));
        for (TruthRow truth : simulated.truth)
        {
            const Eigen::Vector3d origin = platformPoseAt(scenario.scene, 0.0).position;
            truth.box.x += origin.x();
            truth.box.y += origin.y();
            Seen here{scenario.frameTime(k), truth, {}};
            for (const TrackReport& track : result.tracks)
            {
                const bool isPublished =
                    track.status == TrackStatus::Confirmed || track.status == TrackStatus::Coasting;
                const Eigen::Vector2d p = toBoxFrame(truth.box, track.box.centre());
                const bool isInside = std::abs(p.x()) < 0.5 * truth.box.length + 0.3 &&
                                      std::abs(p.y()) < 0.5 * truth.box.width + 0.3;
                if (isPublished && isInside) here.tracks.push_back(track);
            }
            const auto away = [&](const TrackReport& t)
            { return (t.box.centre() - truth.box.centre()).norm(); };
            std::sort(here.tracks.begin(), here.tracks.end(),
                      [&](const TrackReport& a, const TrackReport& b)
                      { return away(a) < away(b); });
            seen[truth.objectId].push_back(here);
        }
    }
    return seen;
}

}  // namespace vdamf
