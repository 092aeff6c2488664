// SPDX-License-Identifier: BSD-3-Clause
// Whether probabilities are what they say: of all that is called 80 % likely, 80 % should be so.
#pragma once

#include <cstddef>
#include <vector>

#include "vdamf/evaluation/roc.h"

namespace vdamf
{
/// Samples with alike probabilities.
struct ReliabilityBin
{
    std::size_t samples = 0;
    double probability = 0.0;  ///< mean of what was said
    double share = 0.0;        ///< that are vehicles
};

struct Reliability
{
    std::vector<ReliabilityBin> bins;  ///< that have samples, by rising probability
    /// Mean distance of share and probability over the bins, weighted by their samples.
    double expectedCalibrationError = 0.0;
    double brierScore = 0.0;  ///< mean squared error of the probabilities
};

/// In equal bins of probability (the usual number is 10). Scores must lie in 0..1.
Reliability reliabilityOf(const std::vector<ClassifierSample>& samples, int bins = 10);

}  // namespace vdamf
