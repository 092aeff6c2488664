// SPDX-License-Identifier: BSD-3-Clause
// Recordings to training samples: the tracker runs, the truth says what its objects are.
#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "recordings.h"
#include "vdamf/learning/sample.h"
#include "vdamf/rawlog/configuration.h"
#include "vdamf/rawlog/track_rawlog.h"

namespace vdamf
{
/// Throws std::runtime_error where a run did not see all of its rawlog: interrupted, or the file
/// cannot be read to its end.
void checkReadWhole(const TrackRawlogSummary& run, const std::filesystem::path& rawlog);

/// The tracks of one recording with the features of `grid`. `index`: of the recording among all.
/// Throws std::runtime_error that names the recording, also where `stop` ended the run.
std::vector<TrackSamples> collectSamples(const Recording& recording, std::size_t index,
                                         const Configuration& configuration,
                                         const DiscriminationGrid& grid,
                                         const std::atomic<bool>& stop);

}  // namespace vdamf
