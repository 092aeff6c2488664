// SPDX-License-Identifier: BSD-3-Clause
// How good a filter is on labelled clusters, as one number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_errors.h"
#include "vdamf/tracking/matched_filter/hits.h"

namespace vdamf
{
/// Fits every cluster from its start. An error e counts log(1 + (e / s)^2) / 2, with the scale s
/// the median of the reference's errors under the same condition, so that all kinds of errors and
/// all conditions count alike, outliers little more than others, and halving an error gains the
/// same everywhere. Heading, nearest corner, end, side, length and width; and of each condition the
/// square of the logarithm of the mean NEES over its dimension, which is right at 1.
class FilterObjective
{
public:
    /// `reference`: the options to beat, with the same sensor and filter kind. Conditions without
    /// clusters are left out. Throws std::runtime_error where there are no clusters at all.
    FilterObjective(std::vector<LabelledClusters> conditions, const MeasureOptions& reference);

    /// 0.35 or so for the reference; less is better.
    double operator()(const FilterParameters& parameters) const;

    std::size_t clusters() const;

private:
    struct Prepared
    {
        LabelledClusters clusters;
        std::vector<Hits> hits;
        std::vector<double> scales;  ///< by kind of error
    };

    std::vector<CaseErrors> errorsOn(const Prepared& condition,
                                     const MeasureOptions& options) const;
    static double lossOf(const std::vector<CaseErrors>& errors, const std::vector<double>& scales);

    MeasureOptions reference_;
    std::vector<Prepared> conditions_;
};

/// The estimate of one cluster's box from its start.
Estimate estimateFrom(const Hits& hits, const LabelledCluster& cluster,
                      const MeasureOptions& options);

}  // namespace vdamf
