// SPDX-License-Identifier: BSD-3-Clause
#include "matched_filter/line_sums.h"

// Registers wider than the baseline's pass between functions here. All of them are inlined, so no
// calling convention takes part.
#pragma GCC diagnostic ignored "-Wpsabi"
#include "matched_filter/kernel_sums.h"

namespace vdamf
{
namespace
{
// exp(-u) by its limit (1 - u / 16)^16, in a tenth of the time: a little narrower, and nothing
// beyond five and a half of its widths.
template <class Real>
[[gnu::always_inline]] inline Real welsch(const Real& u)
{
    const Real falling = 1.0F - u * (1.0F / 16.0F);
    const Real base = falling > 0.0F ? falling : Real{};
    const Real square = base * base;
    const Real fourth = square * square;
    const Real eighth = fourth * fourth;
    return eighth * eighth;
}

template <int kWidth>
[[gnu::always_inline]] inline LineSums sumsOf(const NearFace& face, const LineState& line)
{
    using Real = typename Lanes<kWidth>::Real;
    const auto slope = static_cast<float>(face.slope);
    const auto turn = static_cast<float>(line.turn);
    const auto place = static_cast<float>(line.place);
    const auto inside = static_cast<float>(line.weights.inside);
    const auto perWidth =
        static_cast<float>(1.0 / (2.0 * kLineTuning * kLineTuning * line.sigma * line.sigma));
    Real w{}, wa{}, waa{}, wr{}, war{}, squares{}, count{};
    for (const FaceHits::Block& block : face.hits.blocks)
        for (int k = 0; k < FaceHits::Block::kHits; k += kWidth)
        {
            const Real a = slope * lanesFrom<kWidth>(block.along.data() + k);
            const Real r = lanesFrom<kWidth>(block.outwards.data() + k) + turn * a - place;
            const Real even =
                lanesFrom<kWidth>(block.weight.data() + k) * welsch<Real>(r * r * perWidth);
            const Real keep = r < 0.0F ? inside * even : even;
            w += keep;
            wa += keep * a;
            waa += keep * a * a;
            wr += keep * r;
            war += keep * a * r;
            squares += even * (r * r + lanesFrom<kWidth>(block.spread.data() + k));
            count += even;
        }
    return {laneSum<kWidth>(w),       laneSum<kWidth>(wa),   laneSum<kWidth>(waa),  //
            laneSum<kWidth>(wr),      laneSum<kWidth>(war),                         //
            laneSum<kWidth>(squares), laneSum<kWidth>(count)};
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] LineSums sumsAvx2(const NearFace& face, const LineState& line)
{
    return sumsOf<8>(face, line);
}

[[gnu::target("avx512f")]] LineSums sumsAvx512(const NearFace& face, const LineState& line)
{
    return sumsOf<16>(face, line);
}
#endif
}  // namespace

LineSums lineSums(const NearFace& face, const LineState& line, [[maybe_unused]] KernelPath path)
{
#if defined(__x86_64__)
    if (path == KernelPath::Avx512) return sumsAvx512(face, line);
    if (path == KernelPath::Avx2) return sumsAvx2(face, line);
#endif
    return sumsOf<4>(face, line);
}

LineSums lineSums(const NearFace& face, const LineState& line)
{
    static const KernelPath fastest = kernelPaths().back();
    return lineSums(face, line, fastest);
}

}  // namespace vdamf
