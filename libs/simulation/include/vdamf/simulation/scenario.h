// SPDX-License-Identifier: BSD-3-Clause
// A scenario file as a scene, a sensor and a run. Format: apps/vdamf-simulate/README.md.
#pragma once

#include <cstdint>
#include <vector>

#include "vdamf/evaluation/tables.h"
#include "vdamf/files/ini.h"
#include "vdamf/simulation/ray_caster.h"
#include "vdamf/simulation/scenario_options.h"

namespace vdamf
{
struct Scenario
{
    RunOptions run;
    SensorOptions sensor;
    LadarMount mount;  ///< as `sensor` says
    Scene scene;

    int frames() const;
    /// Scene time at which a frame's revolution begins, s.
    double frameTime(int frame) const { return frame / run.rate; }
};

/// Throws IniError that lists the problems, each with file, line and key.
Scenario readScenario(const IniDocument& document);

/// One frame: the revolution that begins at frameTime(), and the vehicles as they are then.
struct SimulatedFrame
{
    double time = 0.0;  ///< s (UNIX)
    std::vector<LadarFiring> firings;
    /// All vehicles of the scene, in the order of the file. World frame of the recording: scene
    /// axes, origin at the platform's first pose. `points`: returns of this frame.
    std::vector<TruthRow> truth;
};

/// The same scenario, frame and seed give the same frame, in any order of calls.
SimulatedFrame simulateFrame(const Scenario& scenario, int frame);

}  // namespace vdamf
