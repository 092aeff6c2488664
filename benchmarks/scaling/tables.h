// SPDX-License-Identifier: BSD-3-Clause
// What the scaling benchmark prints and writes.
#pragma once

#include <string>
#include <vector>

#include "scaling/stage_times.h"

namespace vdamf
{
struct TimedRun
{
    std::string scene;  ///< "500 targets", or the name of a drive
    int targets = 0;    ///< of a stress scene; 0: a recording
    int threads = 1;
    SequenceTimes times;
};

/// Processor time of each stage, and of all on the clock, by columns: milliseconds a frame.
std::string stageTable(const std::vector<TimedRun>& runs);

/// scene, targets, threads, points, clusters, tracks and for each stage and all of them the
/// milliseconds a frame of the processor and of the clock.
std::string timesCsv(const std::vector<TimedRun>& runs);

/// Time a frame over the number of targets, both logarithmic, a line for each number of threads.
std::string scalingSvg(const std::vector<TimedRun>& runs);

}  // namespace vdamf
