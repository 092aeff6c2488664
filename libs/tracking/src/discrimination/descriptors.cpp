// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/descriptors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "discrimination/spread.h"
#include "types/lanes.h"
#include "types/wide_lanes.h"

namespace vdamf
{
namespace
{
constexpr float kWindows = 0.95F;  // height of their lower edge, m

/// Mean distance of the lowest and the highest hit over half a metre square.
double columnsOf(const CanonicalHits& hits)
{
    constexpr float kPerMetre = 2.0F;
    constexpr float kBefore = 2.25F;  // m, so that the near faces lie in the middle of squares
    constexpr std::size_t kAlong = 48;
    constexpr std::size_t kAcross = 16;
    constexpr float kNone = 1e9F;
    const std::vector<std::int32_t> along = cellNumbers(hits.x, -kBefore, kPerMetre, kAlong);
    const std::vector<std::int32_t> across = cellNumbers(hits.y, -kBefore, kPerMetre, kAcross);
    // Squares of other x have no hits.
    const auto [least, greatest] = std::minmax_element(along.begin(), along.end());
    const std::size_t first = static_cast<std::size_t>(*least) * kAcross;
    const std::size_t end = static_cast<std::size_t>(*greatest + 1) * kAcross;
    std::array<float, kAlong * kAcross> low;
    std::array<float, kAlong * kAcross> high;
    std::fill(low.data() + first, low.data() + end, kNone);
    std::fill(high.data() + first, high.data() + end, -kNone);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const auto cell =
            static_cast<std::size_t>(along[i]) * kAcross + static_cast<std::size_t>(across[i]);
        low[cell] = std::min(low[cell], hits.z[i]);
        high[cell] = std::max(high[cell], hits.z[i]);
    }
    double sum = 0.0;
    double columns = 0.0;
    for (std::size_t cell = first; cell < end; ++cell)
    {
        if (high[cell] < low[cell]) continue;
        sum += static_cast<double>(high[cell] - low[cell]);
        columns += 1.0;
    }
    return sum / std::max(1.0, columns);
}

/// Mean and scatter of some numbers.
struct Moments
{
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;

    /// Sum of the squared distances from the mean.
    double scatter() const
    {
        return count > 0.0 ? std::max(0.0, squares - sum * sum / count) : 0.0;
    }
};

/// Of hits below the windows, or of all.
struct LowSums
{
    Moments fromSide, fromEnd;  // of those that are nearer to the one than to the other
    double depth = 0.0;         // m, to the nearer one
    double near = 0.0;
};

LowSums lowSums(const CanonicalHits& hits, float highest)
{
    constexpr float kNear = 0.15F;  // m
    LowSums sums;
    inWideLanes([
        highest, px = hits.x.data(), py = hits.y.data(), pz = hits.z.data(), size = hits.size(),
        result = &sums
    ]() __attribute__((always_inline)) {
        Floats sides{}, side{}, side2{}, ends{}, end{}, end2{}, depth{}, near{};
        const auto add = [&](std::size_t first, std::size_t count) __attribute__((always_inline))
        {
            Floats x, y, z;
            load(x, px + first, count);
            load(y, py + first, count);
            load(z, pz + first, count);
            const Floats one = (z <= highest) & (kLaneNumbers < static_cast<float>(count))
                                   ? Floats{} + 1.0F
                                   : Floats{};
            const Floats far = x < 0.0F ? -x : x;
            const Floats aside = y < 0.0F ? -y : y;
            const Floats isSide = aside < far ? one : Floats{};
            const Floats isEnd = one - isSide;
            const Floats nearest = aside < far ? aside : far;
            sides += isSide;
            side += isSide * y;
            side2 += isSide * (y * y);
            ends += isEnd;
            end += isEnd * x;
            end2 += isEnd * (x * x);
            depth += one * nearest;
            near += nearest < kNear ? one : Floats{};
        };
        inGroupsOf<kLanes<Floats>>(size, add);
        *result = {{sumOf(sides), sumOf(side), sumOf(side2)},
                   {sumOf(ends), sumOf(end), sumOf(end2)},
                   sumOf(depth),
                   sumOf(near)};
    });
    return sums;
}

std::optional<Descriptors::LowHits> lowHitsOf(const CanonicalHits& hits, bool planar)
{
    constexpr double kFewest = 4.0;
    const LowSums low = lowSums(hits, planar ? std::numeric_limits<float>::max() : kWindows);
    const double count = low.fromSide.count + low.fromEnd.count;
    if (count < kFewest) return std::nullopt;
    return Descriptors::LowHits{low.depth / count, low.near / count,
                                std::sqrt((low.fromSide.scatter() + low.fromEnd.scatter()) / count),
                                low.fromSide.count / count};
}

/// Extent along y of the hits at some height; nothing where there are not two of them.
std::optional<double> widthOf(const CanonicalHits& hits, float from, float to)
{
    float min = std::numeric_limits<float>::infinity();
    float max = -min;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (hits.z[i] < from || hits.z[i] >= to) continue;
        min = std::min(min, hits.y[i]);
        max = std::max(max, hits.y[i]);
    }
    if (!(min < max)) return std::nullopt;
    return static_cast<double>(max - min);
}

