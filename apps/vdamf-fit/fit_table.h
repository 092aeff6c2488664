// SPDX-License-Identifier: BSD-3-Clause
// The rows of fits.csv.
#pragma once

#include <string>

#include "fit_cluster.h"

namespace vdamf
{
std::string fitsHeader();  ///< with the line's end

/// With the line's end. Cells that a cluster without a fit cannot fill stay empty.
std::string toCsv(const TableCluster& cluster, const ClusterFit& fit);

}  // namespace vdamf
