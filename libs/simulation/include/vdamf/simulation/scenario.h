// SPDX-License-Identifier: BSD-3-Clause
// A scenario file as a scene, its sensors and a run. Format: apps/vdamf-simulate/README.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/files/ini.h"
#include "vdamf/simulation/ray_caster.h"
#include "vdamf/simulation/recording_options.h"
#include "vdamf/simulation/scenario_options.h"

namespace vdamf
{
struct SimulatedSensor
{
    std::string label;  ///< of its observations
    SensorOptions options;
    LadarMount mount;  ///< as `options` say

    /// Scene time at which a scan begins, s.
    double scanTime(int scan) const { return options.delay + scan / mount.rate; }
};

struct Scenario
{
    RunOptions run;
    InsErrorOptions ins;
    RecordingOptions recording;
    std::vector<SimulatedSensor> sensors;  ///< the first one's scans are the frames
    Scene scene;
    std::vector<std::string> warnings;  ///< what of recorded traffic is not as it is labelled

    int frames() const;
    /// Scene time at which a frame's scan begins, s.
    double frameTime(int frame) const { return frame / frameRate(); }
    /// Frames, 1/s: the scans of the first sensor.
    double frameRate() const { return sensors.empty() ? run.rate : sensors.front().mount.rate; }
};

/// Throws IniError that lists the problems, each with file, line and key.
Scenario readScenario(const IniDocument& document);

struct SimulatedScan
{
    std::size_t sensor = 0;  ///< index in the scenario
    double time = 0.0;       ///< s (UNIX)
    std::vector<LadarFiring> firings;
};

/// One frame: all scans that begin from frameTime() to the next one, and the objects as they are
/// at frameTime().
struct SimulatedFrame
{
    double time = 0.0;                 ///< s (UNIX)
    std::vector<SimulatedScan> scans;  ///< by time; that of the first sensor first
    /// All objects of the scene that have a truthClass() and exist then, in the order of the file.
    /// World frame of the recording: scene axes, origin at the platform's first pose. `points`:
    /// returns of all scans of this frame. `sensor`: where the first sensor is at the time.
    std::vector<TruthRow> truth;
};

/// The same scenario, frame and seed give the same frame, in any order of calls.
SimulatedFrame simulateFrame(const Scenario& scenario, int frame);

}  // namespace vdamf
