// SPDX-License-Identifier: BSD-3-Clause
// Learns the measurement's parameters from labelled clusters (the paper's future work).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_summary.h"
#include "vdamf/learning/clusters/labelled_cluster.h"
#include "vdamf/tracking/types/vehicle_type.h"

namespace vdamf
{
struct FilterTrainingOptions
{
    int globalEvaluations = 300;  ///< of the filter's shape and reach, by dividing rectangles
    int localEvaluations = 300;   ///< of each group of parameters, by subplexes
    int folds = 3;                ///< of the cross-validation; 0: none
    std::uint64_t seed = 1;       ///< of the folds
    bool bank = false;            ///< also one filter for each type of vehicle with enough clusters
    int leastOfType = 40;         ///< clusters that a type's filter needs
};

/// Held-out clusters of one condition.
struct HeldOutCondition
{
    std::string name;
    std::vector<CaseSummary> methods;  ///< hand_set, learned, bank
};

struct FilterTraining
{
    FilterBank bank;  ///< the record is the caller's to fill
    double before = 0.0;
    double after = 0.0;                     ///< objective on all clusters
    std::vector<HeldOutCondition> heldOut;  ///< by cross-validation
};

/// Told after each evaluation: the step, and the share of all that is done.
using FilterProgress = std::function<void(const std::string& step, double share)>;

/// Parameters that matter for the filter kind of `handSet`, each from 0.4 to 2.5 times its value
/// there: the filter's shape with the reach of the lines, globally, then locally; then what leads
/// from lines or filter to the hull, then the covariance. Deterministic. An exception of `progress`
/// ends the training. Throws std::runtime_error where there are too few clusters or groups.
FilterTraining trainFilter(const std::vector<LabelledClusters>& conditions,
                           const MeasureOptions& handSet, const FilterTrainingOptions& options,
                           const FilterProgress& progress);

/// Clusters of one type of vehicle.
struct TypeCount
{
    VehicleType type = VehicleType::Any;
    std::size_t clusters = 0;
};

/// Types with fewer clusters than `least`, of which a bank has no filter.
std::vector<TypeCount> rareTypes(const std::vector<LabelledClusters>& conditions, int least);

/// Hand-set, learned and, of several filters, bank on clusters that none of them was trained on.
std::vector<HeldOutCondition> comparedOn(const std::vector<LabelledClusters>& conditions,
                                         const MeasureOptions& handSet, const FilterBank& bank);

}  // namespace vdamf
