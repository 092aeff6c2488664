// SPDX-License-Identifier: BSD-3-Clause
// A trained vehicle discriminator: grid, weights, calibration. A plain value.
#pragma once

#include <string>
#include <vector>

#include "vdamf/tracking/discrimination/grid.h"

namespace vdamf
{
/// From the classifier's score of one frame to log-odds of "vehicle" (Platt scaling, whose slope
/// and offset change with the number of hits):
/// (slope + slopePerDecade u) score + offset + offsetPerDecade u with u = log10(hits / 50).
struct FrameCalibration
{
    double slope = 1.0;
    double offset = 0.0;
    double slopePerDecade = 0.0;
    double offsetPerDecade = 0.0;
    double prior = 0.0;  ///< log-odds of "vehicle" among the objects it was fitted on
};

/// From the evidence of a track's frames, which are alike, to log-odds: with S the sum of the
/// frames' log-odds less the prior and n their number, both forgetting by `memory` a frame,
/// slope S / (1 + correlation (n - 1)) + offset, cut to +-cap.
struct TrackCalibration
{
    double memory = 1.0;       ///< 0..1
    double correlation = 0.3;  ///< 0..1
    double slope = 1.0;
    double offset = 0.0;
    double cap = 7.0;
};

struct DiscriminatorModel
{
    DiscriminationGrid grid;
    double bias = 0.0;
    std::vector<double> weights;  ///< one a feature
    FrameCalibration frame;
    TrackCalibration track;
    std::vector<std::string> record;  ///< how it was trained: lines of text
};

/// Weights zero: for the features alone.
DiscriminatorModel untrainedModel(const DiscriminationGrid& grid = {});

/// The model as a small text (docs/discriminator.md), which parseDiscriminatorModel() reads back to
/// the same model.
std::string toText(const DiscriminatorModel& model);

/// Strict: throws std::runtime_error with `name`, the line and what was expected there for a text
/// of another version, one that ends early, weights that do not fit the grid, and numbers that are
/// not finite.
DiscriminatorModel parseDiscriminatorModel(const std::string& text, const std::string& name);

/// The model that comes with the program (models/vehicle.txt).
const DiscriminatorModel& defaultDiscriminatorModel();

}  // namespace vdamf
