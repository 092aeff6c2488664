// SPDX-License-Identifier: BSD-3-Clause
// Descriptors two by two, each spread over knots: a linear classifier learns any course over the
// plane of two of them, such as how wide an object of some length may be.
#pragma once

#include <array>
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

/// Where two descriptors lie between their knots: shares of the four pairs of knots around.
struct PairValue
{
    std::size_t first = 0;    ///< feature of the pair of lower knots
    std::size_t rowSize = 0;  ///< knots of the second descriptor
    std::array<float, 4> value{};

    std::size_t feature(std::size_t k) const { return first + (k / 2) * rowSize + k % 2; }
};

/// An object's pairs, of the descriptors that it has.
std::vector<PairValue> pairsOf(const Descriptors& descriptors, bool planar);

}  // namespace vdamf
