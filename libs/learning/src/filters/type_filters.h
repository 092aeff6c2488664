// SPDX-License-Identifier: BSD-3-Clause
// The types of vehicles among labelled clusters.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vdamf/learning/clusters/labelled_cluster.h"

namespace vdamf
{
std::string nameOf(VehicleType type);

/// Those of one type.
std::vector<LabelledClusters> ofType(const std::vector<LabelledClusters>& conditions,
                                     VehicleType type);

/// Under all conditions together.
std::size_t clustersIn(const std::vector<LabelledClusters>& conditions);

/// Usual sizes, every vehicle counted once. Standard deviations are 0.05 m at least.
TypeSizes sizesOf(const std::vector<LabelledClusters>& conditions);

/// Types with so many clusters, with their sizes and shares; parameters are the defaults.
std::vector<TypedFilter> typedFilters(const std::vector<LabelledClusters>& conditions, int least);

}  // namespace vdamf