/// Hits of the object beside those that a closed surface of its extent would have if the frame's
/// hits were spread evenly over the directions that the sensor looks in.
double densityOf(const Descriptors& d, const CanonicalHits& hits, const ObjectView& view)
{
    constexpr double kSolidAngle = 3.0;   // of a spinning multi-beam sensor, sr
    constexpr double kLeastExtent = 0.1;  // m
    const double range = std::max(1.0, hits.sensor.norm());
    const Eigen::Vector2d towards = hits.sensor.normalized().cwiseAbs();
    const double across =
        std::max(kLeastExtent, d.length * towards.y() + d.width * towards.x()) / range;
    const double up = std::max(kLeastExtent, d.top - d.bottom) / range;
    const double share = view.planar ? across / (2.0 * kPi) : across * up / kSolidAngle;
    const double expected = static_cast<double>(view.frameHits) * share;
    return std::log2(static_cast<double>(hits.count) / std::max(1e-3, expected));
}

/// Shares of the hits that are before, behind and above what the box and cars hold.
void countOutside(Descriptors& d, const CanonicalHits& hits, const OrientedBox& box)
{
    constexpr float kBefore = -0.15F;   // m
    constexpr double kBehind = 0.3;     // m
    constexpr float kAboveCars = 2.0F;  // m
    std::array<std::int32_t, 3> counts{};
    inWideLanes([
        farX = static_cast<float>(box.length + kBehind),
        farY = static_cast<float>(box.width + kBehind), x = hits.x.data(), y = hits.y.data(),
        z = hits.z.data(), size = hits.size(), result = &counts
    ]() __attribute__((always_inline)) {
        std::int32_t before = 0;
        std::int32_t behind = 0;
        std::int32_t high = 0;
        for (std::size_t i = 0; i < size; ++i)
        {
            before += (x[i] < kBefore) | (y[i] < kBefore) ? 1 : 0;
            behind += (x[i] > farX) | (y[i] > farY) ? 1 : 0;
            high += z[i] > kAboveCars ? 1 : 0;
        }
        *result = {before, behind, high};
    });
    const double share = 1.0 / static_cast<double>(hits.size());
    d.outside = share * counts[0];
    d.beyond = share * counts[1];
    d.high = share * counts[2];
}
}  // namespace

Descriptors describe(const CanonicalHits& hits, const ObjectView& view)
{
    constexpr double kEnd = 0.02;  // share of the hits at either end that do not count
    const Spread x(hits.x);
    const Spread y(hits.y);
    const Spread z(hits.z);
    Descriptors d;
    d.length = x.below(kEnd) - x.above(kEnd);
    d.width = y.below(kEnd) - y.above(kEnd);
    d.top = z.below(kEnd);
    d.bottom = z.above(kEnd);
    d.shoulder = z.above(0.85);
    d.middle = z.above(0.5);
    d.columns = columnsOf(hits);
    countOutside(d, hits, view.box);
    d.silhouette = silhouetteOf(hits, view.planar);
    d.flatness = flatnessOf(hits);
    if (!view.planar) d.profile = heightProfileOf(hits);
    d.lowWidth = widthOf(hits, 0.0F, kWindows);
    d.highWidth = widthOf(hits, kWindows, std::numeric_limits<float>::infinity());
    d.density = densityOf(d, hits, view);
    d.bearing = std::atan2(std::abs(hits.sensor.y()), std::abs(hits.sensor.x()));
    d.match = view.match;
    d.low = lowHitsOf(hits, view.planar);
    return d;
}

}  // namespace vdamf
