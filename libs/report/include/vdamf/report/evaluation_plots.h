// SPDX-License-Identifier: BSD-3-Clause
// The charts of an evaluation.
#pragma once

#include <string>
#include <vector>

#include "vdamf/evaluation/evaluation.h"
#include "vdamf/report/plots.h"

namespace vdamf
{
/// A chart and the name of the file that it is to stand in, without extension.
struct NamedChart
{
    std::string name;
    Chart chart;
};

/// position, heading, speed, size (shares of the pairs up to each error), range (medians),
/// consistency (how often errors lie within what the covariance says), hota (by overlap), and roc
/// and det where the evaluation has them.
std::vector<NamedChart> evaluationCharts(const Evaluation& evaluation);

/// All names that there may be.
const std::vector<std::string>& evaluationChartNames();

}  // namespace vdamf
