// SPDX-License-Identifier: BSD-3-Clause
// Section 5: what the linear classifier sees of an object: the cells of the grid and, beyond the
// paper, descriptors that do not depend on how densely a sensor scans.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vdamf/tracking/discrimination/canonical_frame.h"
#include "vdamf/tracking/discrimination/grid.h"
#include "vdamf/tracking/discrimination/model.h"

namespace vdamf
{
/// Part of the features of an object. Each descriptor is spread over its knots as a piecewise
/// linear function (the two neighbouring knots share 1), so that a linear classifier can learn any
/// course along it. A descriptor that an object does not have leaves its part zero.
struct FeatureBlock
{
    std::string name;
    std::size_t first = 0;  ///< feature
    std::size_t size = 0;
};

/// In order and without gaps: "cells" (square root of each cell's share of the hits), then the
/// descriptors.
std::vector<FeatureBlock> featureBlocks(const DiscriminationGrid& grid);

std::size_t featureCount(const DiscriminationGrid& grid);

/// Features of an object, each from 0 to 1. No hits: all zero.
std::vector<float> objectFeatures(const ObjectView& view, const DiscriminationGrid& grid);

/// What vehicleScore() gives for these features, but for rounding, in a third of the time: nearly
/// all of them are zero.
double objectScore(const ObjectView& view, const DiscriminatorModel& model);

}  // namespace vdamf
