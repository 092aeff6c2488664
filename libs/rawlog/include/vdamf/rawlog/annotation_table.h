// SPDX-License-Identifier: BSD-3-Clause
// The table behind each scan of an annotated rawlog: tracks as numbers, and back.
#pragma once

#include <string>
#include <vector>

#include "vdamf/tracking/types/track.h"

namespace vdamf
{
/// Those of tracks.csv and then the box measured in the frame, before filtering: measured_x_m,
/// measured_y_m, measured_heading_rad, measured_length_m, measured_width_m.
const std::vector<std::string>& annotationColumns();

/// A track's row, in the order of annotationColumns(): status and faces as numbers, NaN for what
/// is not known.
std::vector<double> annotationRow(double time, const TrackReport& report);

/// The tracks of a table of these columns, row after row. Columns that a table of an older version
/// lacks stay empty; others than annotationColumns() are passed over. Throws std::runtime_error
/// with the reason: no columns, no whole number of rows, a column without which there is no track
/// (track_id, status, pose, size) missing, an impossible identity or status.
std::vector<TrackReport> tracksOf(const std::vector<std::string>& columns,
                                  const std::vector<double>& numbers);

}  // namespace vdamf
