// SPDX-License-Identifier: BSD-3-Clause
// The same scenarios with many seeds: whether the tracker's covariances hold (ANEES).
#pragma once

#include <string>
#include <vector>

#include "regression/catalogue.h"
#include "regression/metric.h"

namespace vdamf
{
/// Each simulated scenario `count` times, named `<name>/seed_<k>`, with seeds from 1 on, each with
/// vehicles and a start of its own (variation.h). Recordings have no seed and are left out. Throws
/// std::runtime_error where a scenario cannot be read.
std::vector<RegressionScenario> withSeeds(const std::vector<RegressionScenario>& scenarios,
                                          int count);

/// For a terminal: of each scenario the mean over its seeds of the NEES of pose, speed and size,
/// with the 95 % bands that hold for that many independent runs, marked where outside (* too
/// confident, . too cautious), and RMS errors. Rows are those of withSeeds().
std::string seedsTable(const std::vector<RegressionRow>& rows);

}  // namespace vdamf
