// SPDX-License-Identifier: BSD-3-Clause
// Errors of several filters on the same clusters.
#pragma once

#include <array>
#include <vector>

#include "vdamf/learning/train_filter.h"

namespace vdamf
{
class FilterComparison
{
public:
    /// Fits all clusters with the hand-set filter, the bank's common one, and where it has types
    /// the one that it chooses.
    void add(const std::vector<LabelledClusters>& conditions, const MeasureOptions& handSet,
             const FilterBank& bank);

    /// Conditions that have clusters, in the order in which they were first added.
    std::vector<HeldOutCondition> summaries() const;

private:
    struct Errors
    {
        std::string name;
        std::array<std::vector<CaseErrors>, 3> methods;
    };

    Errors& errorsOn(const std::string& condition);

    std::vector<Errors> conditions_;
};

}  // namespace vdamf
