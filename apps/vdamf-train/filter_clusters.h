// SPDX-License-Identifier: BSD-3-Clause
// Labelled clusters of recordings and simulations.
#pragma once

#include <atomic>
#include <vector>

#include "filter_sources.h"
#include "vdamf/learning/clusters/labelled_cluster.h"
#include "vdamf/rawlog/configuration.h"

namespace vdamf
{
/// Two conditions: the hits above ground in each label's box, and the whole cluster of the
/// preprocessing on it. Vehicles with ten hits that count (region and min_points as in
/// vdamf-evaluate). Throws std::runtime_error that names the recording, also where `stop` ended the
/// run.
std::vector<LabelledClusters> clustersOf(const FilterRecording& recording,
                                         const Configuration& configuration,
                                         const std::atomic<bool>& stop);

std::vector<LabelledClusters> clustersOf(const SimulatedSource& source);

}  // namespace vdamf
