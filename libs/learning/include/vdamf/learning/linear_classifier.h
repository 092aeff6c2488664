// SPDX-License-Identifier: BSD-3-Clause
// The linear support vector classifier of section 5, trained by liblinear.
#pragma once

#include <vector>

#include "vdamf/learning/sample.h"

namespace vdamf
{
struct LinearClassifier
{
    double bias = 0.0;
    std::vector<double> weights;

    double score(const std::vector<SparseFeature>& features) const;
};

/// L2-regularised squared hinge loss (liblinear's L2R_L2LOSS_SVC, which draws no random numbers);
/// both classes weigh the same in sum. `samples` have labels, both kinds. Throws
/// std::runtime_error where liblinear cannot.
LinearClassifier trainLinear(const std::vector<const ObjectSample*>& samples,
                             std::size_t featureCount, double cost);

}  // namespace vdamf
