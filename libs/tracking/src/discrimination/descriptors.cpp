// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/descriptors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace vdamf
{
namespace
{
struct Interval
{
    double low = 0.0;
    double high = 0.0;
};

/// Where the values lie but for 2 % at either end: by counting in cells, which costs less than
/// sorting.
Interval bulkOf(const std::vector<float>& values)
{
    constexpr std::size_t kCells = 512;
    const auto [min, max] = std::minmax_element(values.begin(), values.end());
    const float width = (*max - *min) / static_cast<float>(kCells - 1);
    // Also where they are all but equal, or so far apart that cells overflow.
    if (!(width > 1e-6F && width < 1e6F)) return {*min, *max};
    std::array<std::uint16_t, kCells> counts{};
    const float perMetre = 1.0F / width;
    const float begin = *min;
    for (const float v : values)
    {
        const auto cell = static_cast<std::size_t>((v - begin) * perMetre);
        ++counts[std::min(kCells - 1, cell)];
    }
    const auto beyond = static_cast<std::size_t>(0.02 * static_cast<double>(values.size()));
    std::size_t first = 0;
    for (std::size_t n = counts[0]; n <= beyond; n += counts[first]) ++first;
    std::size_t last = kCells - 1;
    for (std::size_t n = counts[last]; n <= beyond; n += counts[last]) --last;
    return {*min + width * static_cast<float>(first),
            std::min(*max, *min + width * static_cast<float>(last + 1))};
}

/// Mean and scatter of some numbers.
struct Moments
{
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;

    void add(double value)
    {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    /// Sum of the squared distances from the mean.
    double scatter() const
    {
        return count > 0.0 ? std::max(0.0, squares - sum * sum / count) : 0.0;
    }
};

std::optional<Descriptors::LowHits> lowHitsOf(const CanonicalHits& hits, bool planar)
{
    constexpr float kWindows = 0.95F;  // m
    constexpr float kNear = 0.15F;     // m
    constexpr double kFewest = 4.0;
    Moments fromSide;
    Moments fromEnd;
    double depth = 0.0;
    double near = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        if (!planar && hits.z[i] > kWindows) continue;
        const float x = std::abs(hits.x[i]);
        const float y = std::abs(hits.y[i]);
        (y < x ? fromSide : fromEnd).add(y < x ? hits.y[i] : hits.x[i]);
        depth += std::min(x, y);
        near += std::min(x, y) < kNear ? 1.0 : 0.0;
    }
    const double count = fromSide.count + fromEnd.count;
    if (count < kFewest) return std::nullopt;
    return Descriptors::LowHits{depth / count, near / count,
                                std::sqrt((fromSide.scatter() + fromEnd.scatter()) / count),
                                fromSide.count / count};
}

struct Silhouette
{
    double breadth = 0.0;   ///< m
    double coverage = 0.0;  ///< 0..1
};

/// Hits across the line of sight in cells that are wider than the distance of two neighbouring rays
/// of usual sensors at usual ranges.
Silhouette silhouetteOf(const CanonicalHits& hits)
{
    constexpr std::size_t kCells = 128;
    constexpr float kCell = 0.25F;  // m
    constexpr float kLast = static_cast<float>(kCells - 1);
    const Eigen::Vector2f across =
        Eigen::Vector2f(-static_cast<float>(hits.sensor.y()), static_cast<float>(hits.sensor.x()))
            .normalized();
    std::vector<float> offsets;
    offsets.reserve(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
        offsets.push_back(across.x() * hits.x[i] + across.y() * hits.y[i]);
    const auto [min, max] = std::minmax_element(offsets.begin(), offsets.end());
    std::array<bool, kCells> hasHit{};
    const float first = *min;
    for (const float offset : offsets)
        hasHit[static_cast<std::size_t>(std::min(kLast, (offset - first) / kCell))] = true;
    const std::size_t cells = 1 + static_cast<std::size_t>(std::min(kLast, (*max - first) / kCell));
    const auto covered = std::count(hasHit.begin(), hasHit.end(), true);
    return {static_cast<double>(*max - first),
            static_cast<double>(covered) / static_cast<double>(cells)};
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
}  // namespace

Descriptors describe(const CanonicalHits& hits, const ObjectView& view)
{
    constexpr float kBefore = -0.15F;  // m
    const Interval x = bulkOf(hits.x);
    const Interval y = bulkOf(hits.y);
    const Interval z = bulkOf(hits.z);
    Descriptors d;
    d.length = x.high - x.low;
    d.width = y.high - y.low;
    d.top = z.high;
    d.bottom = z.low;
    constexpr float kAboveCars = 2.0F;  // m
    double before = 0.0;
    double high = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        before += hits.x[i] < kBefore || hits.y[i] < kBefore ? 1.0 : 0.0;
        high += hits.z[i] > kAboveCars ? 1.0 : 0.0;
    }
    d.outside = before / static_cast<double>(hits.size());
    d.high = high / static_cast<double>(hits.size());
    const Silhouette silhouette = silhouetteOf(hits);
    d.breadth = silhouette.breadth;
    d.coverage = silhouette.coverage;
    d.density = densityOf(d, hits, view);
    d.bearing = std::atan2(std::abs(hits.sensor.y()), std::abs(hits.sensor.x()));
    d.low = lowHitsOf(hits, view.planar);
    return d;
}

}  // namespace vdamf
