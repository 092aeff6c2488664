// SPDX-License-Identifier: BSD-3-Clause
// Fig. 11 of the paper from our data: weights in space, ROC and DET, and how reliable the
// probabilities are.
#pragma once

#include <string>
#include <vector>

#include "vdamf/evaluation/reliability.h"
#include "vdamf/evaluation/roc.h"
#include "vdamf/report/plots.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
struct NamedRoc
{
    std::string name;  ///< in the legend
    Roc roc;
};

/// With the bands of 95 % confidence as dashed lines.
Chart rocChart(const std::vector<NamedRoc>& curves);
Chart detChart(const std::vector<NamedRoc>& curves);

struct NamedReliability
{
    std::string name;  ///< in the legend
    Reliability reliability;
};

Chart reliabilityChart(const std::vector<NamedReliability>& curves);

/// Weights of the grid's cells as an SVG on white, one picture a layer of height: blue speaks for a
/// vehicle and red against it, as in the paper's Fig. 11 (b). The sensor is at the lower left.
std::string weightsSvg(const DiscriminatorModel& model);

/// The points of an object in the canonical frame, in the same layers: counts of hits as shades of
/// grey (Fig. 11 (a)). `cells`: one a cell of the grid, 0 or more.
std::string cellsSvg(const DiscriminationGrid& grid, const std::vector<double>& cells,
                     const std::string& title);

}  // namespace vdamf
