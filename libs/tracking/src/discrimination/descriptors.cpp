// SPDX-License-Identifier: BSD-3-Clause
#include "discrimination/descriptors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vdamf
{
namespace
{
constexpr float kWindows = 0.95F;  // height of their lower edge, m

/// How some numbers are spread, by counting in cells, which costs less than sorting.
class Spread
{
public:
    explicit Spread(const std::vector<float>& values) : size_(values.size())
    {
        const auto [min, max] = std::minmax_element(values.begin(), values.end());
        min_ = *min;
        max_ = *max;
        width_ = (max_ - min_) / static_cast<float>(kCells - 1);
        // Else they are all but equal, or so far apart that cells overflow.
        isCounted_ = width_ > 1e-6F && width_ < 1e6F;
        if (!isCounted_) return;
        const float perMetre = 1.0F / width_;
        for (const float v : values)
        {
            const auto cell = static_cast<std::size_t>((v - min_) * perMetre);
            const std::size_t within = std::min(kCells - 1, cell);
            ++counts_[within];
            ++blocks_[within / kBlock];
        }
    }

    float min() const { return min_; }
    float max() const { return max_; }

    /// Lower edge of the cell with the value that this share of the others is below.
    double above(double share) const
    {
        if (!isCounted_) return min_;
        return min_ + width_ * static_cast<float>(cellOf(rankOf(share)));
    }

    /// Upper edge of the cell with the value that this share of the others is above.
    double below(double share) const
    {
        if (!isCounted_) return max_;
        const std::size_t cell = cellOf(size_ - 1 - rankOf(share));
        return std::min(max_, min_ + width_ * static_cast<float>(cell + 1));
    }

private:
    static constexpr std::size_t kCells = 512;
    static constexpr std::size_t kBlock = 32;  // cells

    std::size_t rankOf(double share) const
    {
        return static_cast<std::size_t>(share * static_cast<double>(size_));
    }
    /// Of the value with so many before it.
    std::size_t cellOf(std::size_t rank) const
    {
        std::size_t before = 0;
        std::size_t block = 0;
        while (before + blocks_[block] <= rank) before += blocks_[block++];
        std::size_t cell = block * kBlock;
        while (before + counts_[cell] <= rank) before += counts_[cell++];
        return cell;
    }

    std::array<std::uint16_t, kCells> counts_{};
    std::array<std::uint16_t, kCells / kBlock> blocks_{};
    std::size_t size_;
    float min_ = 0.0F;
    float max_ = 0.0F;
    float width_ = 0.0F;
    bool isCounted_ = false;
};

/// Mean distance of the lowest and the highest hit over half a metre square.
double columnsOf(const CanonicalHits& hits, float least, float greatest)
{
    constexpr float kPerMetre = 2.0F;
    constexpr float kBefore = 2.25F;  // m, so that the near faces lie in the middle of squares
    constexpr std::size_t kAlong = 48;
    constexpr std::size_t kAcross = 16;
    constexpr float kNone = 1e9F;
    const auto cellOf = [](float value, std::size_t cells)
    {
        return static_cast<std::size_t>(
            std::clamp((value + kBefore) * kPerMetre, 0.0F, static_cast<float>(cells - 1)));
    };
    // Squares of other x have no hits.
    const std::size_t first = cellOf(least, kAlong) * kAcross;
    const std::size_t end = (cellOf(greatest, kAlong) + 1) * kAcross;
    std::array<float, kAlong * kAcross> low;
    std::array<float, kAlong * kAcross> high;
    std::fill(low.begin() + first, low.begin() + end, kNone);
    std::fill(high.begin() + first, high.begin() + end, -kNone);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        const std::size_t cell = cellOf(hits.x[i], kAlong) * kAcross + cellOf(hits.y[i], kAcross);
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
    constexpr float kNear = 0.15F;  // m
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
    const auto farX = static_cast<float>(box.length + kBehind);
    const auto farY = static_cast<float>(box.width + kBehind);
    const double share = 1.0 / static_cast<double>(hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
        d.outside += hits.x[i] < kBefore || hits.y[i] < kBefore ? share : 0.0;
        d.beyond += hits.x[i] > farX || hits.y[i] > farY ? share : 0.0;
        d.high += hits.z[i] > kAboveCars ? share : 0.0;
    }
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
    d.columns = columnsOf(hits, x.min(), x.max());
    countOutside(d, hits, view.box);
    d.silhouette = silhouetteOf(hits, view.planar);
    d.lowWidth = widthOf(hits, 0.0F, kWindows);
    d.highWidth = widthOf(hits, kWindows, std::numeric_limits<float>::infinity());
    d.density = densityOf(d, hits, view);
    d.bearing = std::atan2(std::abs(hits.sensor.y()), std::abs(hits.sensor.x()));
    d.match = view.match;
    d.low = lowHitsOf(hits, view.planar);
    return d;
}

}  // namespace vdamf
