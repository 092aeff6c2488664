// SPDX-License-Identifier: BSD-3-Clause
// The matched filter's response for optimisations: the same as match_response.h in single
// precision, many hits at a time, on whatever x86-64 processor it runs.
#pragma once

#include <array>
#include <vector>

#include "vdamf/tracking/matched_filter/match_response.h"

namespace vdamf
{
/// Hits laid out for the kernel: in blocks, relative to an origin near the boxes to come, so that
/// single precision resolves a micrometre there. Weight 0 fills the last block.
struct KernelHits
{
    struct Block
    {
        static constexpr int kHits = 16;
        std::array<float, kHits> x{};  ///< m
        std::array<float, kHits> y{};  ///< m
        std::array<float, kHits> weight{};
    };
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    std::vector<Block> blocks;
};

KernelHits kernelHits(const Hits& hits, const Eigen::Vector2d& origin);

/// Instruction sets that the kernel is built for.
enum class KernelPath
{
    Baseline,  ///< whatever the compiler may assume anyway
    Avx2,      ///< with FMA
    Avx512
};

/// Those that this processor runs, the fastest one last.
std::vector<KernelPath> kernelPaths();

/// M with gradient and Hessian, within 1e-5 of the sum of the hits' absolute contributions for a
/// car; the error grows with the ratio of the box to the filter's sigma. The hits are summed in
/// single precision in runs of 256, all else is double. 150 ns a hit become 3 to 20 (benchmarks/
/// matched_filter.cpp).
MatchResponse kernelResponse(const KernelHits& hits, const FilterShape& shape,
                             const OrientedBox& box, double phi, KernelPath path);

/// The same on the fastest path.
MatchResponse kernelResponse(const KernelHits& hits, const FilterShape& shape,
                             const OrientedBox& box, double phi);

}  // namespace vdamf
