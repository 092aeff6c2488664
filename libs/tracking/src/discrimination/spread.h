// SPDX-License-Identifier: BSD-3-Clause
// Where many numbers lie: range, cells along an axis, quantiles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vdamf
{
struct FloatRange
{
    float min, max;
};

/// Of at least one number.
FloatRange rangeOf(const std::vector<float>& values);

/// The cell of each number along an axis; beyond its ends, the last one there.
std::vector<std::int32_t> cellNumbers(const std::vector<float>& values, float first, float perMetre,
                                      std::size_t cells);

/// How at least one number is spread, by counting in cells, which costs less than sorting.
class Spread
{
public:
    explicit Spread(const std::vector<float>& values);

    /// Lower edge of the cell with the value that this share of the others is below.
    double above(double share) const;
    /// Upper edge of the cell with the value that this share of the others is above.
    double below(double share) const;

private:
    static constexpr std::size_t kCells = 512;
    static constexpr std::size_t kBlock = 32;  // cells

    std::size_t rankOf(double share) const;
    std::size_t cellOf(std::size_t rank) const;

    std::array<std::uint16_t, kCells> counts_{};
    std::array<std::uint16_t, kCells / kBlock> blocks_{};
    std::size_t size_;
    float min_ = 0.0F;
    float max_ = 0.0F;
    float width_ = 0.0F;
    bool isCounted_ = false;
};

}  // namespace vdamf
