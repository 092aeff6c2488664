// SPDX-License-Identifier: BSD-3-Clause
// Recordings to training samples: the tracker runs, the truth says what its objects are.
#pragma once

#include <atomic>
#include <vector>

#include "recordings.h"
#include "vdamf/learning/sample.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
/// The tracks of one recording with the features of `grid`. `index`: of the recording among all.
/// Throws std::runtime_error that names the recording, also where `stop` ended the run.
std::vector<TrackSamples> collectSamples(const Recording& recording, std::size_t index,
                                         const Configuration& configuration,
                                         const DiscriminationGrid& grid,
                                         const std::atomic<bool>& stop);

}  // namespace vdamf
