// SPDX-License-Identifier: BSD-3-Clause
// Descriptors two by two, each spread over knots: a linear classifier learns any course over the
// plane of two of them, such as how wide an object of some length may be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "discrimination/descriptors.h"

namespace vdamf
{
/// The features of two descriptors: one a pair of their knots, those of the second run fastest.
struct PairBlock
{
    std::string name;
    std::size_t size = 0;
};

/// In the order of the features: all pairs, then those of planar scans, which know no heights and
/// have weights of their own.
const std::vector<PairBlock>& pairBlocks();

/// Number of all of them.
std::size_t pairFeatureCount();

/// Adds an object's to `features`, pairFeatureCount() zeros.
void putPairs(const Descriptors& descriptors, bool planar, float* features);

/// Their sum with such weights, but for rounding of the features.
double pairScore(const Descriptors& descriptors, bool planar, const double* weights);

}  // namespace vdamf
