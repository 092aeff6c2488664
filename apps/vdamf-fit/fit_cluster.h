// SPDX-License-Identifier: BSD-3-Clause
// One cluster of the table to one measurement.
#pragma once

#include <string>

#include "cluster_table.h"
#include "vdamf/tracking/matched_filter/measure.h"

namespace vdamf
{
struct ClusterFit
{
    /// In the frame of the table. Nothing where the hits do not allow a fit.
    std::optional<Measurement> measurement;
    bool converged = false;
    std::string reason;  ///< why not; empty where it is converged. No comma in it.
};

/// Measures from the heading of the table, if it gives one, else from startBox(). Everything is
/// computed relative to the first hit, so that coordinates of a map projection (1e6 m) lose
/// nothing. Never throws for the sake of the hits, and everything in a measurement is finite.
ClusterFit fitCluster(const TableCluster& cluster, const MeasureOptions& options);

}  // namespace vdamf
