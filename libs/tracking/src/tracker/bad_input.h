// SPDX-License-Identifier: BSD-3-Clause
// What no frame and no options may be.
#pragma once

#include <optional>

#include "vdamf/tracking/tracker/tracker.h"
#include "vdamf/tracking/types/point_cloud.h"

namespace vdamf
{
/// Throws std::invalid_argument where a frame does not follow the one before (its time, s), or its
/// numbers cannot be meant.
void refuseBad(const LadarFrame& frame, const std::optional<double>& before);

/// The options. Throws std::invalid_argument that lists what is wrong with them.
const TrackerOptions& checked(const TrackerOptions& options);

}  // namespace vdamf
