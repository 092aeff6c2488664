// SPDX-License-Identifier: BSD-3-Clause
// The same scenarios from one frame on after the other. A single run of a recorded drive is one
// draw: a frame more or less decides when a car is known for one, which is some rows of a few
// hundred. What changes in the mean over starts was not chance.
#pragma once

#include <string>
#include <vector>

#include "regression/catalogue.h"
#include "regression/metric.h"

namespace vdamf
{
/// Each scenario `count` times, named `<name>/start_<k>`, tracked and scored from its frame k on,
/// from 0.
std::vector<RegressionScenario> withStarts(const std::vector<RegressionScenario>& scenarios,
                                           int count);

/// For a terminal: of each scenario the mean over its starts and the standard deviation. Rows are
/// those of withStarts(). `before`: earlier ones, or none; of those that both have, the mean change
/// from start to start and its standard error, marked * where it is more than twice that.
std::string startsTable(const std::vector<RegressionRow>& rows,
                        const std::vector<RegressionRow>& before);

}  // namespace vdamf
