// SPDX-License-Identifier: BSD-3-Clause
// Does a filter know how good it is? NEES against truth, NIS without.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace vdamf
{
/// Statistics of normalised squared errors e^T P^-1 e (NEES) or innovations (NIS) of one dimension.
/// For a consistent filter they are chi-square with that many degrees of freedom.
struct Consistency
{
    std::size_t count = 0;
    int dimension = 0;
    double mean = 0.0;        ///< of the finite values, divided by the dimension: 1 is expected
    double lowerBound = 0.0;  ///< 95 % band of `mean` for independent samples
    double upperBound = 0.0;
    double median = 0.0;    ///< of the values
    double within68 = 0.0;  ///< share of the values below the 68 % point; so for 95 and 99
    double within95 = 0.0;
    double within99 = 0.0;
    /// What to multiply the covariance with so that the median is right: robust, because a few
    /// wrong associations must not decide. 1 is right, above 1: the filter claims too much.
    double covarianceScale = 1.0;
};

/// `values` of `dimension` degrees of freedom; those that are negative (a covariance that is none)
/// or not finite count as outside of all points. Nothing in it: count 0.
Consistency consistencyOf(const std::vector<double>& values, int dimension);

enum class Verdict
{
    TooFew,          ///< less than 30 values
    Consistent,      ///< the mean lies in its band, or within 20 % of 1, without a heavy tail
    Overconfident,   ///< errors are larger than the covariance says
    Underconfident,  ///< errors are smaller
    HeavyTailed      ///< most are as expected or smaller, more than 3 % are above the 99 % point
};

Verdict verdictOf(const Consistency& consistency);

/// One sentence for people, for example "overconfident: errors are 1.60 times as large as the
/// filter says; 12.0 % of the values lie above the 99 % point (expected 1 %)".
std::string inWords(const Consistency& consistency);

}  // namespace vdamf
