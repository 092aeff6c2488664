// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/match_kernel.h"

#include <cmath>

// Registers wider than the baseline's pass between functions here. All of them are inlined, so no
// calling convention takes part.
#pragma GCC diagnostic ignored "-Wpsabi"
#include "matched_filter/kernel_sums.h"
#include "matched_filter/match_sums.h"

namespace vdamf
{
namespace
{
using SumFunction = KernelSums<double> (*)(const KernelHits&, const KernelFilter&);

KernelSums<double> sumsBaseline(const KernelHits& hits, const KernelFilter& filter)
{
    return kernelSums<4>(hits, filter);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] KernelSums<double> sumsAvx2(const KernelHits& hits,
                                                        const KernelFilter& filter)
{
    return kernelSums<8>(hits, filter);
}

[[gnu::target("avx512f")]] KernelSums<double> sumsAvx512(const KernelHits& hits,
                                                         const KernelFilter& filter)
{
    return kernelSums<16>(hits, filter);
}
#endif

SumFunction sumFunction([[maybe_unused]] KernelPath path)
{
#if defined(__x86_64__)
    if (path == KernelPath::Avx2) return sumsAvx2;
    if (path == KernelPath::Avx512) return sumsAvx512;
#endif
    return sumsBaseline;
}

KernelFilter kernelFilter(const FilterRegions& regions, const OrientedBox& box, double unit,
                          const Eigen::Vector2d& origin)
{
    const bool front = regions.edgesX[2].slope > 0.0;
    const bool left = regions.edgesY[2].slope > 0.0;
    const double sign = front == left ? 1.0 : -1.0;
    const std::size_t lower = regions.c[2] < regions.c[3] ? 2 : 3;
    const auto heights = [&](const std::array<double, FilterRegions::kRegions>& c)
    {
        const auto height = [&](std::size_t k) { return static_cast<float>(sign * c[k]); };
        return KernelFilter::Heights{height(0), height(1), height(2), height(3), height(lower)};
    };
    KernelFilter filter{};
    for (std::size_t k = 0; k < 5; ++k)
    {
        const RegionEdge& ex = regions.edgesX[front ? k : 4 - k];
        const RegionEdge& ey = regions.edgesY[left ? k : 4 - k];
        filter.edgesX[k] = static_cast<float>((ex.slope * box.length + ex.offset) / unit);
        filter.edgesY[k] = static_cast<float>((ey.slope * box.width + ey.offset) / unit);
    }
    filter.c = heights(regions.c);
    filter.c1 = heights(regions.c1);
    filter.c2 = heights(regions.c2);
    const Eigen::Matrix2d turn = rotation(-box.heading) / unit;
    const Eigen::Vector2d offset = turn * (origin - box.centre());
    for (int k = 0; k < 2; ++k)
    {
        auto& row = k == 0 ? filter.toBoxX : filter.toBoxY;
        row = {static_cast<float>(turn(k, 0)), static_cast<float>(turn(k, 1)),
               static_cast<float>(offset(k))};
    }
    return filter;
}

// The derivatives back in the units of MatchResponse.
MatchSums inMetres(const KernelSums<double>& s, const FilterRegions& regions, double unit)
{
    // With its length a box's edges move by half of it each, the visible one to its own side.
    Vector5d u = Vector5d::Constant(1.0 / unit);
    u(2) = 1.0;
    u(3) *= regions.edgesX[2].slope;
    u(4) *= regions.edgesY[2].slope;
    const auto& g = s.first;
    const auto& h = s.second;
    MatchSums sums;
    sums.f = g[0];
    sums.g << g[1], g[2], g[3], g[4], g[5];
    sums.g = sums.g.cwiseProduct(u).eval();
    sums.h << h[0], h[1], h[3], h[6], h[7],  //
        h[1], h[2], h[4], h[8], h[9],        //
        h[3], h[4], h[5], h[10], h[11],      //
        h[6], h[8], h[10], h[0], h[12],      //
        h[7], h[9], h[11], h[12], h[2];
    sums.h = (u.asDiagonal() * sums.h * u.asDiagonal()).eval();
    return sums;
}
}  // namespace

KernelHits kernelHits(const Hits& hits, const Eigen::Vector2d& origin)
{
    constexpr std::size_t kSize = KernelHits::Block::kHits;
    KernelHits k;
    k.origin = origin;
    k.blocks.resize((hits.size() + kSize - 1) / kSize);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        KernelHits::Block& block = k.blocks[i / kSize];
        block.x[i % kSize] = static_cast<float>(hits.x[i] - origin.x());
        block.y[i % kSize] = static_cast<float>(hits.y[i] - origin.y());
        block.weight[i % kSize] = static_cast<float>(hits.weight[i]);
    }
    return k;
}

std::vector<KernelPath> kernelPaths()
{
    std::vector<KernelPath> paths{KernelPath::Baseline};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        paths.push_back(KernelPath::Avx2);
    if (__builtin_cpu_supports("avx512f")) paths.push_back(KernelPath::Avx512);
#endif
    return paths;
}

MatchResponse kernelResponse(const KernelHits& hits, const FilterShape& shape,
                             const OrientedBox& box, double phi, KernelPath path)
{
    const double unit = shape.sigma * kHalvingLength;
    const FilterRegions regions(shape, box.heading - phi);
    const KernelFilter filter = kernelFilter(regions, box, unit, hits.origin);
    const KernelSums<double> sums = sumFunction(path)(hits, filter);
    return normalised(inMetres(sums, regions, unit), Normalisation(regions, box));
}

MatchResponse kernelResponse(const KernelHits& hits, const FilterShape& shape,
                             const OrientedBox& box, double phi)
{
    static const KernelPath fastest = kernelPaths().back();
    return kernelResponse(hits, shape, box, phi, fastest);
}

}  // namespace vdamf
