// SPDX-License-Identifier: BSD-3-Clause
// Errors of all cases of one condition and method, in figures.
#pragma once

#include <string>
#include <vector>

#include "vdamf/learning/clusters/case_errors.h"

namespace vdamf
{
/// A quantile of values, linear between them; not a number without values.
double quantile(std::vector<double> values, double share);

/// Median of the signed errors, median and 90th percentile of their sizes.
struct ErrorFigures
{
    double bias = 0.0;
    double median = 0.0;
    double p90 = 0.0;
    std::size_t count = 0;
};
ErrorFigures figuresOf(const std::vector<double>& errors);

struct CaseSummary
{
    std::string condition;
    std::string method;
    std::size_t cases = 0;
    double medianHits = 0.0;
    ErrorFigures heading90, heading180;  ///< deg
    double crossed = 0.0;                ///< share with heading180 above 45 degrees
    ErrorFigures corner, end, side;      ///< m
    ErrorFigures length, width;          ///< m
    double iouMedian = 0.0, iouP10 = 0.0;
    double neesMean = 0.0, neesLow = 0.0, neesHigh = 0.0;  ///< by dimension, with 95 % band
    /// Factor on the covariance that makes the median right.
    double neesScale = 0.0;
    double within68 = 0.0, within95 = 0.0, within99 = 0.0;  ///< share of all cases with a NEES
    std::size_t neesCount = 0;
    double iterations = 0.0;    ///< median
    double failed = 0.0;        ///< share
    double microseconds = 0.0;  ///< mean time of one estimate
};

CaseSummary summaryOf(const std::vector<CaseErrors>& cases);

}  // namespace vdamf
