// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/height_profile.h"

#include <algorithm>
#include <cmath>

#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
std::optional<HeightBand> bandOf(const CanonicalHits& hits, float from, float to)
{
    constexpr double kFewest = 3.0;
    struct Sums
    {
        double count, x, xx, y, yy;
    } sums{};
    inWideLanes([
        from, to, px = hits.x.data(), py = hits.y.data(), pz = hits.z.data(), size = hits.size(),
        result = &sums
    ]() __attribute__((always_inline)) {
        Floats n{}, sx{}, sxx{}, sy{}, syy{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x, y, z;
            load(x, px + first, count);
            load(y, py + first, count);
            load(z, pz + first, count);
            const auto isIn = (z >= from) & (z < to) & (kLaneNumbers < static_cast<float>(count));
            const Floats none{};
            x = isIn ? x : none;
            y = isIn ? y : none;
            n += isIn ? none + 1.0F : none;
            sx += x;
            sxx += x * x;
            sy += y;
            syy += y * y;
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        *result = {sumOf(n), sumOf(sx), sumOf(sxx), sumOf(sy), sumOf(syy)};
    });
    if (sums.count < kFewest) return std::nullopt;
    const double x = sums.x / sums.count;
    const double y = sums.y / sums.count;
    return HeightBand{x, std::sqrt(std::max(0.0, sums.xx / sums.count - x * x)), y,
                      std::sqrt(std::max(0.0, sums.yy / sums.count - y * y))};
}
}  // namespace

HeightProfile heightProfileOf(const CanonicalHits& hits)
{
    return {bandOf(hits, 0.0F, 0.5F), bandOf(hits, 0.95F, 1.4F), bandOf(hits, 1.4F, 2.0F)};
}

}  // namespace vdamf
